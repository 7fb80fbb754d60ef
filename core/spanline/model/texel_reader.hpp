#pragma once
/// @file
/// Texels one by one, of any format.
///
/// ```cpp
/// constexpr std::uint16_t words[] = {0xffff, 0x0000, 0x0000, 0xffff};
/// const Texture checks{.log2_width = 1, .log2_height = 1, .words = words};
/// const Texel second = read_texel(checks, 1, 0);  // black, and alpha 15 since the format has none
/// ```
#include <cstddef>
#include <cstdint>

#include "spanline/model/texture.hpp"

namespace spanline {

/// A texel as colour and alpha, whatever the texture's format.
struct Texel {
  std::uint16_t rgb565;  ///< its colour
  std::uint8_t alpha;    ///< 0 … 15
};

/// Widens channels of 4 bits to RGB565 by repeating their upper bits.
[[nodiscard]] constexpr std::uint16_t rgb565_from_rgb444(std::uint32_t word) {
  const std::uint32_t red = (word >> 8) & 15, green = (word >> 4) & 15, blue = word & 15;
  return static_cast<std::uint16_t>((red << 1 | red >> 3) << 11 | (green << 2 | green >> 2) << 5 |
                                    (blue << 1 | blue >> 3));
}

/// Reads texel (x, y) of a level that begins at `offset` of the texture's table. The texture must be valid, of any
/// format, and x and y must lie inside the level.
[[nodiscard]] constexpr Texel read_texel(const Texture& texture, std::size_t offset, unsigned log2_width,
                                         std::uint32_t x, std::uint32_t y) {
  constexpr std::uint8_t opaque = 15;
  const std::size_t index = offset + (y << log2_width) + x;
  switch (texture.format) {
    case TexelFormat::rgb565:
      return {texture.words[index], opaque};
    case TexelFormat::rgb565_cutout:
      return {texture.words[index], (texture.words[index] & 0x20) != 0 ? opaque : std::uint8_t{0}};
    case TexelFormat::argb4444:
      return {rgb565_from_rgb444(texture.words[index]), static_cast<std::uint8_t>(texture.words[index] >> 12)};
    case TexelFormat::palette16: {
      const std::uint32_t row_bytes = ((1u << log2_width) + 1) / 2;
      return {texture.palette[(texture.bytes[offset + y * row_bytes + x / 2] >> (x % 2 * 4)) & 15], opaque};
    }
    case TexelFormat::palette256:
      return {texture.palette[texture.bytes[index]], opaque};
  }
  return {};
}

/// The same for level 0.
[[nodiscard]] constexpr Texel read_texel(const Texture& texture, std::uint32_t x, std::uint32_t y) {
  return read_texel(texture, 0, texture.log2_width, x, y);
}

}  // namespace spanline
