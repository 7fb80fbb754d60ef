#include "spanline/raster/outline_setup.hpp"

#include "spanline/raster/medium_triangle.hpp"
#include "spanline/raster/small_triangle.hpp"

namespace spanline {
namespace {

/// An edge of an outline, from its upper to its lower end.
struct OutlineSide {
  const ScreenVertex* upper;
  const ScreenVertex* lower;

  /// The first edge that ends below the centre of `row`, from corner `from` on in steps of `step` corners.
  [[nodiscard, gnu::always_inline]] static inline OutlineSide of(const Outline& outline, unsigned from, unsigned step,
                                                                 std::int32_t row) {
    const ScreenVertex* upper = &outline[from];
    for (;;) {
      from += step;
      if (from >= outline.count()) from -= outline.count();
      const ScreenVertex* lower = &outline[from];
      if (row_at(lower->y) > row) return {upper, lower};
      upper = lower;
    }
  }
  [[nodiscard]] std::int32_t dx() const { return lower->x - upper->x; }
  [[nodiscard]] std::int32_t dy() const { return lower->y - upper->y; }
  [[nodiscard]] std::int32_t end_row() const { return row_at(lower->y); }
  [[nodiscard]] std::int32_t first_row() const { return row_at(upper->y); }
  /// From the upper end down to the centre of the first row, sixteenths of a pixel.
  [[nodiscard]] std::int32_t offset() const { return 16 * first_row() + 8 - upper->y; }
};

/// The two edges of an outline on a row.
struct OutlineSides {
  OutlineSide left, right;

  [[nodiscard, gnu::always_inline]] static inline OutlineSides of(const PlacedOutline& outline, std::int32_t row) {
    const unsigned forward = 1, backward = outline.corners.count() - 1, top = outline.header.top();
    const bool clockwise = outline.header.clockwise();
    return {OutlineSide::of(outline.corners, top, clockwise ? backward : forward, row),
            OutlineSide::of(outline.corners, top, clockwise ? forward : backward, row)};
  }
  /// The row where one of them ends.
  [[nodiscard]] std::int32_t end_row() const {
    const std::int32_t left_end = left.end_row(), right_end = right.end_row();
    return left_end < right_end ? left_end : right_end;
  }
};

/// An edge of a small outline on `row`. It is stepped down from its own first row, so that its column there is that of
/// a triangle's edge.
[[nodiscard, gnu::always_inline]] inline FixedEdge small_outline_edge(const OutlineSide& side, std::int32_t origin,
                                                                      std::int32_t row) {
  FixedEdge edge = small_triangle::edge_from(small_triangle::start_of_edge(word(side.upper->x - 16 * origin)),
                                             side.dx(), side.dy(), side.offset());
  edge.column += edge.step * word(row - side.first_row());
  return edge;
}

FixedEdge medium_edge(const OutlineSide& side, std::int32_t origin, std::int32_t row) {
  FixedEdge edge = medium_triangle::edge_from(medium_triangle::start_of_edge(side.upper->x - 16 * origin), side.dx(),
                                              side.dy(), side.offset());
  edge.column += edge.step * word(row - side.first_row());
  return edge;
}

/// Places the edges of an outline that is not small. Not inlined, so that small ones pay nothing for it.
[[gnu::noinline]] void place_wide_edges(const OutlineSides& sides, const PlacedOutline& outline,
                                        ActiveTriangle& active) {
  const auto [left, right] = sides;
  if (outline.header.size() == ActiveTriangle::Size::large) {
    active.large = {Edge::between(*left.upper, *left.lower, active.row),
                    Edge::between(*right.upper, *right.lower, active.row)};
    return;
  }
  const FixedEdge on_left = medium_edge(left, outline.origin, active.row);
  const FixedEdge on_right = medium_edge(right, outline.origin, active.row);
  active.fixed.left = on_left.column;
  active.fixed.left_step = on_left.step;
  active.fixed.right = on_right.column;
  active.fixed.right_step = on_right.step;
}

[[gnu::always_inline]] inline void place_edges(const PlacedOutline& outline, ActiveTriangle& active) {
  const std::int32_t row = active.row;
  const OutlineSides sides = OutlineSides::of(outline, row);
  const std::int32_t until_turn = sides.end_row() - row;
  const std::int32_t rows = until_turn < active.rows_after_knee ? until_turn : active.rows_after_knee;
  active.rows_to_knee = rows;
  active.rows_after_knee -= rows;
  if (outline.header.size() != ActiveTriangle::Size::small) return place_wide_edges(sides, outline, active);
  const FixedEdge left = small_outline_edge(sides.left, outline.origin, row);
  active.fixed.left = left.column;
  active.fixed.left_step = left.step;
  const FixedEdge right = small_outline_edge(sides.right, outline.origin, row);
  active.fixed.right = right.column;
  active.fixed.right_step = right.step;
}

}  // namespace

void place_outline_edges(const PlacedOutline& outline, ActiveTriangle& active) { place_edges(outline, active); }

void set_up_rows(const PlacedOutline& outline, std::int32_t first, std::int32_t end, ActiveTriangle& active) {
  const ActiveTriangle::Size size = outline.header.size();
  active.flags = {size, false, size == ActiveTriangle::Size::large && outline.leaves_viewport()};
  active.origin = size == ActiveTriangle::Size::large ? 0 : outline.origin - row_bias;
  active.flags.set_outline();
  active.row = first;
  active.rows_after_knee = end - first;
  place_edges(outline, active);
}

bool set_up_outline(const PlacedOutline& outline, const Viewport& viewport, ActiveTriangle& active,
                    std::int32_t first_row) {
  const std::int32_t bottom = viewport.height + row_bias, top = row_at(outline.corners[outline.header.top()].y);
  const std::int32_t first = top > first_row ? top : first_row;
  const std::int32_t end = outline.end_row < bottom ? outline.end_row : bottom;
  if (first >= end) return false;
  set_up_rows(outline, first, end, active);
  return true;
}

bool skip_outline_rows(ActiveTriangle& outline, std::int32_t end_row, const PlacedOutline& placed) {
  if (outline.end_row() <= end_row) return false;
  outline.depth.skip_rows(end_row - outline.row);
  outline.rows_after_knee = outline.end_row() - end_row;
  outline.row = end_row;
  place_edges(placed, outline);
  return true;
}

}  // namespace spanline
