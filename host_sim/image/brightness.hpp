#pragma once
#include <cstdint>

#include "spanline/model/colour.hpp"

namespace spanline::sim {

/// Luma of ITU-R BT.601, rounded: 0 … 255.
[[nodiscard]] constexpr std::uint8_t brightness(Rgb888 c) {
  return static_cast<std::uint8_t>((c.red * 299 + c.green * 587 + c.blue * 114 + 500) / 1000);
}

}  // namespace spanline::sim
