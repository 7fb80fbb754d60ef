#pragma once
#include <cstdint>

#include "spanline/raster/gradients.hpp"
#include "spanline/raster/linear_function.hpp"
#include "spanline/raster/polygon_table.hpp"
#include "spanline/visibility/counters.hpp"
#include "spanline/visibility/screen_surface.hpp"
#include "spanline/visibility/sort/depth_sort_counters.hpp"
#include "spanline/visibility/sort/overlap_tests.hpp"
#include "spanline/visibility/span/awake_polygon.hpp"

namespace spanline {

/// A polygon's number and its plane, which is computed when it is first needed; smaller is nearer.
template <class Depth>
class NumberedPlane {
 public:
  void set(Link number) {
    number_ = number;
    has_plane_ = false;
  }
  [[nodiscard]] Link number() const { return number_; }
  [[nodiscard]] bool has_plane() const { return has_plane_; }
  [[nodiscard, gnu::always_inline]] const LinearFunction& plane(const PolygonSource& source) {
    if (!has_plane_) make(source);
    return plane_;
  }

 private:
  [[gnu::noinline]] void make(const PolygonSource& source) {
    using Smaller = DepthFormat<Depth::bits, typename Depth::Word, DepthSense::smaller_is_nearer>;
    const PolygonEntry entry{source.table, source.table.groups[source.table.find_group(number_)], number_};
    plane_ = plane_equation_of(entry, entry.corners(), entry.is_outline(), source.viewport).template depth<Smaller>();
    has_plane_ = true;
  }

  LinearFunction plane_;
  Link number_;
  bool has_plane_;
};

/// Where a polygon Q lies relative to a polygon P.
enum class PairOrder : std::uint8_t {
  apart,     ///< they share no pixel
  behind,    ///< Q is behind P wherever both are
  in_front,  ///< Q is in front of P wherever both are
  unknown,   ///< each may hide a part of the other
};

/// Decides the order of pairs by the overlap tests, those apart that the packed boxes have decided.
template <class Depth, bool Counting>
class PairTests {
 public:
  using Plane = NumberedPlane<Depth>;

  /// Starts with a polygon P.
  void begin(const PolygonSource& source, Link number) {
    front_.set(entry(source, number));
    plane_.set(number);
  }
  [[nodiscard]] Plane& front() { return plane_; }

  /// Tests another polygon Q, whose plane is computed if a test needs it. `p_is_nearer` says which of them the sort
  /// takes for the nearer one; the counters' names depend on that.
  [[nodiscard, gnu::noinline]] PairOrder test(const PolygonSource& source, Plane& other,
                                              [[maybe_unused]] bool p_is_nearer,
                                              [[maybe_unused]] VisibilityCounters* counters) {
    using Counter = DepthSortCounter;
    const auto decided = [&]([[maybe_unused]] Counter::Place if_nearer, [[maybe_unused]] Counter::Place if_farther,
                             PairOrder order) {
      if constexpr (Counting) ++counters->own[p_is_nearer ? if_nearer : if_farther];
      return order;
    };
    const PolygonEntry q = entry(source, other.number());
    const bool outline = q.is_outline();
    if (outline) other_.set(q);
    const PolygonCorners corners = outline ? PolygonCorners{} : q.corners();
    if (outline ? !front_.projections_may_overlap(other_) : !front_.projections_may_overlap(corners))
      return decided(Counter::projections, Counter::projections, PairOrder::apart);
    const std::int32_t doubt = doubt_of(source.viewport);
    const bool narrow = !outline && front_.is_narrow_with(corners);
    if (!outline) other_.set(corners);
    const PlaneSide of_q = narrow ? front_.narrow_side_of(corners, doubt) : front_.side_of(other_, doubt);
    if (of_q == PlaneSide::mixed) {
      const PlaneSide of_p =
          narrow ? front_.narrow_side_from(corners, doubt) : side_of_plane(front_.polygon(), other_, doubt);
      if (of_p == PlaneSide::in_front)
        return decided(Counter::in_front_of_plane, Counter::swapped_in_front, PairOrder::behind);
      if (of_p == PlaneSide::behind)
        return decided(Counter::swapped_behind, Counter::behind_plane, PairOrder::in_front);
      return PairOrder::unknown;
    }
    return of_q == PlaneSide::behind
               ? decided(Counter::behind_plane, Counter::swapped_behind, PairOrder::behind)
               : decided(Counter::swapped_in_front, Counter::in_front_of_plane, PairOrder::in_front);
  }

 private:
  [[nodiscard]] static PolygonEntry entry(const PolygonSource& source, Link number) {
    return {source.table, source.table.groups[source.table.find_group(number)], number};
  }
  /// How far the planes of pixels may lie from those through the corners, in units of 24 bits, for both polygons
  /// together: half a guard unit for each pixel of the way across the picture, and a unit of rounding for each, or one
  /// of 16 bits where the set-up of small triangles is as coarse as that.
  [[nodiscard]] static std::int32_t doubt_of(Viewport viewport) {
    constexpr std::int32_t rounding = Depth::bits == 16 ? 2 << 8 : 2;
    return rounding + ((viewport.width + viewport.height + 255) >> 8);
  }

  TestedFront front_;
  TestedPolygon other_;
  Plane plane_;
};

}  // namespace spanline
