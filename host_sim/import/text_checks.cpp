#include "import/text_checks.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <stdexcept>
#include <string_view>

#include "import/ply_check.hpp"

namespace spanline::sim {
namespace {

std::uint32_t little_endian_u32(std::string_view bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

std::string_view take_word(std::string_view& line) {
  constexpr std::string_view blanks = " \t\r";
  line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
  const std::string_view word = line.substr(0, std::min(line.find_first_of(blanks), line.size()));
  line.remove_prefix(word.size());
  return word;
}

bool is_number(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  // A number out of range is for the check of coordinates, which names it better.
  return !word.empty() && (error == std::errc{} || error == std::errc::result_out_of_range) &&
         end == word.data() + word.size();
}

/// The importer skips vertices that it cannot read, and every index behind them would name another vertex. A last line
/// without its end must still be a whole face.
void check_obj(const std::string& content) {
  std::size_t number = 0;
  for (std::size_t start = 0; start < content.size();) {
    const std::size_t end = std::min(content.find('\n', start), content.size());
    std::string_view line = std::string_view(content).substr(start, end - start);
    start = end + 1;
    ++number;
    if (line.find('\\') != std::string_view::npos) continue;  // goes on in the next line
    const std::string_view keyword = take_word(line);
    if (keyword == "v") {
      for (int i = 0; i < 3; ++i)
        if (!is_number(take_word(line)))
          throw std::runtime_error("has a vertex without three numbers in line " + std::to_string(number));
    }
    if (keyword == "f" && end == content.size()) {
      for (int i = 0; i < 3; ++i)
        if (take_word(line).empty()) throw std::runtime_error("is cut off in its last line");
    }
  }
}

/// A binary STL has 84 bytes of header and 50 a triangle; a text one ends in "endsolid".
void check_stl(const std::string& content) {
  constexpr std::size_t header = 84, triangle = 50;
  if (content.size() >= header) {
    const std::size_t expected = header + triangle * little_endian_u32(std::string_view(content).substr(80, 4));
    if (content.size() == expected) return;
    const bool text = content.starts_with("solid") && content.find("facet") != std::string::npos;
    if (!text && content.size() < expected)
      throw std::runtime_error("is cut off: fewer triangles than its header says");
    if (!text) return;
  }
  if (content.starts_with("solid") && content.find("endsolid") == std::string::npos)
    throw std::runtime_error("is cut off: 'endsolid' is missing");
}

/// A GLB header says how long the file is.
void check_glb(const std::string& content) {
  if (content.size() < 12 || !content.starts_with("glTF")) throw std::runtime_error("is not a GLB file");
  if (content.size() < little_endian_u32(std::string_view(content).substr(8, 4)))
    throw std::runtime_error("is cut off: shorter than its header says");
}

}  // namespace

void check_complete(ModelFormat format, const std::string& content) {
  if (format == ModelFormat::obj) check_obj(content);
  if (format == ModelFormat::stl) check_stl(content);
  if (format == ModelFormat::glb) check_glb(content);
  if (format == ModelFormat::ply) check_ply(content);
}

void blank_obj_groups(std::string& content) {
  const auto blank = [](char c) { return c == ' ' || c == '\t'; };
  for (std::size_t start = 0; start < content.size();) {
    const std::size_t end = std::min(content.find('\n', start), content.size());
    std::size_t word = start;
    while (word < end && blank(content[word])) ++word;
    const bool group = word < end && (content[word] == 'o' || content[word] == 'g') &&
                       (word + 1 == end || blank(content[word + 1]) || content[word + 1] == '\r');
    if (group)
      std::fill(content.begin() + static_cast<std::ptrdiff_t>(start),
                content.begin() + static_cast<std::ptrdiff_t>(end), ' ');
    start = end + 1;
  }
}

}  // namespace spanline::sim
