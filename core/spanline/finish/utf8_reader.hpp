#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "spanline/model/font.hpp"

namespace spanline {

/// Reads the characters of a UTF-8 text. Each invalid byte counts as one question mark.
class Utf8Reader {
 public:
  explicit constexpr Utf8Reader(std::string_view text) : text_(text) {}
  [[nodiscard]] constexpr bool at_end() const { return position_ == text_.size(); }
  [[nodiscard]] constexpr std::uint32_t next() {
    const std::uint32_t first = byte(position_++);
    if (first < 0x80) return first;
    const unsigned more = first >= 0xf0 ? 3 : first >= 0xe0 ? 2 : 1;
    if (first < 0xc2 || first > 0xf4 || position_ + more > text_.size()) return '?';
    std::uint32_t character = first & (0x3fu >> more);
    for (unsigned i = 0; i < more; ++i) {
      const std::uint32_t following = byte(position_ + i);
      if ((following & 0xc0) != 0x80) return '?';
      character = character << 6 | (following & 0x3f);
    }
    position_ += more;
    return character;
  }

 private:
  [[nodiscard]] constexpr std::uint32_t byte(std::size_t i) const { return static_cast<unsigned char>(text_[i]); }
  std::string_view text_;
  std::size_t position_ = 0;
};

/// The width of a line of text, pixels.
[[nodiscard]] constexpr std::int32_t text_width(const Font& font, std::string_view text) {
  std::int32_t width = 0;
  for (Utf8Reader reader(text); !reader.at_end();) width += font.glyph(reader.next()).advance;
  return width;
}

}  // namespace spanline
