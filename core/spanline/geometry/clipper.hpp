#pragma once
/// @file
/// Polygon clipping plane by plane, after I. Sutherland and G. Hodgman, "Reentrant Polygon Clipping" (1974).
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
  std::uint32_t shade;      ///< a vertex shade, interpolated with the point
  std::int32_t s, t, r;     ///< texture coordinates in units of 2^-20 textures, interpolated with the point
  Link original = no_link;  ///< number of the mesh vertex, or no_link for a point made by clipping
  /// Whether the vertex's outcode says that it lies in the guard band. Neighbouring polygons that are not clipped rely
  /// on the outcode, so clipping must agree with it where rounding puts a point at the edge outside.
  bool in_guard_band = false;
};

/// A convex polygon that is being clipped. It gains at most one corner at each plane, so a triangle always fits.
class ClipPolygon {
 public:
  static constexpr unsigned planes = 6;
  static constexpr unsigned most_corners = 3 + planes;

  [[nodiscard]] unsigned count() const { return count_; }
  [[nodiscard]] const ClipVertex& operator[](unsigned i) const { return corner_[order_[i]]; }
  /// Appends a corner, or leaves it out if there is no room. This cannot happen to triangles. One that rounding has
  /// made slightly non-convex loses a sliver.
  void append(const ClipVertex& corner);
  /// Whether a corner was left out.
  [[nodiscard]] bool overflowed() const { return overflowed_; }

 private:
  friend class Clipper;
  /// Corners keep their places while planes clip the polygon, so that it is never copied; `order_` lists the places in
  /// the order of the polygon. One place is spare, since a plane adds two corners before it removes one.
  std::array<ClipVertex, most_corners + 1> corner_;
  std::array<std::uint8_t, most_corners> order_{};
  std::uint16_t taken_ = 0;  ///< bit i: corner_[i] is in use
  std::uint8_t count_ = 0;
  bool overflowed_ = false;
};

/// Clips polygons in view space to the near and far planes and to the guard band, plane by plane. The intersection of
/// an edge is always computed from the end whose coordinates are lexicographically first, so that polygons that share
/// the edge get the same point.
class Clipper {
 public:
  Clipper() = default;
  Clipper(const FrameView& view, const ViewTransform& transform, vertex_shade::Kind shades);

  /// Clips a polygon in place. It has no corners afterwards if it lies outside.
  void clip(ClipPolygon& polygon) const;

 private:
  /// A half-space x·point.x + y·point.y + z·point.z + constant ≥ 0, where the low bits of the point's components are
  /// dropped.
  struct Plane {
    std::int32_t x, y, z;
    std::int64_t constant;
  };
  /// Distance of a point from a plane in a unit that depends on the plane; negative outside.
  [[nodiscard]] std::int64_t distance(unsigned plane, const ViewPoint& point) const;
  [[nodiscard]] ClipVertex intersection(unsigned plane, const ClipVertex& a, std::int64_t distance_a,
                                        const ClipVertex& b, std::int64_t distance_b) const;

  std::int64_t near_ = 0, far_ = 0;  ///< distances of the planes, view units
  Plane guard_[4] = {};              ///< left, right, top and bottom of the guard band
  vertex_shade::Kind shades_ = vertex_shade::Kind::intensity;
};

}  // namespace spanline
