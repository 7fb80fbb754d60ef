#pragma once
#include <cstdint>

namespace spanline {

/// The input that a visibility algorithm works on.
enum class AlgorithmNeeds : std::uint8_t {
  screen_polygons,  ///< the polygon table alone; its polygons may come from meshes or be given in screen coordinates
  world,            ///< also FrameInput::world, so polygons that are given in screen coordinates cannot be drawn
};

}  // namespace spanline
