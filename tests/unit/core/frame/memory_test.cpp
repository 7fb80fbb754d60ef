// The caller's memory: bytes_needed is enough at any alignment, and less is refused.
#include <gtest/gtest.h>
#include <spanline/frame/ready_made_traits.hpp>

#include <vector>

#include "support/effort.hpp"
#include "support/random.hpp"
#include "support/ready_made_studios.hpp"

namespace spanline::test {
namespace {

using R = Renderer<GouraudTraits<Rgb565, Depth16<>>>;

Capacity some_capacity(Random& random) {
  Capacity c;
  c.width = static_cast<std::uint16_t>(random.between(1, 100));
  c.height = static_cast<std::uint16_t>(random.between(1, 100));
  c.band_lines = static_cast<std::uint16_t>(random.between(1, c.height));
  c.colour_bands = static_cast<std::uint8_t>(random.between(1, 16));
  c.depth_bands = static_cast<std::uint8_t>(random.between(1, 2));
  for (std::uint32_t* pool : {&c.instances, &c.vertices, &c.shades, &c.polygons, &c.fans, &c.active})
    *pool = static_cast<std::uint32_t>(random.between(0, 30));
  return c;
}

static_assert(R::bytes_needed({.width = 128, .height = 64, .band_lines = 8, .polygons = 100}) < 16384,
              "a board can hold its budget at compile time");

TEST(Memory, ARendererWithoutAnyPolygonsTakesItsBandsAndNothingElse) {
  // Two colour bands and a depth band of 16 words each, two buckets, and 7 bytes to find an address of 8.
  constexpr Capacity bands_alone{.width = 8, .height = 4, .band_lines = 2, .instances = 0};
  constexpr std::size_t bands = 3 * 16 * 2, buckets = 2 * sizeof(Link);
  EXPECT_EQ(Renderer<FlatTraits<>>::bytes_needed(bands_alone), bands + buckets + 7);
  EXPECT_EQ(Renderer<GeneralTraits<>>::bytes_needed(bands_alone), bands + buckets + 7);
}

TEST(Memory, BytesNeededIsEnoughAtEveryAlignment) {
  Random random(1);
  for (int i = 0; i < rounds(300); ++i) {
    const Capacity c = some_capacity(random);
    const std::size_t needed = R::bytes_needed(c);
    std::vector<std::byte> memory(needed + 8);
    for (std::size_t shift = 0; shift < 8; ++shift)
      ASSERT_TRUE(R(c, std::span(memory).subspan(shift, needed)).status().ok()) << shift;
  }
}

TEST(Memory, OneByteLessIsRefusedAndTheSizeNamed) {
  Random random(2);
  for (int i = 0; i < rounds(300); ++i) {
    const Capacity c = some_capacity(random);
    const std::size_t needed = R::bytes_needed(c);
    std::vector<std::uint64_t> words(needed / 8 + 2);
    const auto memory = std::as_writable_bytes(std::span(words));
    // The worst alignment takes all of bytes_needed; the best leaves 7 bytes unused.
    const Status worst = R(c, memory.subspan(1, needed - 1)).status();
    EXPECT_EQ(worst, (Status{Fault::pool_full, Pool::memory, static_cast<std::uint32_t>(needed)}));
    EXPECT_TRUE(R(c, memory.first(needed - 7)).status().ok());
    EXPECT_EQ(R(c, memory.first(needed - 8)).status().pool, Pool::memory);
  }
}

TEST(Memory, NoneAtAllIsRefused) {
  EXPECT_EQ(R(Capacity{}, {}).status().pool, Pool::memory);
  std::byte one{};
  EXPECT_EQ(R(Capacity{}, {&one, 1}).status().pool, Pool::memory);
}

TEST(Memory, ARefusedRendererRefusesEveryFrame) {
  R renderer(Capacity{}, {});
  const Status refusal = renderer.status();
  EXPECT_EQ(renderer.begin({}), refusal);
  EXPECT_EQ(renderer.add({}, {}, {}), refusal);
  EXPECT_EQ(renderer.add_screen({}, {}), refusal);
  EXPECT_EQ(renderer.draw([](const auto&) { return true; }), refusal);
}

TEST(Memory, NothingIsInUseBeforeTheFirstFrame) {
  constexpr Capacity capacity{.width = 32, .height = 24, .vertices = 4, .polygons = 2};
  std::vector<std::byte> memory(Renderer<FlatTraits<>>::bytes_needed(capacity));
  EXPECT_EQ(Renderer<FlatTraits<>>(capacity, memory).peaks().total(), 0U);
  EXPECT_EQ(PoolPeaks{}.total(), 0U);
  EXPECT_EQ(PoolShortage{}.pool, Pool::none);
  EXPECT_EQ(PoolShortage{}.wanted, 0U);
}

TEST(Memory, PeaksNeverExceedWhatWasGiven) {
  Random random(4);
  for (int i = 0; i < rounds(100); ++i) {
    Capacity c = some_capacity(random);
    c.instances = 1;
    c.polygons = c.active = c.awake = 10;
    std::vector<Corners> soup(10);
    for (Corners& t : soup)
      for (Corner& k : t) k = {random.between(0, c.width * 16), random.between(0, c.height * 16), 5};
    Studio<GouraudTraits<Rgb565, Depth16<>>> studio(c);
    (void)studio.draw_screen(soup);
    ASSERT_TRUE(studio.status().ok());
    ASSERT_LE(studio.renderer().peaks().total(), R::bytes_needed(c));
  }
}

/// Triangles that are all active at once, and others before and after them. `pool` holds them, and `peak` says how many
/// bytes of it were in use.
template <class Visibility>
void check_peak(std::uint32_t Capacity::*pool, std::size_t PoolPeaks::*peak) {
  using Traits = FlatTraits<Rgb565, Depth24<>, Visibility>;
  std::vector<Corners> triangles;
  const auto add = [&](int from, int to) {
    const auto left = static_cast<int>(triangles.size()) * 160, z = 1000 + left;
    triangles.push_back({Corner{left, 16 * from, z}, Corner{left + 700, 16 * from, z}, Corner{left, 16 * to, z}});
  };
  for (const int from : {0, 3, 6}) add(from, from + 30);
  add(36, 60);
  Capacity capacity = screen_capacity(96, 64, triangles.size(), 8);
  Studio<Traits> ample(capacity);
  (void)ample.draw_screen(triangles);
  ASSERT_TRUE(ample.status().ok());
  constexpr std::uint32_t pools_a_step = 8;  // an entry's size is a multiple of the arena's alignment or less
  Capacity more = capacity;
  more.*pool += pools_a_step;
  const std::size_t entry =
      (Renderer<Traits>::bytes_needed(more) - Renderer<Traits>::bytes_needed(capacity)) / pools_a_step;
  Capacity none = capacity;
  none.*pool = 0;
  Studio<Traits> without(none);
  (void)without.draw_screen(triangles);
  capacity.*pool =
      static_cast<std::uint32_t>((ample.renderer().peaks().*peak - without.renderer().peaks().*peak) / entry);
  EXPECT_EQ(capacity.*pool, 3U);
  Studio<Traits> exact(capacity);
  (void)exact.draw_screen(triangles);
  EXPECT_TRUE(exact.status().ok()) << "what the peak says was not enough";
  --(capacity.*pool);
  Studio<Traits> starved(capacity);
  (void)starved.draw_screen(triangles);
  EXPECT_FALSE(starved.status().ok()) << "less than the peak was enough";
}

TEST(Memory, ThePeakOfActivePolygonsIsWhatAFrameNeedsAndNoMore) {
  check_peak<ZBuffer>(&Capacity::active, &PoolPeaks::active);
  check_peak<BoundedZBuffer>(&Capacity::active, &PoolPeaks::active);
  check_peak<Spanning>(&Capacity::awake, &PoolPeaks::awake);
}

TEST(Configuration, SizesOutsideTheirRangesAreRefused) {
  std::vector<std::byte> memory(1 << 20);
  const auto status = [&](Capacity c) { return R(c, memory).status().fault; };
  const Capacity good{.width = 64, .height = 48, .band_lines = 8};
  EXPECT_EQ(status(good), Fault::none);
  const auto spoilt = [&](auto member, int value) {
    Capacity c = good;
    c.*member = static_cast<std::remove_reference_t<decltype(c.*member)>>(value);
    return status(c);
  };
  for (const int bad : {0, 2048, 65535}) {
    EXPECT_EQ(spoilt(&Capacity::width, bad), Fault::bad_configuration) << bad;
    EXPECT_EQ(spoilt(&Capacity::height, bad), Fault::bad_configuration) << bad;
  }
  for (const int bad : {0, 49, 65535}) EXPECT_EQ(spoilt(&Capacity::band_lines, bad), Fault::bad_configuration) << bad;
  for (const int bad : {0, 3, 255}) EXPECT_EQ(spoilt(&Capacity::depth_bands, bad), Fault::bad_configuration) << bad;
  for (const int bad : {0, 17, 255}) EXPECT_EQ(spoilt(&Capacity::colour_bands, bad), Fault::bad_configuration) << bad;
  for (const auto pool : {&Capacity::polygons, &Capacity::active, &Capacity::instances, &Capacity::fans})
    EXPECT_EQ(spoilt(pool, -1), Fault::bad_configuration);
}

TEST(Configuration, AskingForTheBytesOfABadOneIsHarmless) {
  Capacity c;
  c.band_lines = 0;
  EXPECT_GE(R::bytes_needed(c), 0U);
}

TEST(Configuration, TheLargestPictureWorks) {
  Capacity c{.width = 2047, .height = 2047, .band_lines = 1, .colour_bands = 1, .polygons = 1, .active = 1, .awake = 1};
  Studio<FlatTraits<Rgb565, Depth16<>>> studio(c);
  const Corners t{Corner{0, 0, 5}, Corner{2047 * 16, 0, 5}, Corner{0, 2047 * 16, 5}};
  const auto picture = studio.draw_screen({&t, 1});
  EXPECT_TRUE(studio.status().ok());
  EXPECT_EQ(picture.drawn_count(), 2047U * 2046U / 2) << "the hypotenuse runs through pixel centres: not top-left";
}

}  // namespace
}  // namespace spanline::test
