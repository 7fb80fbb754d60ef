// How depth sort keeps the polygons of a band, against lists that are sorted anew; and the sort by bytes.
#include "spanline/visibility/sort/band_members.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

#include "spanline/visibility/sort/sort_by_depth.hpp"
#include "support/effort.hpp"
#include "support/random.hpp"

namespace spanline::test {
namespace {

/// Links entries in an order that is given by their numbers. Output: the first.
template <class Entry>
Link linked(std::vector<Entry>& entries, const std::vector<Link>& order) {
  Link next = no_link;
  for (auto number = order.rbegin(); number != order.rend(); ++number) {
    entries[*number].next = next;
    next = *number;
  }
  return next;
}

std::vector<Link> counted(std::size_t count) {
  std::vector<Link> order(count);
  std::iota(order.begin(), order.end(), Link{0});
  return order;
}

TEST(SortByBytes, IsTheStableSort) {
  struct Entry {
    std::uint32_t key;
    Link next;
  };
  Random random(1);
  std::vector<Link> queues(radix_queues);
  for (int round = 0; round < rounds(2000); ++round) {
    const unsigned passes = static_cast<unsigned>(random.between(1, 4));
    const int most = random.chance(2) ? 5 : -1;
    std::vector<Entry> entries(static_cast<std::size_t>(random.between(0, 300)));
    for (Entry& entry : entries) {
      entry.key = static_cast<std::uint32_t>(random.wide(0, ~std::uint32_t{0})) >> (32 - 8 * passes);
      if (most > 0) entry.key = entry.key % static_cast<std::uint32_t>(most) * 0x01010101u;
    }
    std::vector<Link> want = counted(entries.size());
    const std::uint32_t mask = ~std::uint32_t{0} >> (32 - 8 * passes);
    std::vector<Link> got;
    Link first = linked(entries, want);
    std::stable_sort(want.begin(), want.end(),
                     [&](Link a, Link b) { return (entries[a].key & mask) < (entries[b].key & mask); });
    first = sort_by_bytes(entries.data(), first, passes, queues,
                          [](const Entry& entry, unsigned pass) { return entry.key >> (8 * pass) & 0xff; });
    for (; first != no_link; first = entries[first].next) got.push_back(first);
    ASSERT_EQ(got, want) << "round " << round;
  }
}

/// A frame of polygons with random boxes and depths, in bands.
class BandsOfMembers : public ::testing::Test {
 protected:
  static constexpr int columns = 100;

  void make(Random& random, std::uint32_t room, bool all_different) {
    // A row is a unit of boxes, or two are.
    height_ = random.between(1, 256);
    band_lines_ = random.between(1, std::min(height_, 20));
    scale_ = BoxScale(Viewport{columns, height_});
    polygons_.resize(static_cast<std::size_t>(random.between(0, 80)));
    std::vector<Link> order = counted(polygons_.size());
    for (std::size_t i = 0; i < polygons_.size(); ++i) {
      const int first = random.between(0, height_ - 1);
      int end = random.between(first + 1, height_);
      if (random.chance(2)) end = std::min(end, first + random.between(1, 12));
      polygons_[i].box = PackedBox(0, columns, first, end, scale_);
      polygons_[i].nearest = static_cast<std::uint16_t>(all_different ? i * 700 : i / 4 * 100);
      polygons_[i].farthest = 0xffff;
    }
    const Link first = linked(polygons_, order);
    Arena counting;
    bands_ = static_cast<std::uint32_t>((height_ + band_lines_ - 1) / band_lines_);
    members_.take(counting, room, bands_);
    memory_.assign(counting.size(), std::byte{0x5a});
    Arena arena(memory_);
    members_.take(arena, room, bands_);
    members_.begin_frame(polygons_.data(), first, scale_, band_lines_);
  }
  [[nodiscard]] int first_row(std::uint32_t band) const { return static_cast<int>(band) * band_lines_; }
  [[nodiscard]] int end_row(std::uint32_t band) const { return std::min(first_row(band) + band_lines_, height_); }
  void gather(std::uint32_t band) { members_.gather(static_cast<std::int32_t>(band), first_row(band), end_row(band)); }
  /// The polygons whose boxes reach into a band, the nearest first.
  [[nodiscard]] std::vector<Link> reaching(std::uint32_t band) const {
    std::vector<Link> all;
    for (std::size_t i = 0; i < polygons_.size(); ++i)
      if (polygons_[i].box.first_row(scale_) < end_row(band) && polygons_[i].box.end_row(scale_) > first_row(band))
        all.push_back(static_cast<Link>(i));
    return all;
  }
  [[nodiscard]] std::vector<Link> numbers() const {
    std::vector<Link> all;
    for (const BandMember* member = members_.begin(); member != members_.end(); ++member) all.push_back(member->number);
    return all;
  }
  /// As drawing does it: some are moved before others.
  void move_some(Random& random) {
    for (int i = random.between(0, 3); i > 0 && members_.count() > 1; --i) {
      const auto from = random.between(0, static_cast<int>(members_.count()) - 1), to = random.between(0, from);
      std::rotate(members_.begin() + to, members_.begin() + from, members_.begin() + from + 1);
    }
  }

  int height_ = 0, band_lines_ = 0;
  std::uint32_t bands_ = 0;
  BoxScale scale_;
  std::vector<SortedPolygon> polygons_;
  std::vector<std::byte> memory_;
  BandMembers members_;
};

TEST_F(BandsOfMembers, AreSortedInEveryBandWhateverWasMovedAbove) {
  Random random(2);
  for (int round = 0; round < rounds(3000); ++round) {
    make(random, 80, round % 2 == 0);
    std::uint32_t most = 0;
    for (std::uint32_t band = 0; band < bands_; ++band) {
      gather(band);
      std::vector<Link> got = numbers(), want = reaching(band);
      ASSERT_TRUE(std::is_sorted(got.begin(), got.end(),
                                 [&](Link a, Link b) { return polygons_[a].nearest < polygons_[b].nearest; }))
          << "round " << round << ", band " << band;
      for (const BandMember* member = members_.begin(); member != members_.end(); ++member)
        ASSERT_EQ(member->nearest, polygons_[member->number].nearest);
      std::sort(got.begin(), got.end());
      ASSERT_EQ(got, want) << "round " << round << ", band " << band;
      most = std::max(most, members_.count());
      move_some(random);
    }
    ASSERT_EQ(members_.wanted(), most);
    ASSERT_FALSE(members_.overflowed());
  }
}

TEST_F(BandsOfMembers, OfAFullPoolAreTheNearestAndTheFarthestComeBackInTheNextBand) {
  Random random(3);
  int overflows = 0, came_back = 0;
  for (int round = 0; round < rounds(6000); ++round) {
    const auto room = static_cast<std::uint32_t>(random.between(0, 20));
    make(random, room, true);
    std::size_t most = 0;
    std::vector<Link> left_out;
    for (std::uint32_t band = 0; band < bands_; ++band) {
      gather(band);
      std::vector<Link> want = reaching(band);
      most = std::max(most, want.size());
      std::vector<Link> waits;
      while (want.size() > room) {
        waits.push_back(want.back());
        want.pop_back();
      }
      ASSERT_EQ(numbers(), want) << "round " << round << ", band " << band << ", room for " << room;
      for (const Link number : want) came_back += static_cast<int>(std::ranges::count(left_out, number));
      left_out = waits;
      move_some(random);
    }
    ASSERT_EQ(members_.wanted(), most) << "room for " << room;
    ASSERT_EQ(members_.overflowed(), most > room);
    overflows += most > room ? 1 : 0;
  }
  EXPECT_GT(overflows, rounds(6000) / 4);
  EXPECT_GT(came_back, rounds(6000) / 4);
}

}  // namespace
}  // namespace spanline::test
