// Polygons given on screen: marked ones cover what their fans cover and tell the same triangles; their depths are those
// of the exact plane of the reference triangle; polygons that share edges cover each pixel once.
#include <gtest/gtest.h>
#include <spanline/frame/ready_made_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "spanline/geometry/outline_layout.hpp"
#include "support/effort.hpp"
#include "support/random_outline.hpp"
#include "support/ready_made_studios.hpp"

namespace spanline::test {
namespace {

constexpr Capacity capacity{.width = static_cast<std::uint16_t>(outline_viewport.width),
                            .height = static_cast<std::uint16_t>(outline_viewport.height),
                            .polygons = 8,
                            .fans = 8,
                            .awake = 8};

/// A picture of one polygon.
template <class Traits>
Picture<Traits> drawn(const OwnedOutline& outline, bool marked, PolygonCounts* counts = nullptr) {
  Capacity own = capacity;
  own.band_lines = 200;
  Studio<Traits> studio(own);
  studio.begin({.cull = Cull::none});
  const auto corners = static_cast<std::uint8_t>(outline.vertices.size() | (marked ? Mesh::planar : 0u));
  const std::uint16_t colour = 0xffff;
  studio.note(studio.renderer().add_screen(outline.vertices, {&corners, 1}, {&colour, 1}, {}));
  auto picture = studio.draw();
  EXPECT_TRUE(studio.status().ok());
  if (counts != nullptr) *counts = studio.statistics().polygons;
  return picture;
}

/// The exact depth of the plane through three corners at the centre of a pixel.
template <class Depth>
long double exact_depth(const Outline& outline, unsigned reference, int x, int y) {
  const ScreenVertex &a = outline[0], &b = outline[reference], &c = outline[reference + 1];
  const auto z = [](const ScreenVertex& v) { return static_cast<long double>(v.depth_word >> (32 - Depth::bits)); };
  const long double dx1 = b.x - a.x, dy1 = b.y - a.y, dx2 = c.x - a.x, dy2 = c.y - a.y, area = dx1 * dy2 - dx2 * dy1;
  const long double px = 16 * x + 8 - a.x_sixteenths(), py = 16 * y + 8 - a.y_sixteenths();
  return z(a) + ((z(b) - z(a)) * (px * dy2 - dx2 * py) + (z(c) - z(a)) * (dx1 * py - px * dy1)) / area;
}

template <class Depth>
class ScreenPolygons : public ::testing::Test {};
using Depths = ::testing::Types<Depth16<>, Depth24<>, Depth24<DepthSense::larger_is_nearer>>;
TYPED_TEST_SUITE(ScreenPolygons, Depths);

TYPED_TEST(ScreenPolygons, AreTheirFansInOnePlane) {
  using Depth = TypeParam;
  using Traits = IdTraits<Depth, Counted>;
  Random random(162);
  const int trials = rounds(500);
  int whole = 0;
  for (int round = 0; round < trials; ++round) {
    OwnedOutline owned = random_outline(random);
    give_depths(random, Depth::bits, owned);
    if (owned.vertices.size() == 3) continue;
    PolygonCounts counts;
    const auto one = drawn<Traits>(owned, true, &counts), fan = drawn<Traits>(owned, false);
    ASSERT_EQ(one.pixels, fan.pixels) << owned;
    ASSERT_EQ(one.covered, fan.covered) << owned;
    ASSERT_EQ(counts.total, owned.vertices.size() - 2);
    if (counts.whole == 0) {
      ASSERT_EQ(one.depth, fan.depth) << owned;
      continue;
    }
    ++whole;
    const Outline outline = owned.view();
    OutlineLayout layout;
    ASSERT_EQ(lay_out(outline, Cull::none, Depth::bits, layout), OutlineFate::whole);
    const long double bound = Depth::bits == 16 ? 1 : 2,
                      off = std::exp2(static_cast<long double>(layout.slack) - (32 - Depth::bits));
    for (std::size_t i = 0; i < one.depth.size(); ++i) {
      if (one.depth[i] == Depth::clear) continue;
      const int x = static_cast<int>(i) % capacity.width, y = static_cast<int>(i) / capacity.width;
      const auto smaller_is_nearer = [](auto depth) {
        const auto value = static_cast<long double>(Depth::integer(depth));
        return Depth::smaller ? value : static_cast<long double>((1 << Depth::bits) - 1) - value;
      };
      const long double got = smaller_is_nearer(one.depth[i]);
      ASSERT_LE(std::abs(got - exact_depth<Depth>(outline, layout.reference, x, y)), bound) << owned << x << ", " << y;
      ASSERT_LE(std::abs(got - smaller_is_nearer(fan.depth[i])), off + 2 * bound) << owned << x << ", " << y;
    }
  }
  EXPECT_GT(whole, trials / 10);
}

TEST(PolygonsOnScreen, ThatShareADiagonalCoverEachPixelOnce) {
  using Traits = IdTraits<Depth16<>, Counted>;
  Random random(163);
  const int trials = rounds(500);
  int cut = 0;
  for (int round = 0; round < trials; ++round) {
    OwnedOutline whole = random_outline(random);
    const auto count = static_cast<int>(whole.corners.size());
    if (count < 5) continue;
    const int from = random.between(0, count - 1), steps = random.between(2, count - 2);
    OwnedOutline parts[2];
    for (int k = 0; k <= steps; ++k) {
      const Corner& c = whole.corners[static_cast<std::size_t>((from + k) % count)];
      parts[0].add(c.x, c.y);
    }
    for (int k = steps; k <= count; ++k) {
      const Corner& c = whole.corners[static_cast<std::size_t>((from + k) % count)];
      parts[1].add(c.x, c.y);
    }
    PolygonCounts counts;
    const auto all = drawn<Traits>(whole, true, &counts);
    if (counts.whole == 0) continue;
    ++cut;
    const auto one = drawn<Traits>(parts[0], true), other = drawn<Traits>(parts[1], true);
    for (std::size_t i = 0; i < all.pixels.size(); ++i) {
      const auto covers = [&](const auto& picture) { return picture.depth[i] != Depth16<>::clear ? 1 : 0; };
      ASSERT_EQ(covers(one) + covers(other), covers(all)) << whole << ", from " << from << ", " << steps;
    }
  }
  EXPECT_GT(cut, trials / 20);
}

/// A pool of fans that is too small: what fits is drawn, and the status names a size that is enough.
TEST(PolygonsOnScreen, ThatFindNoRoomAreLeftOutAndCounted) {
  using Traits = IdTraits<Depth16<>, Counted>;
  std::vector<ScreenVertex> vertices;
  std::vector<std::uint8_t> corners;
  std::vector<std::uint16_t> colours(6, 0xffff);
  for (int i = 0; i < 6; ++i) {
    for (const auto& [x, y] : {std::pair{0, 0}, {20, 0}, {20, 20}, {0, 20}})
      vertices.push_back(ScreenVertex::make(16 * (x + 40 * i), 16 * y, 5000, 16));
    corners.push_back(4 | Mesh::planar);
  }
  const auto draw = [&](std::uint32_t fans, std::uint32_t polygons) {
    Studio<Traits> studio({.width = 300, .height = 30, .band_lines = 30, .polygons = polygons, .fans = fans});
    studio.begin({.cull = Cull::none});
    const Status added = studio.renderer().add_screen(vertices, corners, colours, {});
    const auto picture = studio.draw();
    return std::pair{added, std::count_if(picture.depth.begin(), picture.depth.end(),
                                          [](auto depth) { return depth != Depth16<>::clear; })};
  };
  const auto [starved, few] = draw(7, 6);
  EXPECT_EQ(starved.fault, Fault::pool_full);
  EXPECT_EQ(starved.pool, Pool::fans);
  EXPECT_EQ(few, 3 * 400) << "two records each";
  const auto [enough, all] = draw(starved.wanted, 6);
  EXPECT_TRUE(enough.ok()) << starved.wanted;
  EXPECT_EQ(all, 6 * 400);
  const auto [short_of_polygons, five] = draw(12, 5);
  EXPECT_EQ(short_of_polygons.pool, Pool::polygons);
  EXPECT_EQ(short_of_polygons.wanted, 6U);
  EXPECT_EQ(five, 5 * 400);
}

}  // namespace
}  // namespace spanline::test
