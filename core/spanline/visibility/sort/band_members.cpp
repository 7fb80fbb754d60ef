#include "spanline/visibility/sort/band_members.hpp"

#include "spanline/raster/band_of_row.hpp"
#include "spanline/visibility/sort/sorted_bands.hpp"

namespace spanline {

void BandMembers::begin_frame(SortedPolygon* polygons, Link first, BoxScale scale, std::int32_t band_lines) {
  polygons_ = polygons;
  scale_ = scale;
  count_ = wanted_ = 0;
  waiting_ = no_link;
  const BandOfRow band_of_row(word(band_lines));
  deal_to_bands(polygons, first, beginning_,
                [&](const SortedPolygon& polygon) { return band_of_row(polygon.box.first_row(scale)); });
}

/// Also sorts them again, since drawing may have moved some before others.
void BandMembers::keep_those_that_reach(std::int32_t first_row) {
  std::uint32_t kept = 0;
  for (std::uint32_t i = 0; i < count_; ++i) {
    const BandMember member = members_[i];
    if (member.box.end_row(scale_) <= first_row) continue;
    std::uint32_t place = kept++;
    for (; place > 0 && members_[place - 1].nearest > member.nearest; --place) members_[place] = members_[place - 1];
    members_[place] = member;
  }
  count_ = kept;
}

void BandMembers::merge_waiting(std::int32_t band) {
  Link* link = &beginning_[static_cast<std::size_t>(band)];
  while (waiting_ != no_link) {
    SortedPolygon& polygon = polygons_[waiting_];
    while (*link != no_link && polygons_[*link].nearest > polygon.nearest) link = &polygons_[*link].next;
    const Link next = polygon.next;
    polygon.next = *link;
    *link = waiting_;
    link = &polygon.next;
    waiting_ = next;
  }
}

BandMember* BandMembers::end_after(BandMember* first, std::uint16_t depth) const {
  std::ptrdiff_t step = 8;
  while (step <= end() - first && first[step - 1].nearest <= depth) {
    first += step;
    step += step;
  }
  for (step >>= 1; step > 0; step >>= 1)
    if (step <= end() - first && first[step - 1].nearest <= depth) first += step;
  return first;
}

void BandMembers::gather(std::int32_t band, std::int32_t first_row, std::int32_t end_row) {
  keep_those_that_reach(first_row);
  if (waiting_ != no_link) merge_waiting(band);
  std::uint32_t old = count_, place = count_;
  for (Link number = beginning_[static_cast<std::size_t>(band)]; number != no_link; number = polygons_[number].next)
    ++place;
  if (place > wanted_) wanted_ = place;
  count_ = place < capacity() ? place : capacity();

  // From the back, so that no member is overwritten before it has moved. What lies beyond the pool waits.
  Link* waits = &waiting_;
  const auto put = [&](const BandMember& member) {
    if (--place < count_) {
      members_[place] = member;
      return;
    }
    if (member.box.end_row(scale_) <= end_row) return;
    *waits = member.number;
    waits = &polygons_[member.number].next;
  };
  for (Link number = beginning_[static_cast<std::size_t>(band)]; number != no_link;) {
    const SortedPolygon polygon = polygons_[number];
    while (old > 0 && members_[old - 1].nearest > polygon.nearest) put(members_[--old]);
    put({polygon.box, polygon.nearest, number});
    number = polygon.next;
  }
  // The members that are left are in their places already.
  *waits = no_link;
}

}  // namespace spanline
