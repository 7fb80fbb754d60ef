#pragma once
#include <cstdint>

namespace spanline {

/// Edges of a triangle as fixed-point columns, counted from its column of origin: a row step is one addition an edge.
/// Small triangles have 26 fraction bits (64 pixels wide at most), medium ones 24 (256 pixels).
struct FixedEdges {
  std::uint32_t left, right;            ///< columns of the current row
  std::uint32_t left_step, right_step;  ///< slopes
  std::uint32_t third, third_step;      ///< the third edge: replaces the left or the right one at its first row

  void next_row() {
    left += left_step;
    right += right_step;
  }
  void skip_rows(std::int32_t rows) {
    left += left_step * static_cast<std::uint32_t>(rows);
    right += right_step * static_cast<std::uint32_t>(rows);
  }
  /// Puts the third edge in place.
  void put_third(bool third_on_right) {
    (third_on_right ? right : left) = third;
    (third_on_right ? right_step : left_step) = third_step;
  }
};

}  // namespace spanline
