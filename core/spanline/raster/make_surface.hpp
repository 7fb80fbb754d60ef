#pragma once
#include "spanline/raster/fan_diagonals.hpp"
#include "spanline/raster/polygon_corners.hpp"

namespace spanline {

/// A shader that tells the triangles of an outline's fan apart. `divide(surface, diagonals, left, row)` follows `make`
/// for an outline; the surface is stepped from row to row like one that interpolates.
template <class Shader>
concept DividesOutlines = requires(typename Shader::Surface& surface, const FanDiagonals& diagonals) {
  Shader::divide(surface, diagonals, 0, 0);
};

/// Makes a shader's surface for a polygon. The shader's `make` takes the polygon, its gradients, or both.
template <class Shader, class Group, class Gradients>
[[gnu::always_inline]] inline void make_surface(typename Shader::Surface& surface, const Group& group,
                                                const PolygonCorners& polygon, const Gradients& gradients) {
  if constexpr (!Shader::interpolates)
    Shader::make(surface, group, polygon);
  else if constexpr (requires { Shader::make(surface, group, polygon, gradients); })
    Shader::make(surface, group, polygon, gradients);
  else
    Shader::make(surface, group, gradients);
}

}  // namespace spanline
