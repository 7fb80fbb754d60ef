#pragma once
#include <cstdint>

namespace spanline {

/// Counters of what a visibility algorithm did (--stats).
struct VisibilityCounters {
  std::uint64_t spans = 0;        ///< runs of pixels handed to shading or to the depth test
  std::uint64_t pixels = 0;       ///< pixels of polygons written
  std::uint64_t depth_tests = 0;  ///< depth comparisons
  std::uint64_t shaded = 0;       ///< spanning: all pixels written, the background's too
  std::uint64_t decisions = 0;    ///< spanning: visibility decisions, one a span that begins or comes back to the front
  std::uint64_t crossings = 0;    ///< spanning: false edges, where polygons cross inside a span
  std::uint64_t order_repairs = 0;  ///< spanning: polygons that changed places from one row to the next
  std::uint64_t sleeps = 0;         ///< spanning: polygons that slept behind another
};

}  // namespace spanline
