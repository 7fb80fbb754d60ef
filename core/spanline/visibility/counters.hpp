#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace spanline {

/// What a visibility algorithm did in a frame, for `--stats` and the viewer. Every algorithm keeps the first three
/// counters. `own` holds further counters of the algorithm, whose names are its `counter_names`, in the same order.
struct VisibilityCounters {
  static constexpr std::size_t most_own = 16;  ///< greatest number of counters of an algorithm's own

  std::uint64_t spans = 0;                    ///< runs of pixels handed to shading or to the depth test
  std::uint64_t pixels = 0;                   ///< pixels of polygons written
  std::uint64_t depth_tests = 0;              ///< depth comparisons
  std::uint64_t own[most_own] = {};           ///< the algorithm's own counters
  std::span<const std::string_view> names{};  ///< the names of the counters in `own`; set when a frame begins

  /// The value of the algorithm's own counter of that name; 0 if there is none.
  [[nodiscard]] constexpr std::uint64_t named(std::string_view name) const {
    for (std::size_t i = 0; i < names.size(); ++i)
      if (names[i] == name) return own[i];
    return 0;
  }
};

}  // namespace spanline
