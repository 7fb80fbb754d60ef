#include "spanline/raster/outline_setup.hpp"

#include <algorithm>

#include "spanline/raster/medium_triangle.hpp"
#include "spanline/raster/small_triangle.hpp"

namespace spanline {
namespace {

/// An edge of an outline, from its upper to its lower end.
struct Side {
  const ScreenVertex* upper;
  const ScreenVertex* lower;

  [[nodiscard]] std::int32_t dx() const { return lower->x - upper->x; }
  [[nodiscard]] std::int32_t dy() const { return lower->y - upper->y; }
  [[nodiscard]] std::int32_t first_row() const { return row_at(upper->y); }
  [[nodiscard]] std::int32_t end_row() const { return row_at(lower->y); }
};

struct Box {
  std::int32_t left, right, top, bottom;  ///< biased, sixteenths of a pixel
};

Box box_of(const Outline& outline) {
  Box box{outline.corner[0]->x, outline.corner[0]->x, outline.corner[0]->y, outline.corner[0]->y};
  for (unsigned i = 1; i < outline.count; ++i) {
    const std::int32_t x = outline.corner[i]->x, y = outline.corner[i]->y;
    box = {std::min(box.left, x), std::max(box.right, x), std::min(box.top, y), std::max(box.bottom, y)};
  }
  return box;
}

unsigned topmost(const Outline& outline) {
  unsigned top = 0;
  for (unsigned i = 1; i < outline.count; ++i)
    if (outline.corner[i]->y < outline.corner[top]->y) top = i;
  return top;
}

/// The first edge that ends below the centre of `row`, from corner `from` on in steps of `step` corners.
Side side_on(const Outline& outline, unsigned from, unsigned step, std::int32_t row) {
  for (;;) {
    const unsigned to = from + step < outline.count ? from + step : from + step - outline.count;
    const Side side{outline.corner[from], outline.corner[to]};
    if (side.end_row() > row) return side;
    from = to;
  }
}

bool fits_small(const Box& box, const ScreenVertex& top) {
  return box.bottom - box.top <= small_triangle::max_height && top.x - box.left <= small_triangle::reach &&
         box.right - top.x <= small_triangle::reach;
}

bool fits_medium(const Outline& outline, const Box& box) {
  if (box.right - box.left > medium_triangle::max_width || box.bottom - box.top > medium_triangle::max_height)
    return false;
  for (unsigned i = 0; i < outline.count; ++i) {
    const ScreenVertex &a = *outline.corner[i], &b = *outline.corner[i + 1 < outline.count ? i + 1 : 0];
    const std::int32_t dx = b.x - a.x, dy = b.y - a.y;
    if (dy != 0 && signed_word(magnitude(dx)) >= medium_triangle::flattest * signed_word(magnitude(dy))) return false;
  }
  return true;
}

/// A column of an edge, and its slope.
struct FixedEdge {
  std::uint32_t column, step;
};

/// An edge of a small or medium outline on `row`, with the words of small_triangle::set_edges and
/// medium_triangle::set_edges, stepped down from the edge's own first row. `origin` is biased.
FixedEdge fixed_edge(const Side& side, bool small, std::int32_t origin, std::int32_t row) {
  const std::int32_t offset = 16 * side.first_row() + 8 - side.upper->y;
  const std::uint32_t from_origin = word(side.upper->x - 16 * origin + 8);
  FixedEdge edge;
  if (small) {
    const std::uint32_t inverse = small_triangle::reciprocal_q26[word(side.dy())];
    edge.step = word(side.dx()) * inverse;
    edge.column = (from_origin << 22) - (1u << 13) + word(offset * side.dx()) * (inverse >> 4);
  } else {
    const std::int32_t slope = medium_triangle::slope(side.dx(), side.dy());
    edge.step = word(slope);
    edge.column = (from_origin << 20) - 256 + word(offset * (slope >> 4) + ((offset * (slope & 15)) >> 4));
  }
  edge.column += edge.step * word(row - side.first_row());
  return edge;
}

Edge large_edge(const Side& side, std::int32_t row) {
  Edge edge = Edge::at_row(side.upper->x, side.upper->y, side.lower->x, side.lower->y, row);
  edge.x -= row_bias;
  return edge;
}

}  // namespace

void place_outline_edges(const Outline& outline, ActiveTriangle& active) {
  const unsigned top = topmost(outline), forward = 1, backward = outline.count - 1;
  const bool clockwise = active.flags.clockwise();
  const Side left = side_on(outline, top, clockwise ? backward : forward, active.row);
  const Side right = side_on(outline, top, clockwise ? forward : backward, active.row);
  const std::int32_t rows = std::min(std::min(left.end_row(), right.end_row()) - active.row, active.rows_after_knee);
  active.rows_to_knee = rows;
  active.rows_after_knee -= rows;
  if (active.flags.size() == ActiveTriangle::Size::large) {
    active.large = {large_edge(left, active.row), large_edge(right, active.row)};
    return;
  }
  const bool small = active.flags.size() == ActiveTriangle::Size::small;
  const std::int32_t origin = active.origin + row_bias;
  const FixedEdge on_left = fixed_edge(left, small, origin, active.row);
  const FixedEdge on_right = fixed_edge(right, small, origin, active.row);
  active.fixed.left = on_left.column;
  active.fixed.left_step = on_left.step;
  active.fixed.right = on_right.column;
  active.fixed.right_step = on_right.step;
}

bool set_up_outline(const Outline& outline, Turn turn, bool scissored, Viewport viewport, ActiveTriangle& active) {
  const Box box = box_of(outline);
  const std::int32_t first = std::max(row_at(box.top), row_bias);
  const std::int32_t end = std::min(row_at(box.bottom), viewport.height + row_bias);
  if (first >= end) return false;
  const ScreenVertex& top = *outline.corner[topmost(outline)];
  using Size = ActiveTriangle::Size;
  const bool small = !scissored && fits_small(box, top);
  const Size size = small ? Size::small : !scissored && fits_medium(outline, box) ? Size::medium : Size::large;
  active.flags = {size, false, scissored};
  active.flags.set_outline(turn == Turn::clockwise);
  active.origin = 0;
  if (size == Size::small) active.origin = (top.x >> 4) - row_bias - small_triangle::margin;
  if (size == Size::medium) active.origin = row_at(box.left) - 1 - row_bias;
  active.row = first;
  active.rows_to_knee = 0;
  active.rows_after_knee = end - first;
  place_outline_edges(outline, active);
  return true;
}

}  // namespace spanline
