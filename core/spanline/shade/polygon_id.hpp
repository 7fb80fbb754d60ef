#pragma once
#include "spanline/raster/polygon_corners.hpp"
#include "spanline/shade/light/flat.hpp"

namespace spanline {

/// Writes the id of the triangle that owns a pixel, for --ids-out, statistics and tests. It replaces the shader of
/// every shading mode.
struct IdShader {
  using Pixel = PolygonIds::Pixel;
  using Source = FlatShader<PolygonIds>::Source;
  using Surface = FlatShader<PolygonIds>::Surface;

  static constexpr bool interpolates = false;

  static void make(Surface& surface, const ShadingGroup& group, const PolygonCorners& polygon) {
    surface.pixel = 1 + group.first_id + polygon.triangle;
  }
};

}  // namespace spanline
