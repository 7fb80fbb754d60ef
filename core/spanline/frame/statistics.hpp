#pragma once
/// @file
/// Counts of a frame.
///
/// ```cpp
/// const PolygonCounts polygons = renderer.statistics().polygons;
/// const std::uint32_t submitted = polygons.total - polygons.outside - polygons.back;
/// ```
#include "spanline/geometry/polygon_assembly.hpp"
#include "spanline/visibility/counters.hpp"

namespace spanline {

/// Counts of a frame: its polygons, and the work of the visibility algorithm if the traits ask for statistics.
struct Statistics {
  PolygonCounts polygons;         ///< how many were submitted, and how many were left out and why
  VisibilityCounters visibility;  ///< work of the visibility algorithm; zeros without statistics
};

}  // namespace spanline
