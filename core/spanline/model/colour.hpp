#pragma once
/// @file
/// Colours as authors give them.
///
/// ```cpp
/// constexpr Rgb888 orange{240, 160, 60};
/// static_assert(widened(0xffff) == Rgb888{255, 255, 255});
/// ```
#include <cstdint>

namespace spanline {

/// An RGB colour, 8 bits a channel. A pixel format (pixel/) packs it into pixels.
struct Rgb888 {
  std::uint8_t red = 255;    ///< 0 … 255; full by default, like the other channels
  std::uint8_t green = 255;  ///< 0 … 255
  std::uint8_t blue = 255;   ///< 0 … 255
  /// Whether all channels are equal.
  friend constexpr bool operator==(Rgb888, Rgb888) = default;
};

/// An RGB565 word as 8 bits a channel. The high bits of a channel are repeated as its new low bits.
[[nodiscard]] constexpr Rgb888 widened(std::uint16_t rgb565) {
  const unsigned red = rgb565 >> 11, green = (rgb565 >> 5) & 63u, blue = rgb565 & 31u;
  return {static_cast<std::uint8_t>(red << 3 | red >> 2), static_cast<std::uint8_t>(green << 2 | green >> 4),
          static_cast<std::uint8_t>(blue << 3 | blue >> 2)};
}

}  // namespace spanline
