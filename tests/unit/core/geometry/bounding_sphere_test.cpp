// The sphere of an instance holds its vertices as rounding leaves them, and is outside only if they are.
#include <gtest/gtest.h>

#include "spanline/geometry/vertex_transform.hpp"
#include "support/effort.hpp"
#include "support/exact_view.hpp"
#include "support/random_instance.hpp"

namespace spanline::test {
namespace {

__int128 square(std::int64_t v) { return static_cast<__int128>(v) * v; }

/// Vertices at exactly the radius: at the ends of the axes, turned with the instance.
OwnedMesh star(std::int16_t radius) {
  OwnedMesh owned;
  const auto minus = static_cast<std::int16_t>(-radius);
  owned.vertices = {{radius, 0, 0}, {minus, 0, 0}, {0, radius, 0}, {0, minus, 0}, {0, 0, radius}, {0, 0, minus}};
  owned.triangle(0, 2, 4);
  owned.triangle(1, 3, 5);
  owned.bounds = {{}, static_cast<std::uint32_t>(radius)};
  return owned;
}

TEST(BoundingSphere, HoldsVerticesOnItInViewSpace) {
  Random random(1);
  for (int i = 0; i < rounds(20000); ++i) {
    RandomInstance r(random, {.closest = 0.1, .aside = 3, .vertices = 3});
    const OwnedMesh owned = star(static_cast<std::int16_t>(random.between(1, 32767)));
    Mesh mesh = owned.view();
    mesh.step_exponent = r.mesh.step_exponent;
    const ViewTransform transform(r.view, mesh, r.transform);
    const ViewPoint c = transform.sphere_centre();
    for (std::size_t k = 0; k < mesh.vertex_count(); ++k) {
      const ViewPoint v = view_point(transform, mesh, k);
      ASSERT_LE(square(v.x - c.x) + square(v.y - c.y) + square(v.z - c.z), square(transform.sphere_radius()))
          << "round " << i;
    }
  }
}

// A mesh that is a point, at the very border of what is seen.
TEST(BoundingSphere, IsNotOutsideWhereAPointInsideTouchesTheBorder) {
  Random random(2);
  int seen = 0;
  for (int i = 0; i < rounds(20000); ++i) {
    OwnedMesh owned;
    owned.vertices = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    owned.triangle(0, 1, 2);
    owned.bounds = {};
    FrameView view;
    view.viewport = {random.between(16, 1000), random.between(16, 800)};
    // In sixteenths of a pixel, to which culling rounds it; planes so far away that a unit of view space counts.
    view.camera.focal = Q16_16::from_raw(random.between(8 * 16, 4096 * 16) << 12);
    view.camera.far_plane = Q16_16::from_int(1 << random.between(6, 14));
    const double z = std::exp2(random.real(0, static_cast<double>(std::log2(real(view.camera.far_plane))) - 0.1)),
                 focal = std::ldexp(view.camera.focal.raw(), -16);
    const double half_x = view.viewport.width * 0.5 / focal * z, half_y = view.viewport.height * 0.5 / focal * z;
    Transform transform;
    const bool side = random.chance(2);
    const double sign = random.chance(2) ? 1 : -1;
    transform.translation = {nearest<Q16_16>(side ? sign * half_x : random.real(-half_x, half_x)),
                             nearest<Q16_16>(side ? random.real(-half_y, half_y) : sign * half_y), nearest<Q16_16>(-z)};
    const Mesh mesh = owned.view();
    const ExactVertex exact = ExactView(view, mesh, transform)(0);
    if (exact.x < 0 || exact.y < 0 || exact.x > view.viewport.width * 16 || exact.y > view.viewport.height * 16)
      continue;
    ++seen;
    const ViewTransform view_transform(view, mesh, transform);
    ASSERT_NE(place(view, view_transform), Placement::outside) << "round " << i;
  }
  EXPECT_GT(seen, rounds(20000) / 4);
}

}  // namespace
}  // namespace spanline::test
