#include "spanline/visibility/span/awake_polygon.hpp"

#include "spanline/raster/link.hpp"
#include "spanline/raster/medium_triangle.hpp"
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

Edge edge_between(const ScreenVertex& from, const ScreenVertex& to, std::int32_t row) {
  Edge edge = Edge::at_row(from.x, from.y, to.x, to.y, row);
  edge.x -= row_bias;
  return edge;
}

/// Sets up the third edge of a large polygon on the biased `row`.
void place_third_edge(AwakePolygon& polygon, const Triangle& t, std::int32_t row) {
  if (polygon.third_on_right)
    polygon.large.right = edge_between(*t.b, *t.c, row);
  else
    polygon.large.left = edge_between(*t.c, *t.b, row);
}

void place_large(AwakePolygon& polygon, const Triangle& t, const Rows& rows, std::int32_t row) {
  polygon.fraction_bits = 0;
  polygon.origin = 0;
  const bool past_knee = row >= rows.knee;
  if (!past_knee || polygon.third_on_right) polygon.large.left = edge_between(*t.a, *t.c, row);
  if (!past_knee || !polygon.third_on_right) polygon.large.right = edge_between(*t.a, *t.b, row);
  if (past_knee) place_third_edge(polygon, t, row);
}

[[gnu::noinline]] Rows place_wide(AwakePolygon& polygon, Triangle& t, bool scissored, std::int32_t row) {
  if (t.wide_doubled_area() < 0) t.flip();
  const ThirdEdge third = ThirdEdge::of(t);
  const Rows rows = rows_of(t, third);
  polygon.third_on_right = third.on_right;
  if (scissored || !medium_triangle::fits(t)) {
    place_large(polygon, t, rows, row);
    return rows;
  }
  const std::int32_t origin = medium_triangle::origin_of(t);
  polygon.fraction_bits = medium_triangle::fraction_bits;
  polygon.origin = static_cast<std::int16_t>(origin - row_bias);
  medium_triangle::set_edges(t, third, origin, 16 * rows.first + 8 - t.ay, 16 * rows.knee + 8 - t.ay - third.y,
                             polygon.fixed);
  move_down(polygon.fixed, polygon.third_on_right, rows, row);
  return rows;
}

}  // namespace

std::int32_t wake(AwakePolygon& polygon, const PolygonSource& source, Link number, std::int32_t row,
                  BoundMargin margin) {
  const Link group_number = source.table.find_group(number);
  const PolygonGroup& group = source.table.groups[group_number];
  const auto [p, q, r] = source.table.corners(group, number).corner;
  polygon.number = number;
  polygon.group = group_number;
  polygon.has_plane = polygon.has_surface = false;
  polygon.retry_row = 0;
  const std::uint32_t depth_p = p->depth_word, depth_q = q->depth_word, depth_r = r->depth_word;
  const std::uint32_t nearest = depth_p < depth_q ? depth_p : depth_q, farthest = depth_p < depth_q ? depth_q : depth_p;
  // The outcodes in the low bits do no harm, since the margins are larger than a whole depth unit.
  const std::uint32_t low = depth_r < nearest ? depth_r : nearest, high = depth_r > farthest ? depth_r : farthest;
  polygon.nearest = low > margin.below ? low - margin.below : 0;
  polygon.farthest = high < ~margin.above ? high + margin.above : ~std::uint32_t{0};

  Triangle t = Triangle::from(p, q, r);
  const bool scissored = group.scissored && leaves_viewport(t);
  const std::int32_t biased_row = row + row_bias;
  Rows rows;
  std::int32_t area;
  if (!scissored && is_small(t, area)) {
    if (area < 0) t.flip();
    const ThirdEdge third = ThirdEdge::of(t);
    rows = rows_of(t, third);
    polygon.third_on_right = third.on_right;
    polygon.fraction_bits = small_triangle::fraction_bits;
    polygon.origin = static_cast<std::int16_t>(small_triangle::origin_of(t));
    small_triangle::set_edges(t, third, 16 * rows.first + 8 - t.ay, 16 * rows.knee + 8 - t.ay - third.y, polygon.fixed);
    if (biased_row != rows.first || rows.first == rows.knee)
      move_down(polygon.fixed, polygon.third_on_right, rows, biased_row);
  } else {
    Triangle kept = t;  // a copy, so that `t` itself stays in registers for small triangles
    rows = place_wide(polygon, kept, scissored, biased_row);
  }
  const std::int32_t end = rows.end - row_bias;
  polygon.end_row = static_cast<std::uint16_t>(end < source.viewport.height ? end : source.viewport.height);
  const std::int32_t knee = rows.knee - row_bias;
  polygon.turn_row = row < knee && knee < polygon.end_row ? static_cast<std::uint16_t>(knee) : polygon.end_row;
  return polygon.fraction_bits != 0 ? place_columns(polygon) : cut_columns(polygon, source.viewport.width);
}

bool turn(AwakePolygon& polygon, const PolygonSource& source, std::int32_t row) {
  if (row >= polygon.end_row) return false;
  polygon.turn_row = polygon.end_row;
  if (polygon.fraction_bits != 0) {
    FixedEdges& edges = polygon.fixed;
    edges.left += edges.left_step;
    edges.right += edges.right_step;
    edges.put_third(polygon.third_on_right);
    return true;
  }
  polygon.large.left.next_row();
  polygon.large.right.next_row();
  const PolygonCorners corners = source.corners(polygon);
  Triangle t = Triangle::from(corners.corner[0], corners.corner[1], corners.corner[2]);
  if (t.wide_doubled_area() < 0) t.flip();
  place_third_edge(polygon, t, row + row_bias);
  return true;
}

}  // namespace spanline
