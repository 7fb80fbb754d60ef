#pragma once
#include <algorithm>
#include <cstdint>

#include "spanline/raster/gradients.hpp"
#include "spanline/raster/link.hpp"
#include "spanline/raster/polygon_table.hpp"

namespace spanline {

/// The greatest number of opaque, or of see-through, polygons on any row: the entries that a pool of awake polygons
/// needs if none of them sleeps. This takes time proportional to polygons × rows and is called only after a pool was
/// full.
[[nodiscard]] inline std::uint32_t polygons_on_rows(const PolygonTable& table, Viewport viewport,
                                                    bool see_through = false) {
  std::uint32_t most = 0;
  for (std::int32_t row = 0; row < viewport.height; ++row) {
    std::uint32_t here = 0;
    Link group = 0;
    for (Link polygon = 0; polygon < table.polygon_count; ++polygon) {
      group = table.group_of(polygon, group);
      if (table.groups[group].see_through != see_through) continue;
      const RowRange rows = row_range({table, table.groups[group], polygon});
      if (rows.first <= row && row < rows.end) ++here;
    }
    most = std::max(most, here);
  }
  return most;
}

}  // namespace spanline
