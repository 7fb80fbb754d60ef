#pragma once
#include <cstdint>
#include <span>

#include "spanline/memory/arena.hpp"
#include "spanline/memory/capacity.hpp"
#include "spanline/raster/link.hpp"
#include "spanline/visibility/sort/packed_box.hpp"

namespace spanline {

/// A polygon of the frame, sorted by its nearest depth. Depths are the upper 16 bits of plane words, rounded so that
/// the polygon's pixels lie between them.
struct SortedPolygon {
  std::uint16_t nearest, farthest;
  Link next;  ///< in a list of polygons
  PackedBox box;

  /// Complements the depths, so that a list with the nearest first is one with the farthest first.
  void turn_round() {
    const std::uint16_t old_nearest = nearest;
    nearest = static_cast<std::uint16_t>(~farthest);
    farthest = static_cast<std::uint16_t>(~old_nearest);
  }
};

/// A polygon that reaches into the band that is being drawn.
struct BandMember {
  PackedBox box;
  std::uint16_t nearest;
  Link number;
};

/// The polygons of a band, the nearest first: those that continue from the band above, merged with those that begin in
/// this one. If there are more than the pool holds, the farthest are left out; they try again in the next band. Where
/// depths are complemented (layers), nearest and farthest change places.
class BandMembers {
 public:
  constexpr void take(Arena& arena, std::uint32_t members, std::uint32_t bands) {
    members_ = arena.take<BandMember>(members + 1);
    beginning_ = arena.take<Link>(bands);
  }

  /// Starts a frame whose sorted polygons are linked from `first` on, the nearest first. `band_lines` is the height of
  /// a band.
  void begin_frame(SortedPolygon* polygons, Link first, BoxScale scale, std::int32_t band_lines);
  /// Gathers the members of a band with the rows [first_row, end_row), not biased. Bands come from top to bottom.
  void gather(std::int32_t band, std::int32_t first_row, std::int32_t end_row);

  [[nodiscard]] BandMember* begin() const { return members_.data(); }
  [[nodiscard]] BandMember* end() const { return members_.data() + count_; }
  [[nodiscard]] std::uint32_t count() const { return count_; }

  /// The end of the members from `first` on whose nearest depth is at most `depth`.
  [[nodiscard, gnu::always_inline]] BandMember* end_at(BandMember* first, std::uint16_t depth) const {
    constexpr std::ptrdiff_t few = 12;
    BandMember* const end_of_all = end();
    if (end_of_all - first >= few && first[few - 1].nearest <= depth) return end_after(first + few, depth);
    while (first != end_of_all && first->nearest <= depth) ++first;
    return first;
  }

  /// The most members that a band had or wanted, and whether some found no room.
  [[nodiscard]] std::uint32_t wanted() const { return wanted_; }
  [[nodiscard]] bool overflowed() const { return wanted_ > capacity(); }
  [[nodiscard]] std::size_t peak_bytes() const {
    return (overflowed() ? capacity() : wanted_) * sizeof(BandMember) + beginning_.size_bytes();
  }

 private:
  [[nodiscard]] std::uint32_t capacity() const {
    return members_.empty() ? 0 : static_cast<std::uint32_t>(members_.size() - 1);
  }
  /// As end_at, by steps that grow and shrink.
  [[nodiscard]] BandMember* end_after(BandMember* first, std::uint16_t depth) const;
  void keep_those_that_reach(std::int32_t first_row);
  void merge_waiting(std::int32_t band);

  std::span<BandMember> members_{};  ///< with one place more than there are members
  std::span<Link> beginning_{};      ///< the farthest polygon that begins in each band
  SortedPolygon* polygons_ = nullptr;
  BoxScale scale_;
  std::uint32_t count_ = 0, wanted_ = 0;
  Link waiting_ = no_link;  ///< those left out of the band above that reach into this one, the farthest first
};

}  // namespace spanline
