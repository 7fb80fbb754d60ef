#pragma once
#include <cstdint>

#include "spanline/visibility/span/active_edge_table.hpp"

namespace spanline {

/// Wakes the polygons in the bucket of `row`: those that begin there, and those that slept or stood back. They enter
/// the active-edge table, which has not been stepped to the row yet. False where there were more than records: the
/// farthest are then left out, of equally far ones the latest, and try again on the next row.
[[nodiscard]] bool wake_bucket(ActiveEdgeTable& edges, const PolygonSource& source, std::int32_t row,
                               BoundMargin margin);

/// Whether there was room for all that woke.
struct WokenWithLayers {
  bool all_opaque, all_layers;
};

/// The same, where polygons of see-through groups enter a table of their own.
[[nodiscard]] WokenWithLayers wake_bucket(ActiveEdgeTable& edges, ActiveEdgeTable& layers, const PolygonSource& source,
                                          std::int32_t row, BoundMargin margin);

}  // namespace spanline
