// Depth by the lectures' formulas (lecture 004), and the lecture's own cases.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "spanline/frame/ready_made_traits.hpp"
#include "spanline/geometry/instance.hpp"
#include "support/effort.hpp"
#include "support/exact_view.hpp"
#include "support/random_instance.hpp"
#include "support/ready_made_studios.hpp"

namespace spanline::test {
namespace {

constexpr double one_millimetre = 0.001;

FrameView view_of(Projection projection, double near, double far, int bits) {
  FrameView view;
  view.camera.projection = projection;
  view.camera.near_plane = nearest<Q16_16>(near);
  view.camera.far_plane = nearest<Q16_16>(far);
  view.viewport = {64, 48};
  view.depth_bits = bits;
  view.nearest_depth = bits == 16 ? 0 : 16;
  view.farthest_depth = bits == 16 ? 65534 : (1u << 24) - 17;
  return view;
}

/// A one-unit instance, for its view units.
ViewTransform unit_transform(const FrameView& view) {
  static const OwnedMesh owned = tetrahedron();
  return {view, owned.view(), {}};
}

TEST(DepthFormula, IsRoundedToHalfAUnitOverTheWholeRange) {
  Random random(1);
  for (const Projection projection : {Projection::perspective, Projection::orthographic})
    for (const int bits : {16, 24}) {
      double worst = 0;
      for (int i = 0; i < rounds(20000); ++i) {
        const double near = std::exp2(random.real(-6, 8)), far = near * (1 + std::exp2(random.real(-4, 6)));
        const FrameView view = view_of(projection, near, far, bits);
        const ViewTransform transform = unit_transform(view);
        const PointProjection projected(view, transform);
        const OwnedMesh owned = tetrahedron();
        const Mesh mesh = owned.view();
        const ExactView exact(view, mesh, {});
        const std::int64_t z = random.wide(transform.near_plane(), transform.far_plane());
        const Real want = std::clamp<Real>(exact.depth(std::ldexp(static_cast<Real>(z), -transform.exponent())),
                                           view.nearest_depth, view.farthest_depth);
        worst = std::max(worst, static_cast<double>(std::fabs(want - static_cast<Real>(projected.depth_at(z)))));
      }
      std::printf("%s, %d bits: %.4f units at most\n",
                  projection == Projection::perspective ? "perspective" : "orthographic", bits, worst);
      EXPECT_LE(worst, bits == 16 ? 0.51 : 0.75);
    }
}

TEST(DepthFormula, HoldsWhereOrthographicPlanesLieFarBehindTheEye) {
  // Both planes, and a model of any size, however near: view units follow the farthest of them.
  Random random(2);
  const OwnedMesh owned = tetrahedron();
  const Mesh mesh = owned.view();
  for (const int bits : {16, 24}) {
    double worst = 0;
    for (int i = 0; i < rounds(4000); ++i) {
      const double near = -std::exp2(random.real(-4, 14.99)), far = near + std::exp2(random.real(-8, 1)) * -near;
      const FrameView view = view_of(Projection::orthographic, near, far, bits);
      Transform transform;
      transform.scale = Fixed<24>::from_raw(1 << random.between(4, 24));
      const ViewTransform to_view(view, mesh, transform);
      const std::int64_t reach = std::int64_t{1} << 43;
      ASSERT_LT(-to_view.near_plane(), reach) << near << " … " << far;
      ASSERT_LT(std::abs(to_view.far_plane()), reach) << near << " … " << far;
      const PointProjection projected(view, to_view);
      const ExactView exact(view, mesh, transform);
      const std::int64_t z = random.wide(to_view.near_plane(), to_view.far_plane());
      const Real want = std::clamp<Real>(exact.depth(std::ldexp(static_cast<Real>(z), -to_view.exponent())),
                                         view.nearest_depth, view.farthest_depth);
      worst = std::max(worst, static_cast<double>(std::fabs(want - static_cast<Real>(projected.depth_at(z)))));
    }
    std::printf("planes behind the eye, %d bits: %.4f units at most\n", bits, worst);
    EXPECT_LE(worst, bits == 16 ? 0.51 : 0.75);
  }
}

TEST(DepthFormula, NeverDecreasesWithDistance) {
  for (const Projection projection : {Projection::perspective, Projection::orthographic})
    for (const int bits : {16, 24}) {
      const FrameView view = view_of(projection, 0.5, 700, bits);
      const ViewTransform transform = unit_transform(view);
      const PointProjection projected(view, transform);
      std::uint32_t before = 0;
      const std::int64_t range = transform.far_plane() - transform.near_plane();
      for (std::int64_t i = 0; i <= 200000; i += stride(10)) {
        const std::uint32_t depth = projected.depth_at(transform.near_plane() + range * i / 200000);
        ASSERT_GE(depth, before);
        before = depth;
      }
      EXPECT_EQ(projected.depth_at(transform.near_plane()), view.nearest_depth);
      EXPECT_EQ(before, view.farthest_depth);
    }
}

/// The depth integer that a plane parallel to the picture gets, through the whole renderer.
template <class Depth>
std::int64_t drawn_depth(Projection projection, double near, double far, double distance) {
  OwnedMesh owned;
  owned.vertices = {{-8192, -8192, 0}, {8192, -8192, 0}, {8192, 8192, 0}, {-8192, 8192, 0}};
  owned.triangle(0, 1, 2);
  owned.triangle(0, 2, 3);
  owned.fit_bounds();
  FrameSettings settings;
  settings.camera = view_of(projection, near, far, 16).camera;
  settings.camera.focal =
      projection == Projection::perspective ? nearest<Q16_16>(200 * distance / 8) : Q16_16::from_int(40);
  if (settings.camera.focal.raw() > 20000 * 65536) settings.camera.focal = Q16_16::from_int(20000);
  Transform transform;
  transform.scale = Fixed<24>::from_int(16);
  transform.translation.z = nearest<Q16_16>(-distance);
  Studio<FlatTraits<Rgb565, Depth>> studio(mesh_capacity(16, 16, 1, 4, 2));
  const Mesh mesh = owned.view();
  studio.begin(settings);
  studio.add(mesh, transform, {});
  const auto picture = studio.draw();
  EXPECT_TRUE(studio.status().ok());
  EXPECT_TRUE(picture.drawn(8, 8)) << distance;
  return picture.depth_integer(8, 8);
}

// "rule of thumb: f : n < 1000 for a 24-bit depth buffer": one step at the far plane is at most 0.06.
TEST(Lecture004, OneStepOf24BitsAtTheFarPlaneIsAtMost6Hundredths) {
  const double n = 1, f = 1000;
  const FrameView view = view_of(Projection::perspective, n, f, 24);
  const ViewTransform transform = unit_transform(view);
  const PointProjection projected(view, transform);
  const auto depth = [&](double z) {
    return projected.depth_at(static_cast<std::int64_t>(std::llround(std::ldexp(z, transform.exponent()))));
  };
  // The last depths are kept for the clear value: the step is looked for just before them.
  for (double z = 900; z < 998; z += 0.5) ASSERT_LT(depth(z), depth(z + 0.06)) << z;
  EXPECT_LT(drawn_depth<Depth24<>>(Projection::perspective, n, f, 990),
            drawn_depth<Depth24<>>(Projection::perspective, n, f, 990.06));
}

// "with 16 bits cannot discern millimeter differences in objects at 1 km distance" – nor with depth linear in z.
TEST(Lecture004, PlanesAMillimetreApartAtAKilometreTieAt16Bits) {
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    int ties = 0;
    for (int i = 0; i < 10; ++i) {
      const double z = 990 + i * 0.37;
      ties += drawn_depth<Depth16<>>(projection, 1, 1000, z) ==
              drawn_depth<Depth16<>>(projection, 1, 1000, z + one_millimetre);
    }
    // A millimetre is 1/15 of a linear step: most pairs fall into one.
    EXPECT_GE(ties, 7);
  }
}

TEST(Lecture004, OrthographicKeepsDepth) {
  const std::int64_t near = drawn_depth<Depth16<>>(Projection::orthographic, 1, 101, 11),
                     middle = drawn_depth<Depth16<>>(Projection::orthographic, 1, 101, 51),
                     far = drawn_depth<Depth16<>>(Projection::orthographic, 1, 101, 91);
  EXPECT_NEAR(static_cast<double>(near), 6553.5, 1);
  EXPECT_NEAR(static_cast<double>(middle), 32767.5, 1);
  EXPECT_NEAR(static_cast<double>(far), 58981.5, 1);
}

TEST(Lecture004, TheFormulaOfTheFarPlaneDoesNotOverflow) {
  // The lecture's other form, (1 << N)·(a + b/z), would give 2^N at z = far.
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    EXPECT_EQ(drawn_depth<Depth16<>>(projection, 1, 100, 99.9999), 65534);
    EXPECT_EQ(drawn_depth<Depth24<>>(projection, 1, 100, 99.99999), (1 << 24) - 17);
  }
}

}  // namespace
}  // namespace spanline::test
