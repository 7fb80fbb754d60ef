#pragma once
/// @file
/// The overlap tests of depth sort, after M. Newell, R. Newell and T. Sancha, "A Solution to the Hidden Surface
/// Problem" (1972), as lecture 002, "rearrange(P, Q)", and lecture 003, "Overlap Detection", state them.
#include <array>
#include <cstdint>

#include "spanline/raster/outline.hpp"
#include "spanline/raster/polygon_table.hpp"
#include "spanline/raster/screen_vertex.hpp"

namespace spanline {

/// A polygon of the polygon table as the overlap tests see it. Coordinates are sixteenths of a pixel, depths 24 bits
/// whatever the depth format, smaller is nearer.
struct TestedPolygon {
  std::array<const ScreenVertex*, Outline::most_corners> corner;
  unsigned count;
  unsigned reference;  ///< corners 0, `reference` and `reference` + 1 state the polygon's plane
  bool clockwise;      ///< on screen; known for outlines alone
  std::int32_t slack;  ///< how far the other corners' depths may lie from that plane

  [[nodiscard]] bool is_outline() const { return count > 3; }
  void set(const PolygonEntry& entry);
  void set(const PolygonCorners& triangle) {
    for (unsigned i = 0; i < 3; ++i) corner[i] = triangle.corner[i];
    count = 3;
    reference = 1;
    slack = 0;
  }
};

/// Where a polygon lies relative to another one's plane, as the eye sees it.
enum class PlaneSide : std::uint8_t {
  behind,    ///< all of it lies on the other side of the plane than the eye
  in_front,  ///< all of it lies on the eye's side
  mixed,     ///< neither, or too near to the plane to tell
};

/// Which side of `p`'s plane polygon `q` lies on. Depths of pixels may differ from the plane through the corners by
/// rounding; a corner decides only if it lies more than `doubt` units of 24 bits away from the plane. No division: the
/// depth times the plane's area is compared with its normal.
///
/// With P the polygon that is to be drawn first, four tests ask it: "all Q is on the opposite side of P from the eye"
/// (behind) and "all P is on the same side of Q as the eye" (in_front, with the polygons exchanged) keep their order;
/// the swapped ones, "all Q is on the same side of P as the eye" and "all P is on the opposite side of Q", exchange
/// them.
[[nodiscard]] PlaneSide side_of_plane(const TestedPolygon& q, const TestedPolygon& p, std::int32_t doubt);

/// The test "not overlap-projection(P, Q)", or rather its denial: false if a side of one of the polygons has the other
/// wholly beyond it. Then no pixel belongs to both: a pixel's centre on that side itself belongs to one of them at
/// most, by the top-left rule. True does not mean that there is such a pixel.
[[nodiscard]] bool projections_may_overlap(const TestedPolygon& p, const TestedPolygon& q);

/// A corner, relative to another one: sixteenths of a pixel, [−2^13, 2^13), and depth of 16 bits.
struct NarrowCorner {
  std::int32_t x, y, z;
};

/// The plane of a small triangle for the same test in words of 32 bits. Depths are rounded down to 16 bits, which the
/// test allows for: the corners' depths may be off by less than a unit each.
class NarrowPlane {
 public:
  NarrowPlane() = default;
  /// Through the origin and two other corners.
  NarrowPlane(const NarrowCorner& b, const NarrowCorner& c);
  /// As side_of_plane, for a triangle whose corners count from the plane's origin.
  [[nodiscard]] PlaneSide side_of(const std::array<NarrowCorner, 3>& triangle, std::int32_t doubt) const;

 private:
  std::int32_t normal_x_, normal_y_, area_;  ///< area · z = normal_x · x + normal_y · y; below 2^31, 2^31 and 2^27
  std::int32_t across_, along_;              ///< sums of the corners' |x| and |y|
};

/// A polygon that is tested against many: the tests with it as P, with what they need of it computed once.
class TestedFront {
 public:
  void set(const PolygonEntry& entry) {
    polygon_.set(entry);
    has_sides_ = has_normal_ = has_plane_ = false;
  }
  [[nodiscard]] const TestedPolygon& polygon() const { return polygon_; }

  /// As projections_may_overlap(polygon(), q).
  [[nodiscard]] bool projections_may_overlap(const TestedPolygon& q) const;
  /// The same for a triangle.
  [[nodiscard]] bool projections_may_overlap(const PolygonCorners& triangle);
  /// As side_of_plane(q, polygon(), doubt).
  [[nodiscard]] PlaneSide side_of(const TestedPolygon& q, std::int32_t doubt);
  /// Whether a triangle and this one are small and near to each other. If so, the two functions below may be asked.
  [[nodiscard]] bool is_narrow_with(const PolygonCorners& triangle);
  /// As side_of_plane(triangle, polygon(), doubt), but less sure.
  [[nodiscard]] PlaneSide narrow_side_of(const PolygonCorners& triangle, std::int32_t doubt);
  /// As side_of_plane(polygon(), triangle, doubt), but less sure.
  [[nodiscard]] PlaneSide narrow_side_from(const PolygonCorners& triangle, std::int32_t doubt) const;

 private:
  void make_sides();

  TestedPolygon polygon_;
  bool has_sides_, has_normal_, has_plane_;
  bool narrow_;    ///< a triangle whose coordinates, counted from its corner 0, lie in [−2^13, 2^13)
  bool narrower_;  ///< or even in [−2^12, 2^12)
  /// Of a narrow triangle, from its corner 0: its corners, and for each side the direction and the limit: a point (x,
  /// y) lies beyond the side if edge_x·y − edge_y·x ≤ limit.
  std::int32_t x_[3], y_[3], edge_x_[3], edge_y_[3], limit_[3];
  NarrowPlane plane_;
  std::int64_t normal_x_, normal_y_, area_;
};

}  // namespace spanline
