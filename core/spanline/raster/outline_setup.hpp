#pragma once
#include <cstdint>

#include "spanline/raster/active_triangle.hpp"
#include "spanline/raster/gradients.hpp"
#include "spanline/raster/outline.hpp"

namespace spanline {

/// Sets up the edges of a convex outline on its first row inside the viewport, with the words that the edges of
/// triangles have: each run begins and ends at the pixels of the top-left rule. `depth` is left alone. `turn` is not
/// Turn::none. False if the outline has no rows in the viewport.
[[nodiscard]] bool set_up_outline(const Outline& outline, Turn turn, bool scissored, Viewport viewport,
                                  ActiveTriangle& active);

/// Places the two edges of an outline that lie on its current row, which is one of its rows, and counts the rows until
/// one of them ends. Called where rows_to_knee is 0 and rows_after_knee is not.
void place_outline_edges(const Outline& outline, ActiveTriangle& active);

}  // namespace spanline
