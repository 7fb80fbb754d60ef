#pragma once
#include <cstdint>

#include "spanline/model/texture.hpp"

namespace spanline {

/// A texel of any format.
struct Texel {
  std::uint16_t rgb565;
  std::uint8_t alpha;  ///< 0 … 15
};

/// Channels of 4 bits widened to RGB565 by repeating their upper bits.
[[nodiscard]] constexpr std::uint16_t rgb565_from_rgb444(std::uint32_t word) {
  const std::uint32_t red = (word >> 8) & 15, green = (word >> 4) & 15, blue = word & 15;
  return static_cast<std::uint16_t>((red << 1 | red >> 3) << 11 | (green << 2 | green >> 2) << 5 |
                                    (blue << 1 | blue >> 3));
}

/// Reads level 0 of a valid texture of any format; x and y inside it.
[[nodiscard]] constexpr Texel read_texel(const Texture& texture, std::uint32_t x, std::uint32_t y) {
  constexpr std::uint8_t opaque = 15;
  const std::uint32_t index = (y << texture.log2_width) + x;
  switch (texture.format) {
    case TexelFormat::rgb565:
      return {texture.words[index], opaque};
    case TexelFormat::rgb565_cutout:
      return {texture.words[index], (texture.words[index] & 0x20) != 0 ? opaque : std::uint8_t{0}};
    case TexelFormat::argb4444:
      return {rgb565_from_rgb444(texture.words[index]), static_cast<std::uint8_t>(texture.words[index] >> 12)};
    case TexelFormat::palette16: {
      const std::uint32_t row_bytes = ((1u << texture.log2_width) + 1) / 2;
      return {texture.palette[(texture.bytes[y * row_bytes + x / 2] >> (x % 2 * 4)) & 15], opaque};
    }
    case TexelFormat::palette256:
      return {texture.palette[texture.bytes[index]], opaque};
  }
  return {};
}

}  // namespace spanline
