#include "import/text_checks.hpp"

#include <algorithm>
#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace spanline::sim {
namespace {

std::uint32_t little_endian_u32(std::string_view bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

/// The last line of an OBJ file, if it lacks its end of line, must still be a whole vertex or face.
void check_obj(const std::string& content) {
  if (content.back() == '\n' || content.back() == '\r') return;
  const std::size_t start = content.find_last_of('\n');
  std::istringstream line(content.substr(start == std::string::npos ? 0 : start + 1));
  std::string keyword, field;
  line >> keyword;
  if (keyword != "v" && keyword != "f" && keyword != "vn") return;
  int fields = 0;
  while (line >> field) ++fields;
  if (fields < 3) throw std::runtime_error("is cut off in its last line");
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
  if (format == ModelFormat::ply && !content.starts_with("ply")) throw std::runtime_error("is not a PLY file");
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
