#pragma once
#include <cstdint>

#include "spanline/pixel/pixel_format.hpp"
#include "spanline/raster/fan_diagonals.hpp"
#include "spanline/raster/polygon_corners.hpp"
#include "spanline/shade/shading_group.hpp"

namespace spanline {

/// Writes the id of the triangle that owns a pixel, for --ids-out, statistics and tests. It replaces the shader of
/// every shading mode. It tells the triangles of an outline's fan apart by their diagonals.
struct IdShader {
  using Pixel = PolygonIds::Pixel;
  static constexpr bool interpolates = false;

  struct Surface;
  struct Source {
    static constexpr bool constant = false;
    const Surface* surface;
    std::int32_t column;
    [[nodiscard]] Pixel get() const;
    void forward() { ++column; }
    void back() { --column; }
  };

  struct Surface {
    Pixel first;            ///< the id of the polygon's first triangle
    FanDiagonals fan;       ///< of an outline; none otherwise
    std::int32_t row = 0;   ///< of the picture
    std::int32_t left = 0;  ///< column of the picture that the surface counts from

    void next_row() { ++row; }
    void skip_rows(std::int32_t rows) { row += rows; }
    [[nodiscard]] Source source(std::int32_t column) const { return {this, column}; }
  };

  static void make(Surface& surface, const ShadingGroup& group, const PolygonCorners& polygon) {
    surface.first = 1 + group.first_id + polygon.triangle;
    surface.fan.count = 0;
  }
  /// For an outline, after `make`: the surface is on `row` of the picture, and counts columns from `left`.
  static void divide(Surface& surface, const FanDiagonals& diagonals, std::int32_t left, std::int32_t row) {
    surface.fan = diagonals;
    surface.left = left;
    surface.row = row;
  }
};

inline IdShader::Pixel IdShader::Source::get() const {
  return surface->first + surface->fan.triangle_at(surface->left + column, surface->row);
}

}  // namespace spanline
