#pragma once
#include <cstdint>

#include "spanline/raster/gradients.hpp"
#include "spanline/raster/polygon_table.hpp"
#include "spanline/world/world.hpp"

namespace spanline {

/// What a visibility algorithm gets before the first band of a frame.
struct FrameInput {
  const PolygonTable& table;  ///< all polygons of the frame
  Viewport viewport;          ///< size of the picture
  std::int32_t band_lines;    ///< lines of every band except the last, which may have fewer
  const World* world;  ///< camera and instances in world space; null for algorithms that need screen polygons alone
};

}  // namespace spanline
