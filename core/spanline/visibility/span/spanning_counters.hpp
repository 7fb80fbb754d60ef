#pragma once
#include <string_view>

namespace spanline {

/// The spanning scan line's own counters: their indices in VisibilityCounters::own.
struct SpanningCounter {
  enum Place : unsigned {
    shaded,         ///< all pixels written, including the background
    decisions,      ///< visibility decisions: polygons that begin on a row
    crossings,      ///< false edges: columns where polygons cross inside a span
    order_repairs,  ///< exchanges in the order of polygons from one row to the next
    sleeps          ///< times that a polygon was put to sleep
  };
};

inline constexpr std::string_view spanning_counter_names[] = {"shaded", "decisions", "crossings", "order_repairs",
                                                              "sleeps"};

}  // namespace spanline
