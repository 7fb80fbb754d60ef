// Outlines of 3 to 8 corners cover the pixels of their fans, each once, and nothing else, whatever class their edges
// are of and wherever they lie.
#include "spanline/raster/outline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <ostream>
#include <vector>

#include "spanline/raster/medium_triangle.hpp"
#include "spanline/raster/outline_setup.hpp"
#include "spanline/raster/small_triangle.hpp"
#include "support/effort.hpp"
#include "support/exact_triangle.hpp"
#include "support/random.hpp"

namespace spanline::test {
namespace {

constexpr Viewport viewport{300, 200};

/// An outline that owns its corners.
struct OwnedOutline {
  std::vector<ScreenVertex> vertices;
  std::vector<Corner> corners;

  void add(int x, int y) {
    corners.push_back({x, y, 0});
    vertices.push_back(vertex_of(corners.back(), 16, viewport.width, viewport.height));
  }
  [[nodiscard]] Outline view() const {
    Outline outline{{}, static_cast<unsigned>(vertices.size())};
    for (std::size_t i = 0; i < vertices.size(); ++i) outline.corner[i] = &vertices[i];
    return outline;
  }
  [[nodiscard]] ExactTriangle fan(std::size_t i) const {
    return ExactTriangle({corners[0], corners[i], corners[i + 1]});
  }
  [[nodiscard]] bool leaves_viewport() const {
    return std::ranges::any_of(vertices, [](const ScreenVertex& v) { return v.outcode() != 0; });
  }
  friend std::ostream& operator<<(std::ostream& out, const OwnedOutline& outline) {
    for (const Corner& c : outline.corners) out << '(' << c.x << ", " << c.y << ") ";
    return out;
  }
};

/// Corners on an ellipse of any shape and place, rounded to sixteenths of a pixel; either way round.
OwnedOutline random_outline(Random& random) {
  const int count = random.between(3, Outline::most_corners);
  const double size = std::exp2(random.real(2, 12)), flat = std::exp2(random.real(-6, 0)), tilt = random.real(0, 3.15);
  const double middle_x = random.real(-400, 16 * viewport.width + 400),
               middle_y = random.real(-400, 16 * viewport.height + 400);
  const double start = random.real(0, 6.3), direction = random.between(0, 1) == 0 ? 1 : -1;
  OwnedOutline outline;
  for (int i = 0; i < count; ++i) {
    const double angle = start + direction * 6.2831853 * (i + random.real(0, 0.95)) / count;
    const double u = size * std::cos(angle), v = size * flat * std::sin(angle);
    const auto within = [](double at) { return static_cast<int>(std::clamp(std::round(at), -32000.0, 32000.0)); };
    outline.add(within(middle_x + u * std::cos(tilt) - v * std::sin(tilt)),
                within(middle_y + u * std::sin(tilt) + v * std::cos(tilt)));
  }
  return outline;
}

/// How often each pixel of the viewport is covered by the outline's rows.
std::vector<int> walked(const Outline& outline, const ActiveTriangle& begun) {
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
    const Outline outline = owned.view();
    const OutlineShape shape = shape_of(outline);
    if (shape.turn == Turn::none) {
      ++concave;
      continue;
    }
    const std::vector<int> wanted = exact(owned);
    ASSERT_LE(*std::ranges::max_element(wanted), 1) << owned << "is not convex";
    ActiveTriangle active;
    if (!set_up_outline(outline, shape.turn, owned.leaves_viewport(), viewport, active)) {
      ASSERT_EQ(*std::ranges::max_element(wanted), 0) << owned;
      ++without_rows;
      continue;
    }
    ++of_size[static_cast<std::size_t>(active.flags.size())];
    clipped += active.flags.clipped() ? 1 : 0;
    ASSERT_EQ(walked(outline, active), wanted) << owned;
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
    const Outline outline = owned.view();
    const OutlineShape shape = shape_of(outline);
    ActiveTriangle active;
    if (shape.turn == Turn::none || !set_up_outline(outline, shape.turn, owned.leaves_viewport(), viewport, active))
      continue;
    const std::vector<int> whole = walked(outline, active);
    const int skipped = random.between(0, active.end_row() - active.row - 1);
    ActiveTriangle later = active;
    later.rows_after_knee = active.end_row() - active.row - skipped;
    later.rows_to_knee = 0;
    later.row += skipped;
    std::vector<int> rest = walked(outline, later);
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

}  // namespace
}  // namespace spanline::test
