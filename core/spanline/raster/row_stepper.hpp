#pragma once
#include <algorithm>
#include <cstdint>

#include "spanline/raster/active_triangle.hpp"
#include "spanline/raster/medium_triangle.hpp"
#include "spanline/raster/outline_setup.hpp"
#include "spanline/raster/polygon_corners.hpp"
#include "spanline/raster/polygon_table.hpp"
#include "spanline/raster/row_columns.hpp"
#include "spanline/raster/small_triangle.hpp"
#include "spanline/raster/triangle_setup.hpp"

namespace spanline {

/// Replaces the edge that ends at the row of a triangle's knee by the third edge.
inline void put_third_edge(ActiveTriangle& triangle, const PolygonCorners& corners) {
  triangle.flags.set_past_knee();
  if (triangle.flags.size() == ActiveTriangle::Size::large)
    put_third_large_edge(corners, triangle);
  else
    triangle.fixed.put_third(triangle.flags.third_on_right());
}

/// Steps the edges and counts of rows of a triangle to its next row. Written for clarity, not for speed. Output: the
/// columns of the row before the step. `entry_of` returns the polygon's PolygonEntry; it is called where an edge ends.
template <class EntryOf>
RowColumns step_row(ActiveTriangle& triangle, EntryOf entry_of) {
  if (triangle.rows_to_knee == 0) {
    if (triangle.flags.outline())
      place_outline_edges(entry_of().outline(), triangle);
    else if (!triangle.flags.past_knee())
      put_third_edge(triangle, entry_of().corners());
  }
  RowColumns columns;
  if (triangle.flags.size() == ActiveTriangle::Size::large) {
    columns = {triangle.large.left.x, triangle.large.right.x};
    triangle.large.skip_rows(1);
  } else {
    const int fraction_bits = triangle.flags.size() == ActiveTriangle::Size::small ? small_triangle::fraction_bits
                                                                                   : medium_triangle::fraction_bits;
    columns = {signed_word(triangle.fixed.left >> fraction_bits), signed_word(triangle.fixed.right >> fraction_bits)};
    triangle.fixed.next_row();
  }
  ++triangle.row;
  --(triangle.rows_to_knee != 0 ? triangle.rows_to_knee : triangle.rows_after_knee);
  return columns;
}

/// Steps an active triangle and its surface over the rows above `end_row` (biased), with exactly the words that drawing
/// these rows would leave. False if the triangle ends above `end_row`. `entry_of` is as for `step_row`.
template <class Surface, class EntryOf>
[[nodiscard]] bool skip_rows(ActiveTriangle& triangle, Surface& surface, std::int32_t end_row, EntryOf entry_of) {
  if (triangle.end_row() <= end_row) return false;
  const std::int32_t rows = end_row - triangle.row;
  const std::int32_t before = std::min(triangle.rows_to_knee, rows), after = rows - before;
  if (triangle.flags.size() != ActiveTriangle::Size::large) {
    triangle.skip_rows(before, after);
  } else {
    triangle.large.skip_rows(before);
    if (after > 0) {
      triangle.row += before;  // first row of the third edge
      if (!triangle.flags.past_knee()) put_third_edge(triangle, entry_of().corners());
      triangle.large.skip_rows(after);
    }
    triangle.depth.skip_rows(rows);
  }
  triangle.row = end_row;
  triangle.rows_to_knee -= before;
  triangle.rows_after_knee -= after;
  surface.skip_rows(rows);
  return true;
}

}  // namespace spanline
