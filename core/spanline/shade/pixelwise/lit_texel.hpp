#pragma once
#include <cstdint>

namespace spanline {

/// A colour, RGB565, and the light on it, 65535ths.
struct LitTexel {
  std::uint16_t rgb565;
  std::uint32_t light;
};

/// An RGB565 colour under a light in [0, 65535], channels rounded to nearest.
[[nodiscard]] constexpr std::uint16_t lit_rgb565(std::uint32_t rgb565, std::uint32_t light) {
  constexpr std::uint32_t half = 1u << 15;
  light += light >> 15;  // makes 65535, full light, 65536
  return static_cast<std::uint16_t>(((rgb565 >> 11) * light + half) >> 16 << 11 |
                                    (((rgb565 >> 5) & 63) * light + half) >> 16 << 5 |
                                    ((rgb565 & 31) * light + half) >> 16);
}

}  // namespace spanline
