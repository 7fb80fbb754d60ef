#pragma once
#include <cstdint>

namespace spanline {

/// A surface colour as authors give it, 8 bits a channel. Pixels are packed from it by a pixel format (shade/).
struct Rgb888 {
  std::uint8_t red = 255, green = 255, blue = 255;
  friend constexpr bool operator==(Rgb888, Rgb888) = default;
};

/// An RGB565 word, its channels widened to 8 bits: their highest bits repeat below.
[[nodiscard]] constexpr Rgb888 widened(std::uint16_t rgb565) {
  const unsigned red = rgb565 >> 11, green = (rgb565 >> 5) & 63u, blue = rgb565 & 31u;
  return {static_cast<std::uint8_t>(red << 3 | red >> 2), static_cast<std::uint8_t>(green << 2 | green >> 4),
          static_cast<std::uint8_t>(blue << 3 | blue >> 2)};
}

}  // namespace spanline
