#pragma once
#include <algorithm>
#include <cstdint>

#include "spanline/raster/gradients.hpp"
#include "spanline/raster/link.hpp"
#include "spanline/raster/polygon_table.hpp"

namespace spanline {

/// The exact number of entries that a frame needs in the pool of active polygons. It repeats the order of drawing: in
/// each band polygons come in order of submission, and one that continues below takes an entry before later ones that
/// end free theirs. This takes time proportional to polygons × bands and is called only after a pool was full.
[[nodiscard]] inline std::uint32_t active_polygons_needed(const PolygonTable& table, Viewport viewport,
                                                          std::int32_t band_lines) {
  std::uint32_t greatest = 0;
  std::uint32_t live = 0;  // polygons that reach across the upper edge of the band
  for (std::int32_t top = 0; top < viewport.height; top += band_lines) {
    const std::int32_t bottom = std::min(top + band_lines, viewport.height);
    Link group = 0;
    for (Link polygon = 0; polygon < table.polygon_count; ++polygon) {
      group = table.group_of(polygon, group);
      const RowRange rows = row_range({table, table.groups[group], polygon});
      const std::int32_t first = std::max<std::int32_t>(rows.first, 0), end = std::min(rows.end, viewport.height);
      const bool comes_in = first < top && end > top;
      const bool goes_on = end > bottom;
      if (first >= top && first < bottom && goes_on) greatest = std::max(greatest, ++live);
      if (comes_in && !goes_on) --live;
    }
  }
  return greatest;
}

}  // namespace spanline
