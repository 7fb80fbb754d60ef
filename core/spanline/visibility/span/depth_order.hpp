#pragma once
#include <cstdint>

#include "spanline/visibility/band_target.hpp"
#include "spanline/visibility/counters.hpp"
#include "spanline/visibility/span/awake_polygon.hpp"

namespace spanline {

/// Decides which of two polygons is in front at a pixel of the row given to `move_to`: the nearer one, and of equally
/// near ones the one that was submitted first. This is a strict total order. Bounds decide first; only where they
/// overlap are planes computed and compared.
/// `crossings` is the place of the counter for `crossing` among the algorithm's own.
template <class Depth, bool Counting, unsigned crossings>
class DepthOrder {
 public:
  DepthOrder(const PolygonSource& source, [[maybe_unused]] VisibilityCounters* counters)
      : source_(source), counters_(counters) {}

  void move_to(std::int32_t row) { row_ = row; }

  [[nodiscard]] bool in_front(AwakePolygon& a, AwakePolygon& b, std::int32_t column) {
    if (a.nearest > b.farthest) return false;
    if (a.farthest < b.nearest) return true;
    return nearer(a, b, column);
  }

  /// Whether `a` is in front of `b` at `column`, decided by the planes without the bounds.
  [[nodiscard]] bool nearer(AwakePolygon& a, AwakePolygon& b, std::int32_t column) {
    if (!a.has_plane) make_plane<Depth>(a, source_);
    if (!b.has_plane) make_plane<Depth>(b, source_);
    if constexpr (Counting) ++counters_->depth_tests;
    const std::uint32_t depth_a = a.depth_at(column, row_), depth_b = b.depth_at(column, row_);
    return depth_a < depth_b || (depth_a == depth_b && a.number < b.number);
  }

  /// The first column where `other` is in front, given that `front` is in front at `low` and `other` at `high`. Found
  /// by bisection, which needs no division. Both polygons have planes.
  [[nodiscard, gnu::noinline]] std::int32_t crossing(const AwakePolygon& front, const AwakePolygon& other,
                                                     std::int32_t low, std::int32_t high) {
    if constexpr (Counting) ++counters_->own[crossings];
    const std::uint32_t depth_front = front.depth_at(0, row_), depth_other = other.depth_at(0, row_);
    const bool wins_ties = other.number < front.number;
    while (high - low > 1) {
      const std::int32_t middle = (low + high) >> 1;
      const std::uint32_t f = depth_front + front.plane.dx * word(middle),
                          o = depth_other + other.plane.dx * word(middle);
      (o < f || (o == f && wins_ties) ? high : low) = middle;
    }
    return high;
  }

 private:
  const PolygonSource& source_;
  std::int32_t row_ = 0;  ///< row of the picture on which polygons are compared, not biased
  VisibilityCounters* counters_;
};

}  // namespace spanline
