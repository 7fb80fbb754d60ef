#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace spanline {

/// What a visibility algorithm did in a frame, where it counts (`--stats`, the viewer). The first three every algorithm
/// has; `own` is a table of the algorithm's own, whose names stand in its `counter_names`, in the same order.
struct VisibilityCounters {
  static constexpr std::size_t most_own = 16;

  std::uint64_t spans = 0;        ///< runs of pixels handed to shading or to the depth test
  std::uint64_t pixels = 0;       ///< pixels of polygons written
  std::uint64_t depth_tests = 0;  ///< depth comparisons
  std::uint64_t own[most_own] = {};
  std::span<const std::string_view> names{};  ///< of `own`, one each; set when a frame begins

  /// The number of a counter among the algorithm's own; 0 where it has none of that name.
  [[nodiscard]] constexpr std::uint64_t named(std::string_view name) const {
    for (std::size_t i = 0; i < names.size(); ++i)
      if (names[i] == name) return own[i];
    return 0;
  }
};

}  // namespace spanline
