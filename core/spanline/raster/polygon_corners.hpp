#pragma once
#include "spanline/raster/link.hpp"
#include "spanline/raster/screen_vertex.hpp"

namespace spanline {

/// A polygon as found in the table.
struct PolygonCorners {
  const ScreenVertex* corner[3];
  Link triangle;  ///< triangle number within the group
  Link polygon;   ///< polygon number within the mesh
};

}  // namespace spanline
