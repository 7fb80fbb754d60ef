// Fragments of polygons: half-planes by the sign of integers, against the signs of all pixels.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <tuple>
#include <vector>

#include "spanline/raster/polygon_table.hpp"
#include "support/effort.hpp"
#include "support/random.hpp"

namespace spanline::test {
namespace {

constexpr int width = 2047;

/// Lines that cross the picture near a random pixel, of random slope and scale; every few are level or upright.
HalfPlane any_line(Random& random) {
  const int bits = random.between(1, 18);
  std::int32_t a = random.between(-(1 << bits), 1 << bits), b = random.between(-(1 << bits), 1 << bits);
  if (random.between(0, 5) == 0) a = 0;
  if (random.between(0, 5) == 0) b = 0;
  const std::int32_t x = random.between(-200, width + 200), y = random.between(-200, width + 200);
  return HalfPlane::fitted(a, b, -std::int64_t{a} * x - std::int64_t{b} * y + random.between(0, std::abs(a) + 1));
}

TEST(HalfPlane, CutsARowWhereTheSignOfItsValueChanges) {
  Random random(7);
  int crossed = 0;
  for (int i = 0; i < rounds(20000); ++i) {
    const HalfPlane line = any_line(random);
    const std::int32_t row = random.between(0, width - 1), first = random.between(0, width - 1);
    const RowColumns run{first, random.between(first, std::min(first + 300, width))};
    const RowColumns kept = line.cut(run, row, true), other = line.cut(run, row, false);
    for (std::int32_t x = run.first; x < run.end; ++x) {
      const std::int64_t value = std::int64_t{line.a} * x + std::int64_t{line.b} * row + line.c;
      ASSERT_EQ(kept.first <= x && x < kept.end, value >= 0) << "round " << i << ", column " << x;
      ASSERT_EQ(other.first <= x && x < other.end, value < 0) << "round " << i << ", column " << x;
    }
    if (kept.first < kept.end && other.first < other.end) ++crossed;
  }
  EXPECT_GT(crossed, 0);
}

TEST(HalfPlane, FitsLargeWordsWithoutLeavingThirtyTwoBits) {
  Random random(8);
  for (int i = 0; i < rounds(20000); ++i) {
    const auto large = [&](int bits) {
      return (std::int64_t{random.between(-32768, 32767)} << bits) + random.between(0, 9999);
    };
    const std::int64_t a = large(random.between(0, 30)), b = large(random.between(0, 30)),
                       c = large(random.between(0, 40));
    const HalfPlane line = HalfPlane::fitted(a, b, c);
    // It is shifted until it fits, and no further.
    const auto fits = [](std::int64_t p, std::int64_t q, std::int64_t r) {
      return std::abs(p) + std::abs(q) <= 1 << 19 && std::abs(r) < 1 << 30;
    };
    int shift = 0;
    while (!fits(a >> shift, b >> shift, c >> shift)) ++shift;
    ASSERT_EQ(std::tuple(line.a, line.b, line.c), std::tuple(a >> shift, b >> shift, c >> shift)) << "round " << i;
    for (const std::int32_t x : {0, width})
      for (const std::int32_t y : {0, width}) {
        const std::int64_t value = std::int64_t{line.a} * x + std::int64_t{line.b} * y + line.c;
        ASSERT_EQ(line.at(x, y), value) << "round " << i;
      }
  }
}

/// What cuts leave of a polygon is a partition of it: every pixel has one fragment, whatever the lines.
TEST(Fragments, OfAPolygonShareOutItsPixels) {
  Random random(9);
  for (int round = 0; round < rounds(300); ++round) {
    const std::array<HalfPlane, 3> lines{any_line(random), any_line(random), any_line(random)};
    // Eight fragments, one for each combination of sides.
    std::vector<Link> cuts;
    std::array<PolygonCuts, 9> fragments{};
    for (Link number = 0; number < 8; ++number) {
      fragments[number] = {static_cast<Link>(cuts.size()), 3};
      for (Link k = 0; k < 3; ++k) cuts.push_back(static_cast<Link>(2 * k + (number >> k & 1)));
    }
    PolygonTable table;
    table.fragments = fragments;
    table.cuts = cuts;
    table.half_planes = lines;
    for (const std::int32_t row : {0, random.between(1, width - 2), width - 1}) {
      const RowColumns whole{0, width};
      std::vector<int> owners(width);
      for (Link number = 0; number < 8; ++number) {
        const RowColumns part = table.cut(number, row, whole);
        for (std::int32_t x = part.first; x < part.end; ++x) ++owners[static_cast<std::size_t>(x)];
      }
      for (const int count : owners) ASSERT_EQ(count, 1) << "round " << round << ", row " << row;
      const RowColumns uncut = table.cut(8, row, whole);
      ASSERT_EQ(uncut.first, 0);
      ASSERT_EQ(uncut.end, width);
    }
  }
}

}  // namespace
}  // namespace spanline::test
