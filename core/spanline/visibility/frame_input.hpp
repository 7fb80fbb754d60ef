#pragma once
#include <cstdint>

#include "spanline/raster/gradients.hpp"
#include "spanline/raster/polygon_table.hpp"
#include "spanline/world/world.hpp"

namespace spanline {

/// What a visibility algorithm gets before the first band of a frame: enough to sort polygons, or to walk a tree.
struct FrameInput {
  const PolygonTable& table;  ///< all polygons of the frame
  Viewport viewport;          ///< pixels of the picture
  std::int32_t band_lines;    ///< lines of a band, but for the last one
  const World* world;         ///< where the frame lies in space; null for algorithms that take screen polygons alone
};

}  // namespace spanline
