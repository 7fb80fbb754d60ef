#pragma once
#include "spanline/raster/link.hpp"
#include "spanline/raster/screen_vertex.hpp"

namespace spanline {

/// The corners and numbers of an entry of the polygon table: of a triangle, or of the reference triangle of an outline,
/// which gives the plane and the surface.
struct PolygonCorners {
  const ScreenVertex* corner[3];
  Link triangle;  ///< triangle number within the group; of an outline, that of its first triangle
  Link polygon;   ///< polygon number within the mesh
};

}  // namespace spanline
