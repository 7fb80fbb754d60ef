#pragma once
#include <cstdint>

namespace spanline {

/// Edges of a triangle as fixed-point columns, counted from its column of origin: a row step is one addition an edge.
/// Small triangles have 26 fraction bits (64 pixels wide at most), medium ones 24 (256 pixels).
struct FixedEdges {
  std::uint32_t left, right;            ///< columns of the current row
  std::uint32_t left_step, right_step;  ///< slopes
  std::uint32_t bend, bend_step;        ///< the third edge: replaces the left or the right one at its first row
};

}  // namespace spanline
