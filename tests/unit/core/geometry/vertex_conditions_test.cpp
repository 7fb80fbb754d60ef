// The conditions of the fast way of vertices are those that its header states, on either side of each.
#include <gtest/gtest.h>

#include "spanline/geometry/vertex_transform.hpp"
#include "support/random_instance.hpp"

namespace spanline::test {
namespace {

/// A mesh of radius 1 straight ahead.
struct Ahead {
  OwnedMesh owned;
  FrameView view;
  Transform transform;

  explicit Ahead(double distance) {
    owned.vertices = {{8192, 0, 0}, {-8192, 0, 0}, {0, 8192, 0}};
    owned.triangle(0, 1, 2);
    owned.bounds = {{}, 8192};
    transform.translation.z = nearest<Q16_16>(-distance);
    view.viewport = {320, 240};
    view.camera.focal = Q16_16::from_int(60);
    view.camera.near_plane = nearest<Q16_16>((distance - 1) * 0.9);
    view.camera.far_plane = nearest<Q16_16>((distance + 1) * 8);
  }

  [[nodiscard]] bool taken() const {
    const Mesh mesh = owned.view();
    const ViewTransform view_transform(view, mesh, transform);
    return VertexTransform::takes(view, view_transform, mesh, place(view, view_transform));
  }
};

// (d + 1) / (d − 1) = 4 at d = 5/3.
TEST(VertexTransformTakes, WhatIsAtMostFourTimesAsFarAtItsFarthestAsAtItsNearest) {
  EXPECT_TRUE(Ahead(1.70).taken());
  EXPECT_FALSE(Ahead(1.63).taken());
  EXPECT_FALSE(Ahead(1.2).taken());
  EXPECT_TRUE(Ahead(20).taken());
}

TEST(VertexTransformTakes, WhatStaysWithin512PixelsOfTheMiddle) {
  // The reach of 1 at a distance of 9 is focal / 9 pixels at most.
  Ahead ahead(10);
  ahead.view.camera.focal = Q16_16::from_int(4500);
  ahead.view.viewport = {1000, 1000};
  EXPECT_TRUE(ahead.taken());
  ahead.view.camera.focal = Q16_16::from_int(4700);
  EXPECT_FALSE(ahead.taken());
}

TEST(VertexTransformTakes, PlanesWhoseQuotientIsBelowFour) {
  // far / (far − near) = 4 where near is three quarters of far.
  Ahead ahead(100);
  ahead.view.camera.far_plane = Q16_16::from_int(130);
  ahead.view.camera.near_plane = Q16_16::from_int(97);
  EXPECT_TRUE(ahead.taken());
  ahead.view.camera.near_plane = Q16_16::from_int(98);
  EXPECT_FALSE(ahead.taken());
}

TEST(VertexTransformTakes, NothingThatPlanesCutOrThatIsSeenInParallel) {
  Ahead cut(10);
  cut.view.camera.near_plane = Q16_16::from_int(10);
  EXPECT_FALSE(cut.taken());
  Ahead parallel(10);
  parallel.view.camera.projection = Projection::orthographic;
  EXPECT_FALSE(parallel.taken());
}

}  // namespace
}  // namespace spanline::test
