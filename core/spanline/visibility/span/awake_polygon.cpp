#include "spanline/visibility/span/awake_polygon.hpp"

#include <algorithm>

#include "spanline/raster/link.hpp"
#include "spanline/raster/medium_triangle.hpp"
#include "spanline/raster/outline_setup.hpp"
#include "spanline/raster/polygon_corners.hpp"

namespace spanline {
namespace {

/// Rows of a triangle, biased: the first, the first after the knee, and the one after the last.
struct Rows {
  std::int32_t first, knee, end;
};

Rows rows_of(const Triangle& t, const ThirdEdge& third) {
  return {row_at(t.ay), row_at(t.ay + third.y), row_at(t.ay + third.y + third.dy)};
}

bool third_on_right(const AwakePolygon& polygon) { return polygon.third == AwakePolygon::Third::on_right; }

/// Steps fixed edges from the polygon's first row down to `row`.
void move_down(FixedEdges& edges, bool third_on_right, const Rows& rows, std::int32_t row) {
  const std::uint32_t down = word(row - rows.first);
  edges.left += edges.left_step * down;
  edges.right += edges.right_step * down;
  if (row < rows.knee) return;
  const std::uint32_t at_knee = edges.third + edges.third_step * word(row - rows.knee);
  (third_on_right ? edges.right : edges.left) = at_knee;
  (third_on_right ? edges.right_step : edges.left_step) = edges.third_step;
}

/// Sets up the third edge of a large polygon on the biased `row`.
void place_third_edge(AwakePolygon& polygon, const Triangle& t, std::int32_t row) {
  if (third_on_right(polygon))
    polygon.large.right = Edge::between(*t.b, *t.c, row);
  else
    polygon.large.left = Edge::between(*t.c, *t.b, row);
}

void place_large(AwakePolygon& polygon, const Triangle& t, const Rows& rows, std::int32_t row) {
  polygon.fraction_bits = 0;
  polygon.origin = 0;
  const bool past_knee = row >= rows.knee;
  if (!past_knee || third_on_right(polygon)) polygon.large.left = Edge::between(*t.a, *t.c, row);
  if (!past_knee || !third_on_right(polygon)) polygon.large.right = Edge::between(*t.a, *t.b, row);
  if (past_knee) place_third_edge(polygon, t, row);
}

[[gnu::noinline]] Rows place_wide(AwakePolygon& polygon, Triangle& t, bool scissored, std::int32_t row) {
  if (t.wide_doubled_area() < 0) t.flip();
  const ThirdEdge third = ThirdEdge::of(t);
  const Rows rows = rows_of(t, third);
  polygon.third = third.on_right ? AwakePolygon::Third::on_right : AwakePolygon::Third::on_left;
  if (scissored || !medium_triangle::fits(t)) {
    place_large(polygon, t, rows, row);
    return rows;
  }
  const std::int32_t origin = medium_triangle::origin_of(t);
  polygon.fraction_bits = medium_triangle::fraction_bits;
  polygon.origin = static_cast<std::int16_t>(origin - row_bias);
  medium_triangle::set_edges(t, third, origin, 16 * rows.first + 8 - t.ay, 16 * rows.knee + 8 - t.ay - third.y,
                             polygon.fixed);
  move_down(polygon.fixed, third_on_right(polygon), rows, row);
  return rows;
}

std::uint8_t fraction_bits_of(ActiveTriangle::Size size) {
  if (size == ActiveTriangle::Size::small) return small_triangle::fraction_bits;
  return size == ActiveTriangle::Size::medium ? medium_triangle::fraction_bits : 0;
}

/// Takes over the edges of an outline, up to the row where one of them ends.
std::int32_t take_edges(AwakePolygon& polygon, const ActiveTriangle& active, std::int32_t width) {
  polygon.turn_row = static_cast<std::uint16_t>(active.row + active.rows_to_knee - row_bias);
  if (polygon.fraction_bits == 0) {
    polygon.large = active.large;
    return cut_columns(polygon, width);
  }
  polygon.fixed = active.fixed;
  return place_columns(polygon);
}

/// The bounds are those of an outline's corners and the slack of its plane.
void set_bounds(AwakePolygon& polygon, const PlacedOutline& outline, BoundMargin margin) {
  std::uint32_t low = ~std::uint32_t{0}, high = 0;
  for (unsigned i = 0; i < outline.corners.count(); ++i) {
    const std::uint32_t depth = outline.corners[i].depth_word;
    if (depth < low) low = depth;
    if (depth > high) high = depth;
  }
  const std::uint32_t slack = outline.header.depth_slack(), below = margin.below + slack, above = margin.above + slack;
  polygon.nearest = low > below ? low - below : 0;
  polygon.farthest = high < ~above ? high + above : ~std::uint32_t{0};
}

std::int32_t set_up_outline_edges(AwakePolygon& polygon, const PolygonSource& source, const PlacedOutline& outline,
                                  std::int32_t row) {
  ActiveTriangle active;
  set_up_rows(outline, row + row_bias, std::min(outline.end_row, source.viewport.height + row_bias), active);
  polygon.third = AwakePolygon::Third::outline;
  polygon.fraction_bits = fraction_bits_of(outline.header.size());
  polygon.origin = static_cast<std::int16_t>(active.origin);
  polygon.end_row = static_cast<std::uint16_t>(active.end_row() - row_bias);
  return take_edges(polygon, active, source.viewport.width);
}

/// As `wake`, for an outline.
[[gnu::noinline]] std::int32_t wake_outline(AwakePolygon& polygon, const PolygonSource& source, std::int32_t row,
                                            BoundMargin margin) {
  const PlacedOutline outline = source.entry(polygon).outline();
  set_bounds(polygon, outline, margin);
  return set_up_outline_edges(polygon, source, outline, row);
}

/// As `place`, for an outline.
[[gnu::noinline]] std::int32_t place_outline(AwakePolygon& polygon, const PolygonSource& source, std::int32_t first,
                                             std::int32_t end) {
  const PlacedOutline outline = source.entry(polygon).outline();
  const std::int32_t top = row_at(outline.corners[outline.header.top()].y) - row_bias;
  const std::int32_t row = top > first ? top : first;
  if (row >= end || row >= outline.end_row - row_bias) return end;
  static_cast<void>(set_up_outline_edges(polygon, source, outline, row));
  return row;
}

/// Sets up the edges of a triangle on one of its rows.
[[gnu::always_inline]] inline void set_up_edges(AwakePolygon& polygon, const PolygonSource& source,
                                                const PolygonGroup& group, Triangle& t, std::int32_t row) {
  const bool scissored = group.scissored && leaves_viewport(t);
  const std::int32_t biased_row = row + row_bias;
  Rows rows;
  std::int32_t area;
  if (!scissored && is_small(t, area)) {
    if (area < 0) t.flip();
    const ThirdEdge third = ThirdEdge::of(t);
    rows = rows_of(t, third);
    polygon.third = third.on_right ? AwakePolygon::Third::on_right : AwakePolygon::Third::on_left;
    polygon.fraction_bits = small_triangle::fraction_bits;
    polygon.origin = static_cast<std::int16_t>(small_triangle::origin_of(t));
    small_triangle::set_edges(t, third, 16 * rows.first + 8 - t.ay, 16 * rows.knee + 8 - t.ay - third.y, polygon.fixed);
    if (biased_row != rows.first || rows.first == rows.knee)
      move_down(polygon.fixed, third_on_right(polygon), rows, biased_row);
  } else {
    Triangle kept = t;  // a copy, so that `t` itself stays in registers for small triangles
    rows = place_wide(polygon, kept, scissored, biased_row);
  }
  const std::int32_t end = rows.end - row_bias;
  polygon.end_row = static_cast<std::uint16_t>(end < source.viewport.height ? end : source.viewport.height);
  const std::int32_t knee = rows.knee - row_bias;
  polygon.turn_row = row < knee && knee < polygon.end_row ? static_cast<std::uint16_t>(knee) : polygon.end_row;
}

/// Starts the record of a polygon of the table. Output: the polygon's group.
[[gnu::always_inline]] inline const PolygonGroup& begin_record(AwakePolygon& polygon, const PolygonTable& table,
                                                               Link number) {
  const Link group_number = table.find_group(number);
  polygon.number = number;
  polygon.group = group_number;
  polygon.has_plane = polygon.has_surface = false;
  polygon.retry_row = 0;
  return table.groups[group_number];
}

// The two functions below are `turn` for what is rarer than small and medium triangles. They end it, so that it needs
// no registers of its own.

/// Places the next edges of an outline on `row`.
[[gnu::noinline]] bool turn_outline(AwakePolygon& polygon, const PolygonSource& source, std::int32_t row) {
  ActiveTriangle active;
  active.origin = polygon.origin;
  active.row = row + row_bias;
  active.rows_to_knee = 0;
  active.rows_after_knee = polygon.end_row - row;
  place_outline_edges(source.entry(polygon).outline(), active);
  static_cast<void>(take_edges(polygon, active, source.viewport.width));
  return true;
}

[[gnu::noinline]] bool turn_large(AwakePolygon& polygon, const PolygonSource& source, std::int32_t row) {
  polygon.large.left.next_row();
  polygon.large.right.next_row();
  const PolygonCorners corners = source.corners(polygon);
  Triangle t = Triangle::from(corners.corner[0], corners.corner[1], corners.corner[2]);
  if (t.wide_doubled_area() < 0) t.flip();
  place_third_edge(polygon, t, row + row_bias);
  return true;
}

}  // namespace

std::int32_t wake(AwakePolygon& polygon, const PolygonSource& source, Link number, std::int32_t row,
                  BoundMargin margin) {
  const PolygonGroup& group = begin_record(polygon, source.table, number);
  if (source.table.is_outline(number)) [[unlikely]]
    return wake_outline(polygon, source, row, margin);
  const PolygonCorners corners = source.table.corners(group, number);
  const ScreenVertex *p = corners.corner[0], *q = corners.corner[1], *r = corners.corner[2];
  const std::uint32_t depth_p = p->depth_word, depth_q = q->depth_word, depth_r = r->depth_word;
  const std::uint32_t nearest = depth_p < depth_q ? depth_p : depth_q, farthest = depth_p < depth_q ? depth_q : depth_p;
  // The outcodes in the low bits do no harm, since the margins are larger than a whole depth unit.
  const std::uint32_t low = depth_r < nearest ? depth_r : nearest, high = depth_r > farthest ? depth_r : farthest;
  polygon.nearest = low > margin.below ? low - margin.below : 0;
  polygon.farthest = high < ~margin.above ? high + margin.above : ~std::uint32_t{0};

  Triangle t = Triangle::from(p, q, r);
  set_up_edges(polygon, source, group, t, row);
  return polygon.fraction_bits != 0 ? place_columns(polygon) : cut_columns(polygon, source.viewport.width);
}

std::int32_t place(AwakePolygon& polygon, const PolygonSource& source, Link number, std::int32_t first,
                   std::int32_t end) {
  const PolygonGroup& group = begin_record(polygon, source.table, number);
  if (source.table.is_outline(number)) [[unlikely]]
    return place_outline(polygon, source, first, end);
  const PolygonCorners corners = source.table.corners(group, number);
  Triangle t = Triangle::from(corners.corner[0], corners.corner[1], corners.corner[2]);
  const std::int32_t top = row_at(t.ay) - row_bias, bottom = row_at(t.ay + std::max(t.dy1, t.dy2)) - row_bias;
  const std::int32_t row = top > first ? top : first;
  if (row >= end || row >= bottom) return end;
  set_up_edges(polygon, source, group, t, row);
  return row;
}

bool turn(AwakePolygon& polygon, const PolygonSource& source, std::int32_t row) {
  if (row >= polygon.end_row) return false;
  if (polygon.is_outline()) return turn_outline(polygon, source, row);
  polygon.turn_row = polygon.end_row;
  if (polygon.fraction_bits == 0) return turn_large(polygon, source, row);
  FixedEdges& edges = polygon.fixed;
  edges.left += edges.left_step;
  edges.right += edges.right_step;
  edges.put_third(third_on_right(polygon));
  return true;
}

}  // namespace spanline
