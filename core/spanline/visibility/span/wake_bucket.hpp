#pragma once
#include <cstdint>

#include "spanline/raster/link.hpp"
#include "spanline/visibility/span/active_edge_table.hpp"

namespace spanline {

/// Wakes the polygons in the bucket of `row`: those that begin there, and those that slept or stood back. They enter
/// the active-edge table, which has not been stepped to the row yet. False where there were more than records: the
/// farthest are then left out, of equally far ones the latest, and try again on the next row.
[[nodiscard]] bool wake_bucket(ActiveEdgeTable& edges, const PolygonSource& source, std::int32_t row,
                               BoundMargin margin);

/// Whether there was room for all that woke, and the first of the layers for which there was not, or no_link: a chain
/// by the polygon table's references.
struct WokenWithLayers {
  bool all_opaque;
  Link waiting;
};

/// The same, where polygons of see-through groups enter a table of their own. Of those the nearest have to wait, of
/// equally near ones the earliest: they are to be laid over the others.
[[nodiscard]] WokenWithLayers wake_bucket(ActiveEdgeTable& edges, ActiveEdgeTable& layers, const PolygonSource& source,
                                          std::int32_t row, BoundMargin margin);

/// Wakes a chain of waiting layers on the row itself, where `layers` has stood back. Output: those that have to wait
/// again.
[[nodiscard]] Link wake_waiting(ActiveEdgeTable& layers, const PolygonSource& source, Link waiting, std::int32_t row,
                                BoundMargin margin);

/// Puts a chain of waiting layers into the bucket of the next row.
void defer_waiting(const PolygonSource& source, Link waiting, std::int32_t row);

}  // namespace spanline
