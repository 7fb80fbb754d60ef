#pragma once
#include <string_view>

namespace spanline {

/// The counters of the spanning scan line's own, by their place in VisibilityCounters::own.
struct SpanningCounter {
  enum Place : unsigned {
    shaded,         ///< all pixels written, the background's too
    decisions,      ///< visibility decisions, one a span that begins or comes back to the front
    crossings,      ///< false edges, where polygons cross inside a span
    order_repairs,  ///< polygons that changed places from one row to the next
    sleeps          ///< polygons that slept behind another
  };
};

inline constexpr std::string_view spanning_counter_names[] = {"shaded", "decisions", "crossings", "order_repairs",
                                                              "sleeps"};

}  // namespace spanline
