#pragma once
#include "spanline/raster/active_triangle.hpp"
#include "spanline/raster/fan_diagonals.hpp"
#include "spanline/raster/gradients.hpp"
#include "spanline/raster/make_surface.hpp"
#include "spanline/raster/plane_equation.hpp"
#include "spanline/raster/polygon_table.hpp"

namespace spanline {

/// The plane equation of an entry of the polygon table, whose corners these are. `outline` says whether it is one.
[[nodiscard, gnu::always_inline]] inline PlaneEquation plane_equation_of(const PolygonEntry& entry,
                                                                         const PolygonCorners& corners, bool outline,
                                                                         Viewport viewport) {
  const auto [a, b, c] = corners.corner;
  PlaneEquation plane(a, b, c, entry.group.vertices, viewport);
  if (outline) [[unlikely]] {
    if (entry.outline().header.size() != ActiveTriangle::Size::small) plane.extend();
  }
  return plane;
}

/// Makes a shader's surface for an entry of the polygon table, on row 0 of the picture, with columns counted from its
/// column 0. `outline` says whether the entry is one.
template <class Shader, class ShadingGroup>
[[gnu::always_inline]] inline void make_screen_surface(typename Shader::Surface& surface, const ShadingGroup& group,
                                                       const PolygonEntry& entry, bool outline, Viewport viewport) {
  const PolygonCorners corners = entry.corners();
  if constexpr (Shader::interpolates) {
    make_surface<Shader>(surface, group, corners, plane_equation_of(entry, corners, outline, viewport));
  } else {
    Shader::make(surface, group, corners);
    if constexpr (DividesOutlines<Shader>) {
      if (outline) Shader::divide(surface, FanDiagonals(entry.outline()), 0, 0);
    }
  }
}

}  // namespace spanline
