#pragma once
/// @file
/// Fonts, as `spanline font` makes them; a canvas writes with them.
///
/// ```cpp
/// static constexpr std::uint8_t coverage[] = {0xf0, 0x0f};  // two columns by two rows
/// static constexpr Glyph question[] = {{.first = 0, .width = 2, .height = 2, .left = 0, .top = 2, .advance = 3}};
/// constexpr Font font{.glyphs = question, .coverage = coverage, .first_character = '?', .line_height = 3};
/// static_assert(font.glyph('x').width == 2 && font.coverage_at(1) == 15);
/// ```
#include <cstdint>
#include <span>

namespace spanline {

/// A character of a bitmap font.
struct Glyph {
  std::uint16_t first;   ///< index of its first coverage value in the font's table, counted in values of 4 bits
  std::uint8_t width;    ///< of its bitmap, pixels
  std::uint8_t height;   ///< of its bitmap, pixels
  std::int8_t left;      ///< from the pen to the bitmap's left column, pixels to the right
  std::int8_t top;       ///< from the baseline to the bitmap's top row, pixels upwards
  std::uint8_t advance;  ///< from this pen position to the next, pixels
};

/// A proportional bitmap font as views over read-only tables, made by `spanline font`.
///
/// Coverage has 4 bits a pixel, 0 … 15; a byte holds two pixels, the left one in the low half. The rows of a bitmap
/// follow one another without padding.
struct Font {
  std::span<const Glyph> glyphs{};           ///< of the characters from `first_character` on, in the order of Unicode
  std::span<const std::uint8_t> coverage{};  ///< bitmaps, two pixels a byte
  std::uint16_t first_character = 32;        ///< Unicode number of the first glyph; 32, the space, by default
  std::uint8_t ascent = 0;                   ///< greatest height of a glyph above the baseline, pixels
  std::uint8_t descent = 0;                  ///< greatest depth of a glyph below the baseline, pixels
  std::uint8_t line_height = 0;              ///< from baseline to baseline, pixels

  /// The glyph of a character, or that of the question mark if the font has none for it.
  [[nodiscard]] constexpr const Glyph& glyph(std::uint32_t character) const {
    const std::uint32_t index = character - first_character;
    return index < glyphs.size() ? glyphs[index] : glyphs['?' - first_character];
  }
  /// A coverage value of the table: 0 (none) … 15 (the whole pixel).
  [[nodiscard]] constexpr unsigned coverage_at(std::uint32_t index) const {
    return (unsigned{coverage[index / 2]} >> (index % 2 * 4)) & 15u;
  }
};

}  // namespace spanline
