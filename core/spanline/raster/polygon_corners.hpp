#pragma once
#include "spanline/raster/link.hpp"
#include "spanline/raster/screen_vertex.hpp"

namespace spanline {

/// The corners and numbers of a polygon of the polygon table.
struct PolygonCorners {
  const ScreenVertex* corner[3];
  Link triangle;  ///< triangle number within the group
  Link polygon;   ///< polygon number within the mesh
};

}  // namespace spanline
