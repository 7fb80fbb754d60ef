#pragma once
#include <algorithm>
#include <cstdint>

#include "spanline/raster/gradients.hpp"
#include "spanline/raster/polygon_table.hpp"

namespace spanline {

/// The number of entries that a pool of active polygons would need: the greatest number of polygons that reach across
/// one band's lower edge. Linear in polygons × bands, and asked only after a pool has run full.
[[nodiscard]] inline std::uint32_t active_polygons_needed(const PolygonTable& table, Viewport viewport,
                                                          std::int32_t band_lines) {
  std::uint32_t greatest = 0;
  for (std::int32_t edge = band_lines; edge < viewport.height; edge += band_lines) {
    std::uint32_t crossing = 0;
    Link group = 0;
    for (Link polygon = 0; polygon < table.polygon_count; ++polygon) {
      group = table.group_of(polygon, group);
      const PolygonCorners p = table.corners(table.groups[group], polygon);
      const auto [top, bottom] = std::minmax({p.corner[0]->y, p.corner[1]->y, p.corner[2]->y});
      if (row_at(top) - row_bias < edge && row_at(bottom) - row_bias > edge) ++crossing;
    }
    greatest = std::max(greatest, crossing);
  }
  return greatest;
}

}  // namespace spanline
