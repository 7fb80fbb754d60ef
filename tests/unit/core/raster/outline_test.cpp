// Outlines of 3 to 8 corners cover the pixels of their fans, each once, and nothing else, whatever class their edges
// are of and wherever they lie.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <ostream>
#include <vector>

#include "spanline/geometry/outline_layout.hpp"
#include "spanline/geometry/quad_layout.hpp"
#include "spanline/raster/medium_triangle.hpp"
#include "spanline/raster/outline_setup.hpp"
#include "spanline/raster/small_triangle.hpp"
#include "support/effort.hpp"
#include "support/exact_triangle.hpp"
#include "support/random.hpp"
#include "support/random_outline.hpp"

namespace spanline::test {
namespace {

constexpr Viewport viewport = outline_viewport;

/// The outline as the polygon table would hold it; none if it is to be a fan.
std::optional<PlacedOutline> placed(const Outline& outline) {
  OutlineLayout layout;
  if (lay_out(outline, Cull::none, 16, layout) != OutlineFate::whole) return std::nullopt;
  return PlacedOutline{outline, OutlineHeader(outline.count(), layout), layout.origin, layout.end_row};
}

/// How often each pixel of the viewport is covered by the outline's rows.
std::vector<int> walked(const PlacedOutline& outline, const ActiveTriangle& begun) {
  std::vector<int> covered(static_cast<std::size_t>(viewport.width * viewport.height));
  ActiveTriangle active = begun;
  while (active.rows_to_knee + active.rows_after_knee > 0) {
    if (active.rows_to_knee == 0) place_outline_edges(outline, active);
    int first, end;
    if (active.flags.size() == ActiveTriangle::Size::large) {
      first = active.large.left.x;
      end = active.large.right.x;
      active.large.skip_rows(1);
    } else {
      const int bits = active.flags.size() == ActiveTriangle::Size::small ? small_triangle::fraction_bits
                                                                          : medium_triangle::fraction_bits;
      first = active.origin + static_cast<int>(active.fixed.left >> bits);
      end = active.origin + static_cast<int>(active.fixed.right >> bits);
      active.fixed.next_row();
    }
    if (active.flags.clipped()) {
      first = std::max(first, 0);
      end = std::min(end, viewport.width);
    }
    const int row = active.row - row_bias;
    for (int x = first; x < end; ++x) ++covered.at(static_cast<std::size_t>(row * viewport.width + x));
    ++active.row;
    --active.rows_to_knee;
  }
  return covered;
}

/// How often each pixel is covered by the exact triangles of the fan.
std::vector<int> exact(const OwnedOutline& outline) {
  std::vector<int> covered(static_cast<std::size_t>(viewport.width * viewport.height));
  for (std::size_t i = 1; i + 1 < outline.corners.size(); ++i)
    outline.fan(i).for_each_pixel(viewport.width, viewport.height,
                                  [&](int x, int y) { ++covered[static_cast<std::size_t>(y * viewport.width + x)]; });
  return covered;
}

TEST(Outlines, CoverThePixelsOfTheirFansAndNothingElse) {
  Random random(16);
  std::array<int, 3> of_size{};
  int concave = 0, without_rows = 0, clipped = 0;
  const int trials = rounds(8000);
  for (int round = 0; round < trials; ++round) {
    const OwnedOutline owned = random_outline(random);
    const auto outline = placed(owned.view());
    if (!outline) {
      ++concave;
      continue;
    }
    const std::vector<int> wanted = exact(owned);
    ASSERT_LE(*std::ranges::max_element(wanted), 1) << owned << "is not convex";
    ActiveTriangle active;
    if (!set_up_outline(*outline, viewport, active)) {
      ASSERT_EQ(*std::ranges::max_element(wanted), 0) << owned;
      ++without_rows;
      continue;
    }
    ++of_size[static_cast<std::size_t>(active.flags.size())];
    clipped += active.flags.clipped() ? 1 : 0;
    ASSERT_EQ(walked(*outline, active), wanted) << owned;
  }
  for (const int count : of_size) EXPECT_GT(count, trials / 20);
  EXPECT_GT(clipped, trials / 20);
  EXPECT_GT(without_rows, 0);
  EXPECT_GT(concave, 0) << "snapping makes some concave";
  EXPECT_LT(concave, trials / 2);
}

TEST(Outlines, BeginAtAnyRow) {
  Random random(17);
  for (int round = 0; round < rounds(2000); ++round) {
    const OwnedOutline owned = random_outline(random);
    const auto outline = placed(owned.view());
    ActiveTriangle active;
    if (!outline || !set_up_outline(*outline, viewport, active)) continue;
    const std::vector<int> whole = walked(*outline, active);
    const int skipped = random.between(0, active.end_row() - active.row - 1);
    ActiveTriangle later = active;
    later.rows_after_knee = active.end_row() - active.row - skipped;
    later.rows_to_knee = 0;
    later.row += skipped;
    std::vector<int> rest = walked(*outline, later);
    const auto first = static_cast<std::ptrdiff_t>((later.row - row_bias) * viewport.width);
    ASSERT_TRUE(std::equal(whole.begin() + first, whole.end(), rest.begin() + first)) << owned << "row " << skipped;
  }
}

OwnedOutline outline_of(std::initializer_list<Corner> corners) {
  OwnedOutline outline;
  for (const Corner& c : corners) outline.add(c.x, c.y);
  return outline;
}

TEST(Outlines, AreConvexIfAllTurnsAndTrianglesOfTheFanGoOneWay) {
  const auto turn = [](std::initializer_list<Corner> corners) { return shape_of(outline_of(corners).view()).turn; };
  EXPECT_EQ(turn({{0, 0}, {160, 0}, {160, 160}, {0, 160}}), Turn::clockwise);
  EXPECT_EQ(turn({{0, 0}, {0, 160}, {160, 160}, {160, 0}}), Turn::counter_clockwise);
  EXPECT_EQ(turn({{0, 0}, {80, 0}, {160, 0}, {160, 160}}), Turn::clockwise) << "a corner on an edge";
  EXPECT_EQ(turn({{0, 0}, {160, 0}, {80, 20}, {0, 160}}), Turn::none) << "a corner inside";
  EXPECT_EQ(turn({{0, 0}, {160, 160}, {160, 0}, {0, 160}}), Turn::none) << "a bow tie";
  EXPECT_EQ(turn({{80, 0}, {130, 152}, {0, 58}, {160, 58}, {30, 152}}), Turn::none) << "a star turns one way, twice";
  EXPECT_EQ(turn({{0, 0}, {80, 80}, {160, 160}, {40, 40}}), Turn::none) << "no area";
}

TEST(Outlines, ReferToTheirLargestTriangle) {
  const auto shape = [](std::initializer_list<Corner> corners) { return shape_of(outline_of(corners).view()); };
  const OutlineShape square = shape({{0, 0}, {160, 0}, {160, 160}, {0, 160}});
  EXPECT_EQ(square.reference, 1U) << "of equally large ones the first";
  EXPECT_EQ(square.area, 160 * 160);
  const OutlineShape second = shape({{0, 0}, {0, 160}, {160, 160}, {170, 0}});
  EXPECT_EQ(second.reference, 2U);
  EXPECT_EQ(second.area, -170 * 160);
}

/// How far the plane of the reference triangle lies from the depth of a corner, as a fraction of the triangle's area.
__int128 distance(const Outline& outline, const OutlineShape& shape, unsigned corner, int depth_bits) {
  const auto depth = [&](unsigned i) { return __int128{outline[i].depth_word >> (32 - depth_bits)}; };
  const auto area = [&](unsigned a, unsigned b, unsigned c) {
    return __int128{outline[b].x - outline[a].x} * (outline[c].y - outline[a].y) -
           __int128{outline[c].x - outline[a].x} * (outline[b].y - outline[a].y);
  };
  const unsigned b = shape.reference, c = b + 1;
  const __int128 off = depth(0) * area(corner, b, c) + depth(b) * area(0, corner, c) + depth(c) * area(0, b, corner) -
                       depth(corner) * area(0, b, c);
  return off < 0 ? -off : off;
}

TEST(Outlines, AreWholeIfTheirPlaneStaysInTheRangeOfDepths) {
  Random random(18);
  const int trials = rounds(20000);
  int whole = 0, fans = 0, of_slack = 0;
  for (int round = 0; round < trials; ++round) {
    OwnedOutline owned = random_outline(random);
    const int bits = random.between(0, 1) == 0 ? 16 : 24;
    give_depths(random, bits, owned);
    const Outline outline = owned.view();
    const OutlineShape shape = shape_of(outline);
    OutlineLayout layout;
    const OutlineFate fate = lay_out(outline, Cull::none, bits, layout);
    ASSERT_EQ(lay_out(outline, Cull::back, bits, layout) == OutlineFate::culled, shape.turn == Turn::clockwise);
    if (shape.turn == Turn::none) {
      ASSERT_EQ(fate, OutlineFate::fan);
      continue;
    }
    const __int128 area = shape.area < 0 ? -shape.area : shape.area;
    bool stays = true;
    __int128 farthest = 0;
    for (unsigned i = 0; i < outline.count(); ++i) farthest = std::max(farthest, distance(outline, shape, i, bits));
    for (unsigned i = 0; i < outline.count(); ++i) {
      if (i == 0 || i == shape.reference || i == shape.reference + 1) continue;
      const __int128 depth = outline[i].depth_word >> (32 - bits);
      stays = stays && depth * area >= farthest && (depth - ((1 << bits) - 2)) * area + farthest <= 0;
    }
    // What is whole stays in the range; what stays in it by far is whole.
    if (fate == OutlineFate::whole) {
      ASSERT_TRUE(stays) << owned;
      ASSERT_LE(farthest, area << (layout.slack - static_cast<unsigned>(32 - bits))) << owned;
      const OutlineHeader header(outline.count(), layout);
      ASSERT_GE(header.depth_slack(), std::uint32_t{1} << layout.slack);
      ASSERT_EQ(header.reference(), shape.reference);
      ++whole;
      of_slack += farthest > area ? 1 : 0;
    } else {
      ++fans;
    }
  }
  EXPECT_GT(whole, trials / 20);
  EXPECT_GT(of_slack, trials / 400);
  EXPECT_GT(fans, trials / 400);
}

TEST(Outlines, OfFourCornersAreLaidOutAsOthersAre) {
  Random random(19);
  const int trials = rounds(40000);
  int whole = 0, fans = 0, parallelograms = 0;
  for (int round = 0; round < trials; ++round) {
    OwnedOutline owned = random_outline(random);
    if (random.between(0, 3) == 0) {  // a parallelogram
      const auto a = owned.corners[0], b = owned.corners[1], d = owned.corners[2];
      owned = {};
      for (const Corner& c : {a, b, Corner{b.x + d.x - a.x, b.y + d.y - a.y, 0}, d}) owned.add(c.x, c.y);
    }
    const int bits = random.between(0, 1) == 0 ? 16 : 24;
    give_depths(random, bits, owned);
    const Outline outline = owned.view();
    const bool leaves = std::ranges::any_of(owned.vertices, [](const ScreenVertex& v) { return v.outcode() != 0; });
    if (outline.count() != 4 || leaves) continue;
    const Cull cull = static_cast<Cull>(random.between(0, 2));
    OutlineLayout layout{}, wanted{};
    const OutlineFate fate = lay_out_quad(outline, cull, bits, layout);
    ASSERT_EQ(fate, lay_out(outline, cull, bits, wanted)) << owned;
    parallelograms += owned.corners[0].x + owned.corners[2].x == owned.corners[1].x + owned.corners[3].x ? 1 : 0;
    fans += fate == OutlineFate::fan ? 1 : 0;
    if (fate != OutlineFate::whole) continue;
    ++whole;
    ASSERT_EQ(OutlineHeader(4, layout).bits(), OutlineHeader(4, wanted).bits()) << owned;
    ASSERT_EQ(layout.slack, wanted.slack) << owned;
    ASSERT_EQ(layout.first_row, wanted.first_row);
    ASSERT_EQ(layout.end_row, wanted.end_row);
    ASSERT_EQ(layout.origin, wanted.origin);
  }
  EXPECT_GT(whole, trials / 80);
  EXPECT_GT(fans, trials / 800);
  EXPECT_GT(parallelograms, trials / 800);
}

}  // namespace
}  // namespace spanline::test
