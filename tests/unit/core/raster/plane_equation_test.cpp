// A triangle has one plane: what algorithms ask PlaneEquation for is what set-up gives an active triangle.
#include "spanline/raster/plane_equation.hpp"
#include "spanline/raster/attribute_gradients.hpp"

#include <gtest/gtest.h>

#include "spanline/raster/triangle_setup.hpp"
#include "support/effort.hpp"
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

}  // namespace
}  // namespace spanline::test
