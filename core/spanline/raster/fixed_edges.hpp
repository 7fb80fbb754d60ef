#pragma once
#include <cstdint>

namespace spanline {

/// An edge on a row, as a fixed-point column counted from a column of origin.
struct FixedEdge {
  std::uint32_t column;
  std::uint32_t step;  ///< slope, columns a row
};

/// Edges of a triangle as fixed-point columns, counted from the triangle's column of origin. A step to the next row is
/// one addition for each edge. Columns of small triangles have 26 fraction bits (a range of 64 pixels), those of medium
/// ones 24 (256 pixels).
struct FixedEdges {
  std::uint32_t left, right;            ///< columns of the current row
  std::uint32_t left_step, right_step;  ///< slopes, columns a row
  std::uint32_t third, third_step;  ///< the third edge, on its first row: it replaces the left or the right one there

  void next_row() {
    left += left_step;
    right += right_step;
  }
  void skip_rows(std::int32_t rows) {
    left += left_step * static_cast<std::uint32_t>(rows);
    right += right_step * static_cast<std::uint32_t>(rows);
  }
  /// Replaces the right or the left edge by the third one.
  void put_third(bool third_on_right) {
    (third_on_right ? right : left) = third;
    (third_on_right ? right_step : left_step) = third_step;
  }
};

}  // namespace spanline
