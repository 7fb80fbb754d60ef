#pragma once
#include <algorithm>
#include <cstdint>

#include "spanline/raster/active_triangle.hpp"

namespace spanline {

/// Puts the third edge of a triangle in place, at the row of its bend.
inline void put_third_edge(ActiveTriangle& triangle, const PolygonCorners& corners) {
  triangle.flags.set_bent();
  if (triangle.flags.size() == ActiveTriangle::Size::large) {
    bend_large(corners, triangle);
  } else if (triangle.flags.right_bends()) {
    triangle.fixed.right = triangle.fixed.bend;
    triangle.fixed.right_step = triangle.fixed.bend_step;
  } else {
    triangle.fixed.left = triangle.fixed.bend;
    triangle.fixed.left_step = triangle.fixed.bend_step;
  }
}

/// Steps an active triangle and its surface over the rows above `end_row` (biased), to the very words that drawing them
/// would have left. False if the triangle ends there. `corners_of` gives its corners where the bend is met.
template <class Surface, class CornersOf>
[[nodiscard]] bool skip_rows(ActiveTriangle& triangle, Surface& surface, std::int32_t end_row, CornersOf corners_of) {
  if (triangle.end_row() <= end_row) return false;
  const auto walk = [&triangle](std::int32_t rows) {
    triangle.row = static_cast<std::uint16_t>(triangle.row + rows);
    if (triangle.flags.size() != ActiveTriangle::Size::large) {
      triangle.fixed.left += triangle.fixed.left_step * word(rows);
      triangle.fixed.right += triangle.fixed.right_step * word(rows);
      return;
    }
    for (; rows > 0; --rows) {
      triangle.large.left.next_row();
      triangle.large.right.next_row();
    }
  };
  const std::int32_t rows = end_row - triangle.row;
  const std::int32_t before = std::min<std::int32_t>(triangle.rows_to_bend, rows), after = rows - before;
  walk(before);
  triangle.rows_to_bend = static_cast<std::uint16_t>(triangle.rows_to_bend - before);
  if (after > 0) {
    if (!triangle.flags.bent()) put_third_edge(triangle, corners_of());
    walk(after);
    triangle.rows_after_bend = static_cast<std::uint16_t>(triangle.rows_after_bend - after);
  }
  triangle.depth.skip_rows(rows);
  surface.skip_rows(rows);
  return true;
}

}  // namespace spanline
