#include "import/ply_check.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

namespace spanline::sim {
namespace {

/// A property: a number, or a list with a count in front.
struct Property {
  std::size_t count_size = 0;  ///< bytes of a list's count; 0 for a number
  std::size_t value_size = 0;
};

struct Element {
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

enum class Encoding { ascii, little_endian, big_endian };

struct Header {
  Encoding encoding = Encoding::ascii;
  std::vector<Element> elements;
  std::size_t body = 0;  ///< where the first element starts
};

[[noreturn]] void broken_header() { throw std::runtime_error("has a broken PLY header"); }
[[noreturn]] void cut_off() { throw std::runtime_error("is cut off: fewer elements than its header says"); }

std::size_t type_size(const std::string& type) {
  constexpr std::array<std::pair<std::string_view, std::size_t>, 16> sizes{{{"char", 1},
                                                                            {"uchar", 1},
                                                                            {"int8", 1},
                                                                            {"uint8", 1},
                                                                            {"short", 2},
                                                                            {"ushort", 2},
                                                                            {"int16", 2},
                                                                            {"uint16", 2},
                                                                            {"int", 4},
                                                                            {"uint", 4},
                                                                            {"int32", 4},
                                                                            {"uint32", 4},
                                                                            {"float", 4},
                                                                            {"float32", 4},
                                                                            {"double", 8},
                                                                            {"float64", 8}}};
  const auto entry = std::find_if(sizes.begin(), sizes.end(), [&](const auto& e) { return e.first == type; });
  if (entry == sizes.end()) broken_header();
  return entry->second;
}

Encoding encoding_named(const std::string& name) {
  if (name == "ascii") return Encoding::ascii;
  if (name == "binary_little_endian") return Encoding::little_endian;
  if (name == "binary_big_endian") return Encoding::big_endian;
  broken_header();
}

Header read_header(const std::string& content) {
  Header header;
  for (std::size_t start = 0;;) {
    const std::size_t end = content.find('\n', start);
    if (end == std::string::npos) broken_header();
    std::istringstream line(content.substr(start, end - start));
    start = end + 1;
    std::string keyword, word;
    line >> keyword;
    if (keyword == "end_header") {
      header.body = start;
      return header;
    }
    if (keyword == "format" && line >> word) header.encoding = encoding_named(word);
    if (keyword == "element") {
      std::uint64_t count = 0;
      if (!(line >> word >> count)) broken_header();
      header.elements.push_back({count, {}});
    }
    if (keyword == "property") {
      std::string type, count_type;
      if (header.elements.empty() || !(line >> type)) broken_header();
      Property property;
      if (type == "list") {
        if (!(line >> count_type >> type)) broken_header();
        property.count_size = type_size(count_type);
      }
      property.value_size = type_size(type);
      header.elements.back().properties.push_back(property);
    }
  }
}

/// The words of a text body, one after the other.
class Words {
 public:
  explicit Words(std::string_view text) : rest_(text) {}
  std::string_view next() {
    constexpr std::string_view blanks = " \t\r\n";
    rest_.remove_prefix(std::min(rest_.find_first_not_of(blanks), rest_.size()));
    const std::size_t size = std::min(rest_.find_first_of(blanks), rest_.size());
    if (size == 0) cut_off();
    const std::string_view word = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return word;
  }
  void skip(std::uint64_t count) {
    while (count-- > 0) static_cast<void>(next());
  }

 private:
  std::string_view rest_;
};

std::uint64_t read_count(std::string_view word) {
  std::uint64_t count = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), count);
  if (error != std::errc{} || end != word.data() + word.size())
    throw std::runtime_error("has a list whose length is no number");
  return count;
}

void walk_text(const Header& header, const std::string& content) {
  Words words(std::string_view(content).substr(header.body));
  for (const Element& element : header.elements)
    for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i)
      for (const Property& property : element.properties)
        words.skip(property.count_size == 0 ? 1 : read_count(words.next()));
}

void walk_binary(const Header& header, const std::string& content) {
  std::size_t position = header.body;
  const auto take = [&](std::uint64_t size) {
    if (size > content.size() - position) cut_off();
    position += size;
  };
  const auto list_length = [&](std::size_t size) {
    const std::size_t start = position;
    take(size);
    std::uint64_t length = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const std::size_t place = header.encoding == Encoding::little_endian ? size - 1 - i : i;
      length = length << 8 | static_cast<unsigned char>(content[start + place]);
    }
    return std::min<std::uint64_t>(length, content.size());  // so that the product below cannot wrap
  };
  for (const Element& element : header.elements)
    for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i)
      for (const Property& property : element.properties)
        take(property.count_size == 0 ? property.value_size : list_length(property.count_size) * property.value_size);
}

}  // namespace

void check_ply(const std::string& content) {
  if (!content.starts_with("ply")) throw std::runtime_error("is not a PLY file");
  const Header header = read_header(content);
  if (header.encoding == Encoding::ascii)
    walk_text(header, content);
  else
    walk_binary(header, content);
}

}  // namespace spanline::sim
