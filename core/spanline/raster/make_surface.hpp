#pragma once
#include "spanline/raster/polygon_corners.hpp"

namespace spanline {

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
