#pragma once
#include <cstddef>

#include "scene/scene.hpp"

namespace spanline::sim {

/// Entries of the pools that depend on the camera.
struct FrameNeed {
  std::size_t polygons = 0;  ///< that face the eye
  std::size_t active = 0;    ///< that reach across a band's edge
};

/// The most that frames of 320×240 in bands of 16 lines take, with the whole model framed and seen from 24 sides. All
/// polygons are triangles here, since light that is not linear over larger ones has them drawn as fans. In meshes with
/// a table of corners, each of these triangles takes a record of the pool `fans`, too; polygons that are drawn whole
/// never take more.
[[nodiscard]] FrameNeed measure_need(Scene scene);

}  // namespace spanline::sim
