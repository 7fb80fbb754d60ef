#pragma once
#include <algorithm>
#include <cstdint>

#include "spanline/raster/active_triangle.hpp"
#include "spanline/raster/fan_diagonals.hpp"
#include "spanline/raster/gradients.hpp"
#include "spanline/raster/outline_setup.hpp"
#include "spanline/raster/polygon_table.hpp"
#include "spanline/raster/row_columns.hpp"
#include "spanline/raster/row_stepper.hpp"

namespace spanline {

/// Calls covered(id) for each triangle of an outline's fan that covers a pixel centre of the viewport on `first_row`
/// (biased) or below. The fan's first triangle has the id `first_id`. For statistics.
template <class Covered>
void tell_covered(const PolygonEntry& entry, Viewport viewport, std::int32_t first_row, std::uint32_t first_id,
                  Covered& covered) {
  ActiveTriangle outline;
  if (!set_up_outline(entry.outline(), viewport, outline, first_row)) return;
  const FanDiagonals fan(entry.outline());
  std::uint32_t seen = 0;
  while (outline.rows_to_knee + outline.rows_after_knee > 0) {
    const std::int32_t row = outline.row - row_bias;
    RowColumns columns = step_row(outline, [&] { return entry; });
    columns.first = std::max<std::int32_t>(outline.origin + columns.first, 0);
    columns.end = std::min(outline.origin + columns.end, viewport.width);
    fan.for_each_part(columns, row, [&](unsigned number, RowColumns) { seen |= 1u << number; });
  }
  for (unsigned i = 0; i <= fan.count; ++i)
    if ((seen >> i & 1) != 0) covered(first_id + i);
}

}  // namespace spanline
