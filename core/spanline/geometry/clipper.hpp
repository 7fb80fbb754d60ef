#pragma once
#include <array>
#include <cstdint>

#include "spanline/geometry/view_space.hpp"
#include "spanline/raster/link.hpp"
#include "spanline/raster/polygon_table.hpp"
#include "spanline/raster/vertex_shade.hpp"

namespace spanline {

/// A corner of a polygon that is being clipped.
struct ClipVertex {
  ViewPoint point;
  std::uint32_t shade;      ///< a vertex shade; interpolated with the point
  std::int32_t s, t, r;     ///< texture coordinates, 2^-20 textures; interpolated with the point
  Link original = no_link;  ///< the mesh vertex that it is, or no_link for a point made by clipping
  /// Whether its outcode says that it lies in the guard band. Neighbours that need no clipping go by the outcode, so
  /// clipping must as well, whatever rounding makes of a point on the very edge.
  bool in_guard_band = false;
};

/// A convex polygon that is being clipped: a triangle gains a corner a plane at most.
class ClipPolygon {
 public:
  static constexpr unsigned planes = 6;
  static constexpr unsigned most_corners = 3 + planes;

  [[nodiscard]] unsigned count() const { return count_; }
  [[nodiscard]] const ClipVertex& operator[](unsigned i) const { return corner_[order_[i]]; }
  /// Appends a corner. Where there is no room, it is left out: convex polygons never get there, and those that rounding
  /// made a little less than convex lose a sliver.
  void append(const ClipVertex& corner);

 private:
  friend class Clipper;
  /// Corners stay where they are while planes cut the polygon, so that no plane takes a copy of it: `order_` names them
  /// in turn. A plane needs its two new corners before it lets go of an old one.
  std::array<ClipVertex, most_corners + 1> corner_;
  std::array<std::uint8_t, most_corners> order_{};
  std::uint16_t taken_ = 0;  ///< bit i: corner_[i] is in use
  std::uint8_t count_ = 0;
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
