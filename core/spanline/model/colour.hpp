#pragma once
#include <cstdint>

namespace spanline {

/// A surface colour as authors give it, 8 bits a channel. Pixels are packed from it by a pixel format (shade/).
struct Rgb888 {
  std::uint8_t red = 255, green = 255, blue = 255;
  friend constexpr bool operator==(Rgb888, Rgb888) = default;
};

}  // namespace spanline
