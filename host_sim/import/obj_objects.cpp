#include "import/obj_objects.hpp"

#include <algorithm>
#include <string_view>
#include <unordered_map>

namespace spanline::sim {
namespace {

constexpr std::string_view blanks = " \t\r\n\\";

std::string_view take_word(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
  const std::string_view word = line.substr(0, std::min(line.find_first_of(blanks), line.size()));
  line.remove_prefix(word.size());
  return word;
}

/// The rest of a line without the blanks around it.
std::string_view trimmed(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
  line.remove_suffix(line.size() - std::min(line.find_last_not_of(blanks) + 1, line.size()));
  return line;
}

/// Takes a line, with those that a backslash at its end joins to it.
std::string_view take_line(std::string_view& text) {
  std::size_t end = text.find('\n');
  while (end != std::string_view::npos) {
    const std::size_t before = end > 0 && text[end - 1] == '\r' ? end - 1 : end;
    if (before == 0 || text[before - 1] != '\\') break;
    end = text.find('\n', end + 1);
  }
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return line;
}

}  // namespace

std::vector<std::uint32_t> objects_of_obj(const std::string& content) {
  std::unordered_map<std::string_view, std::uint32_t> numbers;
  std::vector<std::uint32_t> objects;
  std::uint32_t current = 0;  // of faces before the first name
  for (std::string_view rest = content; !rest.empty();) {
    std::string_view line = take_line(rest);
    const std::string_view keyword = take_word(line);
    if (keyword == "o") {
      current = numbers.try_emplace(trimmed(line), static_cast<std::uint32_t>(numbers.size() + 1)).first->second;
    } else if (keyword == "f") {
      std::size_t corners = 0;
      while (!take_word(line).empty()) ++corners;
      if (corners > 2) objects.insert(objects.end(), corners - 2, current);
    }
  }
  const bool one = std::all_of(objects.begin(), objects.end(), [&](std::uint32_t o) { return o == objects.front(); });
  if (one) objects.clear();
  return objects;
}

}  // namespace spanline::sim
