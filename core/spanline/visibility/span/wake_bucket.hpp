#pragma once
#include <cstdint>

#include "spanline/raster/link.hpp"
#include "spanline/visibility/span/active_edge_table.hpp"

namespace spanline {

/// Wakes the polygons in the bucket of `row`: those that begin there, and those that slept or were left out. They enter
/// the active-edge table, which has not been stepped to the row yet. False if there were not enough records. The
/// farthest polygons (of equally far ones, the latest) are then left out and wake on the next row.
[[nodiscard]] bool wake_bucket(ActiveEdgeTable& edges, const PolygonSource& source, std::int32_t row,
                               BoundMargin margin);

/// Whether all opaque polygons found room, and the first layer that did not, or no_link. Further waiting layers are
/// linked by the polygon table's references.
struct WokenWithLayers {
  bool all_opaque;
  Link waiting;
};

/// As above, but polygons of see-through groups enter the table `layers`. If that is full, the nearest (of equally near
/// ones, the earliest) have to wait, since they must be drawn after the others.
[[nodiscard]] WokenWithLayers wake_bucket(ActiveEdgeTable& edges, ActiveEdgeTable& layers, const PolygonSource& source,
                                          std::int32_t row, BoundMargin margin);

/// Wakes a chain of waiting layers on the same row, after `layers` was emptied by `stand_back`. Output: the chain of
/// those that still have to wait.
[[nodiscard]] Link wake_waiting(ActiveEdgeTable& layers, const PolygonSource& source, Link waiting, std::int32_t row,
                                BoundMargin margin);

/// Puts a chain of waiting layers into the bucket of the next row.
void defer_waiting(const PolygonSource& source, Link waiting, std::int32_t row);

}  // namespace spanline
