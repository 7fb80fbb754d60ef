#include "spanline/visibility/sort/overlap_tests.hpp"

#include "spanline/math/bits.hpp"

namespace spanline {
namespace {

using Wide = std::int64_t;

std::int32_t depth_of(const ScreenVertex& corner) { return static_cast<std::int32_t>(corner.depth_word >> 8); }

/// A plane through three corners as area·z = normal_x·x + normal_y·y, counted from the first of them; area ≥ 0.
/// |normal| < 2^42 and area < 2^34, so products with depths and coordinates stay below 2^59.
struct PlaneThroughCorners {
  Wide normal_x, normal_y, area;

  PlaneThroughCorners(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c) {
    const std::int32_t x1 = b.x - a.x, y1 = b.y - a.y, z1 = depth_of(b) - depth_of(a);
    const std::int32_t x2 = c.x - a.x, y2 = c.y - a.y, z2 = depth_of(c) - depth_of(a);
    normal_x = static_cast<Wide>(z1) * y2 - static_cast<Wide>(z2) * y1;
    normal_y = static_cast<Wide>(z2) * x1 - static_cast<Wide>(z1) * x2;
    area = static_cast<Wide>(x1) * y2 - static_cast<Wide>(x2) * y1;
    if (area >= 0) return;
    area = -area;
    normal_x = -normal_x;
    normal_y = -normal_y;
  }
};

/// Which side of a plane through `origin` the corners of `q` lie on. `doubt` includes what the polygons' own corners
/// may be off.
PlaneSide side_of(const TestedPolygon& q, const ScreenVertex& origin, Wide normal_x, Wide normal_y, Wide area,
                  std::int32_t doubt) {
  const Wide unsure = area * doubt;
  bool behind = true, in_front = true;
  for (unsigned i = 0; i < q.count && (behind || in_front); ++i) {
    const ScreenVertex& corner = *q.corner[i];
    const Wide distance = area * (depth_of(corner) - depth_of(origin)) - normal_x * (corner.x - origin.x) -
                          normal_y * (corner.y - origin.y);
    behind = behind && distance > unsure;
    in_front = in_front && distance < -unsure;
  }
  return behind ? PlaneSide::behind : in_front ? PlaneSide::in_front : PlaneSide::mixed;
}

bool is_clockwise(const TestedPolygon& polygon) {
  if (polygon.is_outline()) return polygon.clockwise;
  const auto& [a, b, c] = std::array{polygon.corner[0], polygon.corner[1], polygon.corner[2]};
  return static_cast<Wide>(b->x - a->x) * (c->y - a->y) - static_cast<Wide>(c->x - a->x) * (b->y - a->y) > 0;
}

/// Whether all of `q` lies on or beyond the side of a clockwise polygon that goes from `from` to `to`.
bool all_beyond(const TestedPolygon& q, const ScreenVertex& from, const ScreenVertex& to) {
  const std::int32_t edge_x = to.x - from.x, edge_y = to.y - from.y;
  for (unsigned i = 0; i < q.count; ++i) {
    const ScreenVertex& corner = *q.corner[i];
    if (static_cast<Wide>(edge_x) * (corner.y - from.y) > static_cast<Wide>(edge_y) * (corner.x - from.x)) return false;
  }
  return true;
}

/// Whether a side of `p` has all of `q` beyond it.
bool divides(const TestedPolygon& p, const TestedPolygon& q) {
  const bool clockwise = is_clockwise(p);
  for (unsigned i = 0; i < p.count; ++i) {
    const ScreenVertex &a = *p.corner[i], &b = *p.corner[i + 1 < p.count ? i + 1 : 0];
    const ScreenVertex &from = clockwise ? a : b, &to = clockwise ? b : a;
    if (!all_beyond(q, from, to)) continue;
    // Corners of an outline may repeat others: sides without length, and sides that are run back, bound nothing.
    if (!p.is_outline() || (all_beyond(p, to, from) && !all_beyond(p, from, to))) return true;
  }
  return false;
}

/// Whether all of these lie in [−2^bits, 2^bits).
template <int bits, class... Values>
bool all_within(Values... values) {
  return ((word(values + (1 << bits)) | ...) >> (bits + 1)) == 0;
}

std::int32_t depth_16(const ScreenVertex& corner) { return static_cast<std::int32_t>(corner.depth_word >> 16); }

/// A corner as seen from another one.
NarrowCorner from(const ScreenVertex& origin, const ScreenVertex& corner) {
  return {corner.x - origin.x, corner.y - origin.y, depth_16(corner) - depth_16(origin)};
}

}  // namespace

void TestedPolygon::set(const PolygonEntry& entry) {
  if (entry.is_outline()) [[unlikely]] {
    const PlacedOutline outline = entry.outline();
    count = outline.corners.count();
    for (unsigned i = 0; i < count; ++i) corner[i] = &outline.corners[i];
    reference = outline.header.reference();
    clockwise = outline.header.clockwise();
    slack = static_cast<std::int32_t>(outline.header.depth_slack() >> 8) + 1;
    return;
  }
  set(entry.corners());
}

PlaneSide side_of_plane(const TestedPolygon& q, const TestedPolygon& p, std::int32_t doubt) {
  const PlaneThroughCorners plane(*p.corner[0], *p.corner[p.reference], *p.corner[p.reference + 1]);
  return side_of(q, *p.corner[0], plane.normal_x, plane.normal_y, plane.area, doubt + q.slack);
}

bool projections_may_overlap(const TestedPolygon& p, const TestedPolygon& q) {
  return !divides(p, q) && !divides(q, p);
}

void TestedFront::make_sides() {
  has_sides_ = true;
  narrow_ = narrower_ = false;
  if (polygon_.is_outline()) return;
  const ScreenVertex& origin = *polygon_.corner[0];
  for (unsigned i = 0; i < 3; ++i) {
    x_[i] = polygon_.corner[i]->x - origin.x;
    y_[i] = polygon_.corner[i]->y - origin.y;
  }
  narrow_ = all_within<13>(x_[1], x_[2], y_[1], y_[2]);
  if (!narrow_) return;
  narrower_ = all_within<12>(x_[1], x_[2], y_[1], y_[2]);
  const bool clockwise = x_[1] * y_[2] - x_[2] * y_[1] > 0;
  for (unsigned i = 0, next = 1; i < 3; ++i, next = next == 2 ? 0 : next + 1) {
    edge_x_[i] = clockwise ? x_[next] - x_[i] : x_[i] - x_[next];
    edge_y_[i] = clockwise ? y_[next] - y_[i] : y_[i] - y_[next];
    limit_[i] = edge_x_[i] * y_[i] - edge_y_[i] * x_[i];
  }
}

bool TestedFront::projections_may_overlap(const TestedPolygon& q) const {
  return spanline::projections_may_overlap(polygon_, q);
}

bool TestedFront::projections_may_overlap(const PolygonCorners& triangle) {
  const auto in_general = [&] {
    TestedPolygon q;
    q.set(triangle);
    return spanline::projections_may_overlap(polygon_, q);
  };
  if (!has_sides_) make_sides();
  if (!narrow_) return in_general();
  const ScreenVertex &origin = *polygon_.corner[0], &a = *triangle.corner[0], &b = *triangle.corner[1],
                     &c = *triangle.corner[2];
  const std::int32_t x0 = a.x - origin.x, y0 = a.y - origin.y, x1 = b.x - origin.x, y1 = b.y - origin.y,
                     x2 = c.x - origin.x, y2 = c.y - origin.y;
  if (!all_within<13>(x0, y0, x1, y1, x2, y2)) return in_general();
#pragma GCC unroll 3
  for (int i = 0; i < 3; ++i) {
    const std::int32_t edge_x = edge_x_[i], edge_y = edge_y_[i], limit = limit_[i];
    if (edge_x * y0 - edge_y * x0 <= limit && edge_x * y1 - edge_y * x1 <= limit && edge_x * y2 - edge_y * x2 <= limit)
      return false;
  }
  const std::int32_t ax = x1 - x0, ay = y1 - y0, bx = x2 - x1, by = y2 - y1;
  const bool clockwise = ax * by - bx * ay > 0;
  const auto divides = [&](std::int32_t edge_x, std::int32_t edge_y, std::int32_t x, std::int32_t y)
      __attribute__((always_inline)) {
    if (!clockwise) {
      edge_x = -edge_x;
      edge_y = -edge_y;
    }
    const std::int32_t limit = edge_x * y - edge_y * x;
    return 0 <= limit && edge_x * y_[1] - edge_y * x_[1] <= limit && edge_x * y_[2] - edge_y * x_[2] <= limit;
  };
  return !divides(ax, ay, x0, y0) && !divides(bx, by, x1, y1) && !divides(x0 - x2, y0 - y2, x2, y2);
}

// The sum of products of 31 bits is made of two sums in 32 bits: `high` · 2^14 + `low`.
NarrowPlane::NarrowPlane(const NarrowCorner& b, const NarrowCorner& c)
    : normal_x_(b.z * c.y - c.z * b.y),
      normal_y_(c.z * b.x - b.z * c.x),
      area_(b.x * c.y - c.x * b.y),
      across_(signed_word(magnitude(b.x) + magnitude(c.x))),
      along_(signed_word(magnitude(b.y) + magnitude(c.y))) {
  if (area_ >= 0) return;
  area_ = -area_;
  normal_x_ = -normal_x_;
  normal_y_ = -normal_y_;
}

PlaneSide NarrowPlane::side_of(const std::array<NarrowCorner, 3>& triangle, std::int32_t doubt) const {
  constexpr int bits = 14;
  constexpr std::int32_t mask = (1 << bits) - 1;
  // Units of 16 bits, rounded up, and one more for the rounding of the corner's own depth.
  const std::int32_t unsure_depth = area_ * ((doubt + 255) / 256 + 1);
  bool behind = true, in_front = true;
  for (const NarrowCorner& corner : triangle) {
    const std::int32_t high =
                           (area_ >> bits) * corner.z - (normal_x_ >> bits) * corner.x - (normal_y_ >> bits) * corner.y,
                       low = (area_ & mask) * corner.z - (normal_x_ & mask) * corner.x - (normal_y_ & mask) * corner.y;
    const std::int32_t distance = high + (low >> bits);
    const std::int32_t unsure =
        (unsure_depth + signed_word(magnitude(corner.x)) * along_ + signed_word(magnitude(corner.y)) * across_) >> bits;
    behind = behind && distance > unsure;
    in_front = in_front && distance < -unsure - 1;
    if (!behind && !in_front) return PlaneSide::mixed;
  }
  return behind ? PlaneSide::behind : PlaneSide::in_front;
}

bool TestedFront::is_narrow_with(const PolygonCorners& triangle) {
  if (!has_sides_) make_sides();
  if (!narrower_) return false;
  const ScreenVertex &origin = *polygon_.corner[0], &a = *triangle.corner[0], &b = *triangle.corner[1],
                     &c = *triangle.corner[2];
  return all_within<12>(a.x - origin.x, a.y - origin.y, b.x - origin.x, b.y - origin.y, c.x - origin.x, c.y - origin.y);
}

PlaneSide TestedFront::narrow_side_of(const PolygonCorners& triangle, std::int32_t doubt) {
  const ScreenVertex& origin = *polygon_.corner[0];
  if (!has_plane_) {
    has_plane_ = true;
    plane_ = NarrowPlane(from(origin, *polygon_.corner[1]), from(origin, *polygon_.corner[2]));
  }
  return plane_.side_of(
      {from(origin, *triangle.corner[0]), from(origin, *triangle.corner[1]), from(origin, *triangle.corner[2])}, doubt);
}

PlaneSide TestedFront::narrow_side_from(const PolygonCorners& triangle, std::int32_t doubt) const {
  const ScreenVertex& origin = *triangle.corner[0];
  return NarrowPlane(from(origin, *triangle.corner[1]), from(origin, *triangle.corner[2]))
      .side_of(
          {from(origin, *polygon_.corner[0]), from(origin, *polygon_.corner[1]), from(origin, *polygon_.corner[2])},
          doubt);
}

PlaneSide TestedFront::side_of(const TestedPolygon& q, std::int32_t doubt) {
  if (!has_normal_) {
    has_normal_ = true;
    const PlaneThroughCorners plane(*polygon_.corner[0], *polygon_.corner[polygon_.reference],
                                    *polygon_.corner[polygon_.reference + 1]);
    normal_x_ = plane.normal_x;
    normal_y_ = plane.normal_y;
    area_ = plane.area;
  }
  return spanline::side_of(q, *polygon_.corner[0], normal_x_, normal_y_, area_, doubt + q.slack);
}

}  // namespace spanline
