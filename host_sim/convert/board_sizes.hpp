#pragma once
#include <cstddef>

namespace spanline::sim::board {

/// Bytes that the renderer's pools take an entry on 32-bit boards, where links have 16 bits and pointers 32:
/// GouraudTraits with 16-bit depth. A test compiles the core for a Cortex-M3 and compares.
inline constexpr std::size_t instance = 228, vertex = 8, shade = 4, polygon = 4, fan = 10, active = 112;
/// A renderer for 320×240 in bands of 16 lines with two bands of colour, without any entry in these pools.
inline constexpr std::size_t bands_of_16 = 30759;
/// The object of type Mesh, in flash beside its tables.
inline constexpr std::size_t mesh_object = 112;

}  // namespace spanline::sim::board
