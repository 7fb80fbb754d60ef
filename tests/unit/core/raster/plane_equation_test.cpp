// A triangle has one plane: what algorithms ask PlaneEquation for is what set-up gives an active triangle.
#include "spanline/raster/plane_equation.hpp"
#include "spanline/raster/attribute_gradients.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "spanline/raster/triangle_setup.hpp"
#include "support/effort.hpp"
#include "support/exact_triangle.hpp"
#include "support/triangle_kinds.hpp"

namespace spanline::test {
namespace {

constexpr Viewport viewport{320, 240};

struct Functions {
  LinearFunction depth, attribute;
};

/// An active triangle's functions, brought from its row and column of origin to column 0 of row 0.
Functions moved_to_corner(const ActiveTriangle& active, LinearFunction attribute) {
  Functions functions{active.depth, attribute};
  for (LinearFunction* f : {&functions.depth, &functions.attribute}) {
    f->at_origin = f->at(-active.origin);
    f->skip_rows(row_bias - active.row);
  }
  return functions;
}

void expect_same(const LinearFunction& got, const LinearFunction& want, const Corners& corners) {
  EXPECT_EQ(got.at_origin, want.at_origin) << corners;
  EXPECT_EQ(got.dx, want.dx) << corners;
  EXPECT_EQ(got.dy, want.dy) << corners;
}

template <class Depth>
void compare(TriangleKind kind, int count) {
  TriangleMaker make(59 + static_cast<std::uint32_t>(kind), viewport.width, viewport.height, Depth::nearest,
                     Depth::farthest);
  int active_triangles = 0;
  for (int i = 0; i < count; ++i) {
    const Corners corners = make(kind);
    const std::vector<ScreenVertex> v = vertices_of({&corners, 1}, Depth::bits, viewport.width, viewport.height);
    const auto shade_of = [&](const ScreenVertex* corner) {
      return static_cast<std::int32_t>(64 + 9973 * (corner - v.data() + i) % 65408);
    };
    PolygonGroup group;
    group.vertices = v.data();
    group.scissored = true;
    ActiveTriangle active;
    LinearFunction attribute{};
    if (!set_up<Depth>(&v[0], &v[1], &v[2], group, viewport, active,
                       [&](const auto& gradients) { gradients.fit(shade_of, attribute); }))
      continue;
    ++active_triangles;
    const Functions want = moved_to_corner(active, attribute);
    const PlaneEquation plane(&v[0], &v[1], &v[2], v.data(), viewport);
    expect_same(plane.depth<Depth>(), want.depth, corners);
    LinearFunction got{};
    plane.fit(shade_of, got);
    expect_same(got, want.attribute, corners);
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_GT(active_triangles, count / 8) << name_of(kind);
}

TEST(PlaneEquation, IsTheActiveTrianglesOwnForEveryKindAndDepth) {
  for (const TriangleKind kind : all_triangle_kinds) {
    compare<Depth16<>>(kind, rounds(2000));
    compare<Depth16<DepthSense::larger_is_nearer>>(kind, rounds(500));
    compare<Depth24<>>(kind, rounds(2000));
    compare<Depth24<DepthSense::larger_is_nearer>>(kind, rounds(500));
  }
}

TEST(PlaneEquation, DoesNotDependOnTheOrderOfOrientation) {
  TriangleMaker make(61, viewport.width, viewport.height, 0, 65534);
  for (int i = 0; i < rounds(2000); ++i) {
    const Corners corners = make(all_triangle_kinds[static_cast<std::size_t>(i) % all_triangle_kinds.size()]);
    const std::vector<ScreenVertex> v = vertices_of({&corners, 1}, 16, viewport.width, viewport.height);
    const PlaneEquation plane(&v[0], &v[1], &v[2], v.data(), viewport), turned(&v[0], &v[2], &v[1], v.data(), viewport);
    ASSERT_EQ(plane.doubled_area(), turned.doubled_area());
    if (plane.doubled_area() == 0) continue;
    const auto top_rows_differ = v[0].y != v[1].y && v[1].y != v[2].y && v[2].y != v[0].y;
    if (top_rows_differ) expect_same(plane.depth<Depth16<>>(), turned.depth<Depth16<>>(), corners);
  }
}

/// Values of any size at corners anywhere in the guard band, for pictures of any size: each word is the quotient of
/// exact integers, modulo 2^32, to a unit and what slopes of whole guard units lose on the way from the middle.
TEST(PlaneEquation, FitsAnyValuesAtAnyCornersInWordsThatDoNotOverflow) {
  Random random(62);
  for (int i = 0; i < rounds(6000); ++i) {
    const Viewport any{random.chance(3) ? 2047 : random.between(1, 2047),
                       random.chance(3) ? 2047 : random.between(1, 2047)};
    const int bits = std::array{16, 24, 26, 28}[static_cast<std::size_t>(random.between(0, 3))];
    TriangleMaker make(static_cast<std::uint32_t>(random.between(0, 1 << 30)), any.width, any.height, 0,
                       (1 << bits) - 1);
    Corners corners = make(all_triangle_kinds[static_cast<std::size_t>(random.between(0, 10))]);
    for (Corner& corner : corners)
      if (random.chance(3)) corner.z = random.chance(2) ? 0 : (1 << bits) - 1;
    const std::vector<ScreenVertex> v = vertices_of({&corners, 1}, 16, any.width, any.height);
    const PlaneEquation plane(&v[0], &v[1], &v[2], v.data(), any);
    if (plane.doubled_area() == 0) continue;
    const auto at = [&](unsigned k) { return corners[plane.index(plane.corners()[k])].z; };
    LinearFunction function{};
    plane.fit_fine({at(0), at(1), at(2)}, bits, function);
    const ExactTriangle exact(corners);
    const double guard = std::exp2(32 - bits), drift = any.width / 4.0 + any.height / 4.0;
    int looked_at = 0;
    for (int tries = 0; tries < 60 && looked_at < 6; ++tries) {
      const int x = random.between(0, any.width - 1), y = random.between(0, any.height - 1);
      if (!exact.covers(x, y)) continue;
      ++looked_at;
      LinearFunction row = function;
      row.skip_rows(y);
      const double off = std::remainder(row.at(x) - (exact.depth(x, y) + 0.5) * guard, 0x1p32);
      ASSERT_LE(std::abs(off), 2 * guard + drift) << x << ", " << y << ' ' << corners << bits << " bits";
    }
  }
}

}  // namespace
}  // namespace spanline::test
