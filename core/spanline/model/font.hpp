#pragma once
#include <cstdint>
#include <span>

namespace spanline {

/// A character of a bitmap font.
struct Glyph {
  std::uint16_t first;         ///< its first coverage value in the font's table, in values of 4 bits
  std::uint8_t width, height;  ///< of its bitmap, pixels
  std::int8_t left, top;       ///< from the pen to the bitmap's left column; from the baseline up to its top row
  std::uint8_t advance;        ///< from this pen position to the next, pixels
};

/// A proportional bitmap font as views over read-only tables, made by `spanline font`.
///
/// Coverage has 4 bits a pixel, 0 … 15, two in a byte with the left one in the low half; a bitmap's rows follow each
/// other without gaps.
struct Font {
  std::span<const Glyph> glyphs{};  ///< of characters `first_character` on, in the order of Unicode
  std::span<const std::uint8_t> coverage{};
  std::uint16_t first_character = 32;
  std::uint8_t ascent = 0, descent = 0;  ///< above and below the baseline, pixels
  std::uint8_t line_height = 0;          ///< from baseline to baseline, pixels

  /// The glyph of a character; that of the question mark where the font has none.
  [[nodiscard]] constexpr const Glyph& glyph(std::uint32_t character) const {
    const std::uint32_t index = character - first_character;
    return index < glyphs.size() ? glyphs[index] : glyphs['?' - first_character];
  }
  /// 0 … 15.
  [[nodiscard]] constexpr unsigned coverage_at(std::uint32_t index) const {
    return (unsigned{coverage[index / 2]} >> (index % 2 * 4)) & 15u;
  }
};

}  // namespace spanline
