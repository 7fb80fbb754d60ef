#pragma once
#include <cstdint>

#include "spanline/raster/active_triangle.hpp"
#include "spanline/raster/gradients.hpp"
#include "spanline/raster/outline_header.hpp"

namespace spanline {

/// Places the two edges of an outline that lie on its current row, which is one of its rows, and counts the rows until
/// one of them ends. Called where rows_to_knee is 0 and rows_after_knee is not.
void place_outline_edges(const PlacedOutline& outline, ActiveTriangle& active);

/// Steps an outline over its rows above `end_row` (biased), but not its surface, which the caller steps over as many
/// rows. False if it ends above `end_row`; then nothing is changed.
[[nodiscard]] bool skip_outline_rows(ActiveTriangle& outline, std::int32_t end_row, const PlacedOutline& placed);

/// Sets up the edges of a convex outline on the biased rows [first, end), which are some of its own, with the words
/// that the edges of triangles have: each run begins and ends at the pixels of the top-left rule. `depth` is left
/// alone.
void set_up_rows(const PlacedOutline& outline, std::int32_t first, std::int32_t end, ActiveTriangle& active);

/// The same on its rows in the viewport, from `first_row` (biased) on. False if it has no rows there.
[[nodiscard]] bool set_up_outline(const PlacedOutline& outline, const Viewport& viewport, ActiveTriangle& active,
                                  std::int32_t first_row = row_bias);

}  // namespace spanline
