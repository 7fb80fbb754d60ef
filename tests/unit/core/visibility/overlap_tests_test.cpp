// The overlap tests of depth sort, one by one: on the lectures' cases, against definitions in wide integers, and
// against the pixels that polygons share.
#include "spanline/visibility/sort/overlap_tests.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "spanline/raster/depth_format.hpp"
#include "spanline/visibility/sort/packed_box.hpp"
#include "spanline/visibility/sort/pair_order.hpp"
#include "support/effort.hpp"
#include "support/polygons_on_screen.hpp"
#include "support/random.hpp"
#include "support/random_outline.hpp"
#include "support/triangle_kinds.hpp"

namespace spanline::test {
namespace {

using Polygon = std::vector<Corner>;
constexpr Viewport viewport = outline_viewport;

// The lectures' cases.

/// P and Q at 24 bits. The lectures draw them from above, with the eye below.
struct Pair {
  Pair(const Polygon& first, const Polygon& second) : polygons(viewport, 24, 2) {
    EXPECT_TRUE(polygons.add(first));
    EXPECT_TRUE(polygons.add(second));
    p.set(polygons.entry(0));
    q.set(polygons.entry(1));
  }
  /// Where Q lies to P's plane.
  [[nodiscard]] PlaneSide q_to_p() const { return side_of_plane(q, p, 8); }
  [[nodiscard]] PlaneSide p_to_q() const { return side_of_plane(p, q, 8); }

  PolygonsOnScreen polygons;
  TestedPolygon p, q;
};

/// A triangle whose depth goes from `left_z` at its left side to `right_z` at its right corner.
Polygon wedge(int left, int right, std::int32_t left_z, std::int32_t right_z) {
  return {{16 * left, 16 * 40, left_z}, {16 * right, 16 * 80, right_z}, {16 * left, 16 * 120, left_z}};
}

constexpr std::int32_t million = 1'000'000;

// Lecture 002, "Q is on the opposite side of P".
TEST(OverlapTests, QIsOnTheOppositeSideOfP) {
  // P sinks to the right; Q is level and begins behind P.
  EXPECT_EQ(Pair(wedge(20, 120, 2 * million, 3 * million), wedge(20, 120, 4 * million, 4 * million)).q_to_p(),
            PlaneSide::behind);
  // P's plane, extended, cuts Q.
  const Pair cut(wedge(20, 60, 2 * million, 4 * million), wedge(20, 120, 5 * million, 5 * million));
  EXPECT_EQ(cut.q_to_p(), PlaneSide::mixed);
  EXPECT_EQ(cut.p_to_q(), PlaneSide::in_front) << "the test the other way round tells";
}

// "P is on the same side of Q".
TEST(OverlapTests, PIsOnTheSameSideOfQ) {
  const Pair in_front(wedge(20, 120, 2 * million, 3 * million), wedge(20, 120, 4 * million, 5 * million));
  EXPECT_EQ(in_front.p_to_q(), PlaneSide::in_front);
  // Q's plane, extended towards the left, cuts P.
  const Pair cut(wedge(20, 120, 2 * million, 2 * million), wedge(100, 160, 3 * million, 6 * million));
  EXPECT_EQ(cut.p_to_q(), PlaneSide::mixed);
  EXPECT_EQ(cut.q_to_p(), PlaneSide::behind) << "the test the other way round tells";
}

TEST(OverlapTests, TheSwappedTestsAreTheOtherSides) {
  const Pair swapped(wedge(20, 120, 4 * million, 4 * million), wedge(20, 120, 2 * million, 3 * million));
  EXPECT_EQ(swapped.q_to_p(), PlaneSide::in_front);
  EXPECT_EQ(swapped.p_to_q(), PlaneSide::behind);
}

TEST(OverlapTests, PolygonsThatPenetrateAreOnBothSidesOfEachOther) {
  const Pair through(wedge(20, 120, 2 * million, 6 * million), wedge(20, 120, 6 * million, 2 * million));
  EXPECT_EQ(through.q_to_p(), PlaneSide::mixed);
  EXPECT_EQ(through.p_to_q(), PlaneSide::mixed);
}

TEST(OverlapTests, NothingIsToldOfWhatIsNearerThanTheDoubt) {
  for (const int distance : {-9, -8, 0, 8, 9}) {
    const Pair level(wedge(20, 120, million, million), wedge(20, 120, million + distance, million + distance));
    EXPECT_EQ(level.q_to_p(), distance > 8    ? PlaneSide::behind
                              : distance < -8 ? PlaneSide::in_front
                                              : PlaneSide::mixed)
        << distance;
  }
}

// Lecture 003, "Do the projections of the polygons onto the (x, y) plane not overlap?", where their boxes do.
TEST(OverlapTests, ProjectionsAreApartWhereASideDividesThem) {
  const Polygon lower{{0, 160, 0}, {0, 1600, 0}, {1440, 1600, 0}}, upper{{160, 0, 0}, {1600, 0, 0}, {1600, 1440, 0}},
      across{{0, 0, 0}, {1600, 1600, 0}, {0, 1600, 0}};
  const auto overlap = [](const Polygon& p, const Polygon& q) {
    const Pair pair(p, q);
    EXPECT_EQ(projections_may_overlap(pair.q, pair.p), projections_may_overlap(pair.p, pair.q));
    return projections_may_overlap(pair.p, pair.q);
  };
  EXPECT_FALSE(overlap(lower, upper));
  EXPECT_TRUE(overlap(lower, across));
  EXPECT_FALSE(overlap(across, upper));
  // Polygons that share a side, or a corner, have no pixel in common.
  EXPECT_FALSE(overlap({{0, 0, 0}, {320, 0, 0}, {0, 320, 0}}, {{320, 0, 0}, {320, 320, 0}, {0, 320, 0}}));
  EXPECT_FALSE(overlap({{0, 0, 0}, {320, 0, 0}, {0, 320, 0}}, {{320, 0, 0}, {640, 0, 0}, {640, 320, 0}}));
}

// Regression: an outline whose corners fell together was said to share no pixel with anything.
TEST(OverlapTests, ASideWithoutLengthDividesNothing) {
  const Polygon outline{
      {0, 0, million}, {1600, 0, million}, {1600, 0, million}, {1600, 1600, million}, {0, 1600, million}};
  const Pair pair(outline, {{320, 320, million}, {640, 320, million}, {320, 640, million}});
  EXPECT_TRUE(projections_may_overlap(pair.p, pair.q));
  EXPECT_TRUE(projections_may_overlap(pair.q, pair.p));
}

TEST(OverlapTests, ASideThatIsRunBackDividesNothing) {
  const Polygon outline{{317, 774, million}, {290, 167, million}, {514, 312, million},
                        {317, 774, million}, {514, 312, million}, {317, 774, million}};
  const Pair pair(outline, {{330, 300, million}, {450, 330, million}, {340, 500, million}});
  EXPECT_TRUE(projections_may_overlap(pair.p, pair.q));
  EXPECT_TRUE(projections_may_overlap(pair.q, pair.p));
}

// Lecture 002: "if (P and Q do not have overlapping x-extents, …", "… y-extents, …".

TEST(PackedBoxes, OverlapWhereTheirUnitsDo) {
  Random random(1);
  int apart = 0;
  for (int i = 0; i < rounds(200'000); ++i) {
    const Viewport size{random.between(1, 2047), random.between(1, 2047)};
    const BoxScale scale(size);
    struct Extent {
      int first, end;
      Extent(Random& any, int limit) : first(any.between(0, limit - 1)), end(any.between(first + 1, limit)) {}
      [[nodiscard]] bool overlaps(const Extent& other, int shift) const {
        return first >> shift <= (other.end - 1) >> shift && other.first >> shift <= (end - 1) >> shift;
      }
    };
    const Extent px(random, size.width), py(random, size.height), qx(random, size.width), qy(random, size.height);
    const PackedBox p(px.first, px.end, py.first, py.end, scale), q(qx.first, qx.end, qy.first, qy.end, scale);
    const PackedBox::Facing facing(p);
    const bool x = px.overlaps(qx, scale.columns), y = py.overlaps(qy, scale.rows);
    ASSERT_EQ(facing.x_extents_overlap(q), x);
    ASSERT_EQ(facing.y_extents_overlap(q), y);
    ASSERT_EQ(facing.overlaps(q), x && y);
    // Whatever shares a pixel overlaps; the box holds its pixels, and few others.
    ASSERT_TRUE(facing.overlaps(q) || !px.overlaps(qx, 0) || !py.overlaps(qy, 0));
    ASSERT_LE(p.first_column(scale), px.first);
    ASSERT_GE(p.end_column(scale), px.end);
    ASSERT_LE(p.first_row(scale), py.first);
    ASSERT_GE(p.end_row(scale), py.end);
    ASSERT_LT(p.end_column(scale) - p.first_column(scale), px.end - px.first + (2 << scale.columns) - 1);
    ASSERT_LT(p.end_row(scale) - p.first_row(scale), py.end - py.first + (2 << scale.rows) - 1);
    apart += x && y ? 0 : 1;
  }
  EXPECT_GT(apart, rounds(200'000) / 8);
}

// Against definitions.

std::string text_of(const Polygon& polygon) {
  std::ostringstream text;
  for (const Corner& c : polygon) text << '(' << c.x << ", " << c.y << ", " << c.z << ") ";
  return text.str();
}

/// Any polygon: triangles of all kinds, and outlines.
Polygon any_polygon(Random& random, Viewport view, int bits) {
  if (random.chance(3)) {
    OwnedOutline outline = random_outline(random);
    give_depths(random, bits, outline);
    for (std::size_t i = 0; i < outline.corners.size(); ++i)
      outline.corners[i].z = static_cast<std::int32_t>(outline.vertices[i].depth_word >> (32 - bits));
    // Snapping may put two corners in one place.
    Polygon corners = outline.corners;
    if (corners.size() < Outline::most_corners && random.chance(4)) {
      const auto at = corners.begin() + random.between(0, static_cast<int>(corners.size()) - 1);
      corners.insert(at, Corner(*at));
    }
    return corners;
  }
  TriangleMaker make(static_cast<std::uint32_t>(random.between(0, 1 << 30)), view.width, view.height,
                     bits == 16 ? 0 : 16, (1 << bits) - 17);
  const Corners t = make(
      all_triangle_kinds[static_cast<std::size_t>(random.between(0, static_cast<int>(all_triangle_kinds.size()) - 1))]);
  return {t.begin(), t.end()};
}

/// Brings polygons near to one plane, so that rounding may decide. Outlines may leave it a little.
void bring_together(Random& random, int bits, Polygon& p, Polygon& q) {
  int reach = 160;  // sixteenths
  for (const Polygon* polygon : {&p, &q})
    for (const Corner& c : *polygon) reach = std::max({reach, std::abs(c.x - p[0].x), std::abs(c.y - p[0].y)});
  const double range = 1 << bits, steepest = 0.14 * range * 16 / reach * std::exp2(-random.real(0, 8));
  const double dx = random.real(-1, 1) * steepest, dy = random.real(-1, 1) * steepest;
  const double start = random.real(0.3, 0.7) * range - p[0].x / 16.0 * dx - p[0].y / 16.0 * dy;
  const bool leaves = random.chance(3);
  const int noise = leaves ? 1 << random.between(2, 10) : 0;
  const int apart = leaves ? random.between(-2 * noise, 2 * noise) : random.between(-2, 2);
  for (Polygon* polygon : {&p, &q})
    for (Corner& c : *polygon) {
      const int off = polygon->size() > 3 ? random.between(-noise, noise) : 0;
      const double z = start + c.x / 16.0 * dx + c.y / 16.0 * dy + (polygon == &q ? apart : 0) + off;
      c.z = static_cast<std::int32_t>(std::clamp(std::round(z), 16.0, range - 17));
    }
}

/// A polygon whose corners are near another one's.
Polygon moved_a_little(Random& random, Polygon polygon) {
  constexpr int guard = 16 * ScreenVertex::guard_pixels;
  const int most = 1 << random.between(2, 7);
  for (Corner& c : polygon) {
    c.x = std::clamp(c.x + random.between(-most, most), -guard, guard);
    c.y = std::clamp(c.y + random.between(-most, most), -guard, guard);
  }
  return polygon;
}

/// Moves a polygon's middle near another one's.
void move_over(Random& random, const Polygon& p, Polygon& q) {
  constexpr int guard = 16 * ScreenVertex::guard_pixels;
  const auto shift = [&](int Corner::*axis) {
    const auto middle = [axis](const Polygon& polygon) {
      int sum = 0;
      for (const Corner& c : polygon) sum += c.*axis;
      return sum / static_cast<int>(polygon.size());
    };
    const int by = middle(p) - middle(q) + random.between(-60, 60);
    for (Corner& c : q) c.*axis = std::clamp(c.*axis + by, -guard, guard);
  };
  shift(&Corner::x);
  shift(&Corner::y);
}

/// Puts two polygons that the renderer would take into the table.
void add_any_pair(Random& random, Viewport view, int bits, PolygonsOnScreen& polygons, Polygon& p, Polygon& q) {
  do {
    polygons.clear();
    p = any_polygon(random, view, bits);
    q = random.chance(2) ? any_polygon(random, view, bits) : moved_a_little(random, p);
    if (!random.chance(3)) move_over(random, p, q);
    if (random.chance(2)) bring_together(random, bits, p, q);
  } while (!polygons.add(p) || !polygons.add(q));
}

using Wide = __int128;

Wide doubled_area(const Corner& a, const Corner& b, const Corner& c) {
  return Wide{b.x - a.x} * (c.y - a.y) - Wide{b.y - a.y} * (c.x - a.x);
}

/// Where q lies to the plane through three corners of p, by the weights of those corners at each corner of q.
PlaneSide side_by_weights(const Polygon& q, const Polygon& p, unsigned reference, std::int32_t doubt) {
  const Corner &a = p[0], &b = p[reference], &c = p[reference + 1];
  Wide area = doubled_area(a, b, c);
  const int turn = area < 0 ? -1 : 1;
  area *= turn;
  bool behind = true, in_front = true;
  for (const Corner& at : q) {
    const Wide plane =
        turn * (doubled_area(at, b, c) * a.z + doubled_area(a, at, c) * b.z + doubled_area(a, b, at) * c.z);
    behind = behind && area * at.z - plane > area * doubt;
    in_front = in_front && plane - area * at.z > area * doubt;
  }
  return behind ? PlaneSide::behind : in_front ? PlaneSide::in_front : PlaneSide::mixed;
}

/// Whether a side of p has all of q on it or on the other side than p.
bool divides(const Polygon& p, const Polygon& q) {
  Wide turn = 0;
  for (std::size_t i = 1; i + 1 < p.size(); ++i) turn += doubled_area(p[0], p[i], p[i + 1]);
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Corner &from = p[i], &to = p[(i + 1) % p.size()];
    const auto inside = [&](const Corner& c) { return doubled_area(from, to, c) * turn; };
    // Corners may repeat others: sides without length, and sides that are run back, bound nothing.
    const bool bounds = std::all_of(p.begin(), p.end(), [&](const Corner& c) { return inside(c) >= 0; }) &&
                        std::any_of(p.begin(), p.end(), [&](const Corner& c) { return inside(c) > 0; });
    if (!bounds) continue;
    if (std::all_of(q.begin(), q.end(), [&](const Corner& c) { return inside(c) <= 0; })) return true;
  }
  return false;
}

TEST(OverlapTests, AreTheirDefinitionsForTrianglesAndOutlinesOfAnySize) {
  Random random(2);
  PolygonsOnScreen polygons(viewport, 24, 2);
  std::array<int, 3> sides{};
  int outlines = 0, overlapping = 0;
  const int pairs = rounds(60'000);
  Polygon p, q;
  for (int i = 0; i < pairs; ++i) {
    add_any_pair(random, viewport, 24, polygons, p, q);
    TestedFront front;
    front.set(polygons.entry(0));
    TestedPolygon tested;
    tested.set(polygons.entry(1));
    const std::int32_t doubt = random.between(0, 6);
    const PlaneSide side = side_by_weights(q, p, front.polygon().reference, doubt + tested.slack);
    const bool overlap = !divides(p, q) && !divides(q, p);
    // Twice, since the first call computes what the second one finds.
    for (int again = 0; again < 2; ++again) {
      ASSERT_EQ(front.side_of(tested, doubt), side) << "pair " << i;
      ASSERT_EQ(front.projections_may_overlap(tested), overlap) << "pair " << i;
    }
    ASSERT_EQ(side_of_plane(tested, front.polygon(), doubt), side) << "pair " << i;
    ASSERT_EQ(projections_may_overlap(front.polygon(), tested), overlap) << "pair " << i;
    ++sides[static_cast<std::size_t>(side)];
    outlines += tested.is_outline() ? 1 : 0;
    overlapping += overlap ? 1 : 0;
  }
  EXPECT_GT(*std::min_element(sides.begin(), sides.end()), pairs / 20);
  EXPECT_GT(outlines, pairs / 20);
  EXPECT_GT(std::min(overlapping, pairs - overlapping), pairs / 20);
}

// Against pixels.

template <class Depth>
class OrdersOfPairs : public ::testing::Test {};
using Depths = ::testing::Types<Depth16<>, Depth16<DepthSense::larger_is_nearer>, Depth24<>,
                                Depth24<DepthSense::larger_is_nearer>>;
TYPED_TEST_SUITE(OrdersOfPairs, Depths);

TYPED_TEST(OrdersOfPairs, HoldAtEveryPixelThatTheyShare) {
  using Depth = TypeParam;
  Random random(3);
  std::array<int, 4> orders{};
  std::size_t shared = 0;
  const int pairs = rounds(6'000);
  // The wider the picture, the farther planes of pixels may lie from those through the corners.
  for (const Viewport view : {viewport, Viewport{2047, 120}}) {
    PolygonsOnScreen polygons(view, Depth::bits, 2);
    PairTests<Depth, false> tests;
    Polygon p, q;
    for (int i = 0; i < pairs; ++i) {
      add_any_pair(random, view, Depth::bits, polygons, p, q);
      const PolygonSource source{polygons.table(), view};
      const Link number = random.chance(2) ? 1 : 0, other_number = static_cast<Link>(1 - number);
      NumberedPlane<Depth> other;
      other.set(other_number);
      tests.begin(source, number);
      const PairOrder order = tests.test(source, other, true, nullptr);
      ++orders[static_cast<std::size_t>(order)];
      const LinearFunction own = polygons.plane<Depth>(number), others = polygons.plane<Depth>(other_number);
      polygons.for_each_pixel(number, [&](int x, int y) {
        if (!polygons.covers(other_number, x, y)) return;
        ++shared;
        const std::uint32_t depth = own.at(x) + own.dy * word(y), depth_of_other = others.at(x) + others.dy * word(y);
        const bool is_front = Depth::smaller ? depth < depth_of_other : depth > depth_of_other;
        const bool is_behind = Depth::smaller ? depth > depth_of_other : depth < depth_of_other;
        const bool holds = order == PairOrder::unknown || (order == PairOrder::behind && is_front) ||
                           (order == PairOrder::in_front && is_behind);
        EXPECT_TRUE(holds) << "pair " << i << " at " << x << ", " << y;
      });
      ASSERT_FALSE(this->HasFailure()) << text_of(p) << "and " << text_of(q);
    }
  }
  EXPECT_GT(*std::min_element(orders.begin(), orders.end()), 2 * pairs / 20);
  EXPECT_GT(shared, static_cast<std::size_t>(pairs) * 40);
}

}  // namespace
}  // namespace spanline::test
