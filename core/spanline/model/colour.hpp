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

/// A surface colour as authors give it, 8 bits a channel. Pixels are packed from it by a pixel format (pixel/).
struct Rgb888 {
  std::uint8_t red = 255;    ///< 0 … 255, all of it by default, as of the others
  std::uint8_t green = 255;  ///< 0 … 255
  std::uint8_t blue = 255;   ///< 0 … 255
  /// Whether all channels are equal.
  friend constexpr bool operator==(Rgb888, Rgb888) = default;
};

/// An RGB565 word, its channels widened to 8 bits: their highest bits repeat below.
[[nodiscard]] constexpr Rgb888 widened(std::uint16_t rgb565) {
  const unsigned red = rgb565 >> 11, green = (rgb565 >> 5) & 63u, blue = rgb565 & 31u;
  return {static_cast<std::uint8_t>(red << 3 | red >> 2), static_cast<std::uint8_t>(green << 2 | green >> 4),
          static_cast<std::uint8_t>(blue << 3 | blue >> 2)};
}

}  // namespace spanline
