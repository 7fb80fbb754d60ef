// Which polygons may be marked as planar: corners against exact 128-bit sums, attributes against linear functions in
// double precision.
#include "spanline/model/planarity.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "support/owned_mesh.hpp"
#include "support/random.hpp"

namespace spanline::test {
namespace {

__extension__ using Wide = __int128;

/// A mesh of one polygon.
OwnedMesh polygon_of(std::vector<Vertex32> corners) {
  OwnedMesh mesh;
  mesh.corners = {static_cast<std::uint8_t>(corners.size())};
  for (std::size_t i = 0; i < corners.size(); ++i) mesh.indices.push_back(static_cast<std::uint16_t>(i));
  mesh.wide_vertices = std::move(corners);
  return mesh;
}

Planarity planarity(const OwnedMesh& mesh) { return planarity_of(mesh.view(), 0, 0); }

/// The corners' distance from one another along Newell's normal, squared and times the normal's squared length, and
/// that squared length.
struct ExactThickness {
  Wide thickness, length_squared;

  explicit ExactThickness(const std::vector<Vertex32>& corners) {
    Wide n[3] = {}, low = 0, high = 0;
    const auto from_first = [&](std::size_t i, int axis) -> Wide {
      const auto of = [axis](const Vertex32& v) -> Wide { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; };
      return of(corners[i]) - of(corners[0]);
    };
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
      for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        n[axis] += from_first(i, u) * from_first(i + 1, v) - from_first(i, v) * from_first(i + 1, u);
      }
    for (std::size_t i = 0; i < corners.size(); ++i) {
      Wide height = 0;
      for (int axis = 0; axis < 3; ++axis) height += n[axis] * from_first(i, axis);
      low = std::min(low, height);
      high = std::max(high, height);
    }
    thickness = high - low;
    length_squared = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
  }
  /// Thickness in steps, or a great number for a polygon without area.
  [[nodiscard]] double steps() const {
    if (length_squared == 0) return 1e30;
    return static_cast<double>(thickness) / std::sqrt(static_cast<double>(length_squared));
  }
};

/// Corners of a convex polygon on a random plane, rounded to steps.
struct RandomPolygon {
  std::vector<Vertex32> corners;
  std::vector<double> u, v;  ///< coordinates on the plane

  RandomPolygon(Random& random, int count, double size) {
    double axis[2][3];
    for (auto& row : axis)
      for (double& c : row) c = random.real(-1, 1);
    const double turn = random.real(0, 6.28);
    for (int i = 0; i < count; ++i) {
      const double angle = turn + 6.2831853 * (i + random.real(0, 0.9)) / count;
      u.push_back(size * std::cos(angle));
      v.push_back(size * std::sin(angle));
      const auto along = [&](int k) {
        return static_cast<std::int32_t>(std::lround(u.back() * axis[0][k] + v.back() * axis[1][k]));
      };
      corners.push_back({along(0), along(1), along(2)});
    }
  }
};

RC_GTEST_PROP(Planarity, IsThatOfExactSums, ()) {
  Random random(*rc::gen::arbitrary<std::uint32_t>());
  for (int round = 0; round < 100; ++round) {
    const RandomPolygon polygon(random, random.between(4, 8), std::exp2(random.real(1, 15)));
    const double steps = ExactThickness(polygon.corners).steps();
    const Planarity found = planarity(polygon_of(polygon.corners));
    if (steps > 1) RC_ASSERT(found == Planarity::bent);
    if (steps < 1 - 1e-8) RC_ASSERT(found == Planarity::planar);
  }
}

TEST(Planarity, CornersMayLieHalfAStepFromThePlane) {
  EXPECT_EQ(planarity(polygon_of({{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}})), Planarity::planar);
  // Newell's normal of such a square leans so that its corners lie half as far from the middle as one corner is lifted.
  EXPECT_EQ(planarity(polygon_of({{0, 0, 0}, {9, 0, 0}, {9, 9, 1}, {0, 9, 0}})), Planarity::planar);
  EXPECT_EQ(planarity(polygon_of({{0, 0, 0}, {99, 0, 0}, {99, 99, 2}, {0, 99, 0}})), Planarity::planar);
  EXPECT_EQ(planarity(polygon_of({{0, 0, 0}, {99, 0, 0}, {99, 99, 3}, {0, 99, 0}})), Planarity::bent);
  EXPECT_EQ(planarity(polygon_of({{0, 0, 0}, {9, 0, 0}, {18, 0, 0}, {27, 0, 0}})), Planarity::bent) << "no area";
}

TEST(Planarity, LargePolygonsAreMeasuredInLargerUnits) {
  constexpr std::int32_t reach = 1 << 17, whole_range = 1 << 30;
  const auto lifted_square = [](std::int32_t from, std::int32_t to, std::int32_t lift, int axis) {
    std::vector<Vertex32> corners{{from, from, 0}, {to, from, 0}, {to, to, lift}, {from, to, 0}};
    if (axis == 1)
      for (Vertex32& v : corners) v = {v.z, v.x, v.y};
    if (axis == 2)
      for (Vertex32& v : corners) v = {v.y, v.z, v.x};
    return planarity(polygon_of(corners));
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (const std::int32_t from : {0, whole_range - 2 * reach, -whole_range}) {
      // A corner may be lifted by two units, which are steps within reach and twice as long beyond.
      EXPECT_EQ(lifted_square(from, from + reach, 2, axis), Planarity::planar);
      EXPECT_EQ(lifted_square(from, from + reach, 3, axis), Planarity::bent);
      EXPECT_EQ(lifted_square(from, from + reach + 1, 2, axis), Planarity::planar);
      EXPECT_EQ(lifted_square(from, from + reach + 1, 6, axis), Planarity::bent);
      EXPECT_EQ(lifted_square(from + 2 * reach, from, 4, axis), Planarity::planar);
    }
    // 2^31 steps are 2^17 units of 2^14 steps.
    EXPECT_EQ(lifted_square(-whole_range, whole_range, 2 << 14, axis), Planarity::planar);
    EXPECT_EQ(lifted_square(-whole_range, whole_range, 3 << 14, axis), Planarity::bent);
  }
}

/// A polygon with texture coordinates that are a linear function on its plane, rounded.
struct Textured {
  RandomPolygon polygon;
  double along_u, along_v;
  OwnedMesh mesh;

  explicit Textured(Random& random)
      : polygon(random, random.between(4, 8), std::exp2(random.real(6, 14))),
        along_u(random.real(-0.9, 0.9)),
        along_v(random.real(-0.9, 0.9)),
        mesh(polygon_of(polygon.corners)) {
    for (std::size_t i = 0; i < polygon.u.size(); ++i) {
      const double s = along_u * polygon.u[i] + along_v * polygon.v[i];
      mesh.texture_coordinates.push_back({0, static_cast<std::int16_t>(std::lround(s))});
    }
  }
};

RC_GTEST_PROP(Planarity, RoundedLinearAttributesAreLinear, ()) {
  Random random(*rc::gen::arbitrary<std::uint32_t>());
  int flat = 0;
  for (int round = 0; round < 100; ++round) {
    Textured textured(random);
    if (ExactThickness(textured.polygon.corners).steps() > 0.9) continue;
    ++flat;
    if (textured.polygon.corners.size() == 4) RC_ASSERT(planarity(textured.mesh) == Planarity::planar);
    // A corner whose value is off by a sixteenth of the polygon's size is told, whichever it is.
    const auto corner = static_cast<std::size_t>(random.between(0, static_cast<int>(textured.polygon.u.size()) - 1));
    const double size = std::hypot(textured.polygon.u[0], textured.polygon.v[0]);
    if (size < 4096) continue;
    textured.mesh.texture_coordinates[corner].t =
        static_cast<std::int16_t>(textured.mesh.texture_coordinates[corner].t + static_cast<std::int16_t>(size / 16));
    RC_ASSERT(planarity(textured.mesh) == Planarity::unlinear);
  }
  RC_ASSERT(flat > 0);
}

TEST(Planarity, EveryAttributeOfTheTablesCounts) {
  OwnedMesh mesh = polygon_of({{0, 0, 0}, {1000, 0, 0}, {1000, 1000, 0}, {0, 1000, 0}});
  mesh.texture_coordinates = {{0, 0}, {500, 7}, {600, 107}, {100, 100}};
  mesh.vertex_colours = {{0, 9, 200}, {100, 9, 100}, {200, 9, 100}, {100, 9, 200}};
  mesh.vertex_opacities = {255, 200, 100, 155};
  EXPECT_EQ(planarity(mesh), Planarity::planar);
  const auto spoil = [&](auto change) {
    OwnedMesh spoilt = mesh;
    change(spoilt);
    EXPECT_EQ(planarity(spoilt), Planarity::unlinear);
  };
  spoil([](OwnedMesh& m) { m.texture_coordinates[3].s = 50; });
  spoil([](OwnedMesh& m) { m.texture_coordinates[1].t = 57; });
  spoil([](OwnedMesh& m) { m.vertex_colours[2].red = 150; });
  spoil([](OwnedMesh& m) { m.vertex_colours[0].green = 60; });
  spoil([](OwnedMesh& m) { m.vertex_colours[3].blue = 100; });
  spoil([](OwnedMesh& m) { m.vertex_opacities[2] = 200; });
}

}  // namespace
}  // namespace spanline::test
