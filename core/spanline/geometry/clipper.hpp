#pragma once
#include <array>
#include <cstdint>

#include "spanline/geometry/view_space.hpp"
#include "spanline/raster/polygon_table.hpp"
#include "spanline/raster/vertex_shade.hpp"

namespace spanline {

/// A corner of a polygon that is being clipped.
struct ClipVertex {
  ViewPoint point;
  std::uint32_t shade;      ///< a vertex shade; interpolated with the point
  std::int32_t s, t;        ///< texture coordinates, 2^-20 textures; interpolated with the point
  Link original = no_link;  ///< the mesh vertex that it is, or no_link for a point made by clipping
  /// Whether its outcode says that it lies in the guard band. Neighbours that need no clipping go by the outcode, so
  /// clipping must as well, whatever rounding makes of a point on the very edge.
  bool in_guard_band = false;
};

/// A convex polygon that is being clipped: a triangle gains a corner a plane at most.
struct ClipPolygon {
  static constexpr unsigned planes = 6;
  std::array<ClipVertex, 3 + planes> vertex;
  unsigned count = 0;
};

/// Clips polygons in view space to the near and far planes and to the guard band, plane by plane (Sutherland and
/// Hodgman). An intersection is computed from the end of the edge that comes first in the order of coordinates, so that
/// polygons that share the edge get the same point.
class Clipper {
 public:
  Clipper() = default;
  Clipper(const FrameView& view, const ViewTransform& transform, vertex_shade::Kind shades);

  /// Clips in place; no corner is left where nothing lies inside.
  void clip(ClipPolygon& polygon) const;

 private:
  /// A half-space: x·point.x + y·point.y + z·point.z + constant ≥ 0, of components without their low bits.
  struct Plane {
    std::int32_t x, y, z;
    std::int64_t constant;
  };
  [[nodiscard]] std::int64_t distance(unsigned plane, const ViewPoint& point) const;
  [[nodiscard]] ClipVertex intersection(unsigned plane, const ClipVertex& a, std::int64_t distance_a,
                                        const ClipVertex& b, std::int64_t distance_b) const;

  std::int64_t near_ = 0, far_ = 0;
  Plane guard_[4] = {};
  vertex_shade::Kind shades_ = vertex_shade::Kind::intensity;
};

}  // namespace spanline
