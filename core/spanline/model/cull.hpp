#pragma once
#include <cstdint>

namespace spanline {

/// Which polygons are left out by the sign of their area on screen. Front faces are counter-clockwise.
enum class Cull : std::uint8_t { back, front, none };

}  // namespace spanline
