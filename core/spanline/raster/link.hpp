#pragma once
#include <cstdint>
#include <limits>
#include <type_traits>

namespace spanline {

/// Numbers of polygons and vertices inside a frame: 16 bits on microcontrollers (65,534 polygons), 32 bits where
/// pointers have 64.
using Link = std::conditional_t<(sizeof(void*) > 4), std::uint32_t, std::uint16_t>;
inline constexpr Link no_link = std::numeric_limits<Link>::max();  ///< stands for no polygon or vertex

}  // namespace spanline
