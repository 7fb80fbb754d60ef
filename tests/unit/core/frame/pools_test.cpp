// Pools that are too small: the Status names the pool and a size that is enough; the rest is drawn, the same way twice.
#include <gtest/gtest.h>
#include <spanline/frame/ready_made_traits.hpp>
#include <spanline/model/cull.hpp>

#include <functional>
#include <vector>

#include "scenes/prisms_mesh.hpp"
#include "support/effort.hpp"
#include "support/owned_mesh.hpp"
#include "support/ready_made_studios.hpp"
#include "support/triangle_kinds.hpp"

namespace spanline::test {
namespace {

using namespace spanline::literals;
using Traits = GouraudTraits<Rgb565, Depth16<>>;

/// A frame that takes something of every pool: two meshes of n-gons and triangles, cut by the near plane and in bands.
struct Scene {
  OwnedMesh solid = tetrahedron();
  FrameSettings settings;
  Transform near_one, far_one;
  static constexpr Material smooth{{200, 100, 50}, ShadingMode::gouraud}, flat{{50, 100, 200}, ShadingMode::flat};

  Scene() {
    settings.cull = Cull::none;
    settings.camera.near_plane = 1.0_q16;
    settings.camera.far_plane = 50.0_q16;
    near_one.translation = {0.25_q16, {}, -1.5_q16};  // reaches through the near plane
    far_one.translation = {-0.5_q16, 0.25_q16, -4.0_q16};
    near_one.rotation = rotation_x(Angle::from_degrees(20));
    far_one.rotation = rotation_x(Angle::from_degrees(50));
  }

  /// Draws the frame; `fault` gets the first Status that is not ok.
  Picture<Traits> draw(const Capacity& capacity, Status& fault) const {
    Studio<Traits> studio(capacity);
    studio.begin(settings);
    const Mesh mesh = solid.view();
    studio.add(mesh, near_one, smooth);
    studio.add(scenes::prisms, far_one, flat);
    studio.add(mesh, far_one, smooth);
    auto picture = studio.draw();
    fault = studio.status();
    return picture;
  }
};

Capacity ample() {
  Capacity c;
  c.width = 160;
  c.height = 120;
  c.band_lines = 16;
  c.instances = 10;
  c.vertices = c.shades = c.polygons = c.fans = c.active = c.awake = 1000;
  return c;
}

std::uint32_t& size_of(Capacity& c, Pool pool) {
  switch (pool) {
    case Pool::instances:
      return c.instances;
    case Pool::vertices:
      return c.vertices;
    case Pool::shades:
      return c.shades;
    case Pool::polygons:
      return c.polygons;
    case Pool::fans:
      return c.fans;
    default:
      return c.active;
  }
}

class Starved : public ::testing::TestWithParam<Pool> {};

TEST_P(Starved, TheStatusNamesThePoolAndSizesThatLeadToTheWholePicture) {
  const Scene scene;
  Status status;
  const auto whole = scene.draw(ample(), status);
  ASSERT_TRUE(status.ok());
  Capacity capacity = ample();
  size_of(capacity, GetParam()) = 1;
  int steps = 0;
  for (;; ++steps) {
    const auto picture = scene.draw(capacity, status);
    if (status.ok()) {
      EXPECT_TRUE(picture == whole);
      break;
    }
    ASSERT_EQ(status.fault, Fault::pool_full) << to_string(status.fault);
    ASSERT_EQ(status.pool, GetParam()) << to_string(status.pool);
    ASSERT_GT(status.wanted, size_of(capacity, GetParam())) << "following the advice must lead on";
    ASSERT_LT(steps, 10);
    size_of(capacity, GetParam()) = status.wanted;
  }
  EXPECT_GT(steps, 0) << "one entry was enough: the scene starves nothing";
}

TEST_P(Starved, TheSizeThatTheLastStatusNamesIsTheLeast) {
  const Scene scene;
  Capacity capacity = ample();
  size_of(capacity, GetParam()) = 1;
  Status status;
  for (;;) {
    (void)scene.draw(capacity, status);
    if (status.ok()) break;
    ASSERT_GT(status.wanted, size_of(capacity, GetParam()));
    size_of(capacity, GetParam()) = status.wanted;
  }
  --size_of(capacity, GetParam());
  (void)scene.draw(capacity, status);
  EXPECT_EQ(status.pool, GetParam());
}

TEST_P(Starved, WhatFitsIsDrawnTheSameWayTwice) {
  const Scene scene;
  Status status;
  for (const std::uint32_t size : {0u, 1u, 2u, 5u, 7u, 12u, 30u, 60u}) {
    Capacity capacity = ample();
    size_of(capacity, GetParam()) = size;
    const auto once = scene.draw(capacity, status);
    const auto twice = scene.draw(capacity, status);
    EXPECT_TRUE(once == twice) << size;
  }
}

TEST_P(Starved, TheSameRendererDrawsAWholeFrameAfterwards) {
  const Scene scene;
  Capacity capacity = ample();
  size_of(capacity, GetParam()) = 1;
  Studio<Traits> studio(capacity);
  FrameSettings settings;
  const OwnedMesh owned = tetrahedron(512);
  const Mesh small = owned.view();
  Transform far;
  far.translation.z = -60.0_q16;
  const auto small_frame = [&] {
    studio.begin(settings);
    if (GetParam() != Pool::vertices && GetParam() != Pool::shades && GetParam() != Pool::polygons)
      studio.add(small, far, {{255, 255, 255}, ShadingMode::flat});
    return studio.draw();
  };
  const auto before = small_frame();
  ASSERT_TRUE(studio.status().ok());
  studio.begin(scene.settings);
  const Mesh mesh = scene.solid.view();
  studio.add(mesh, scene.near_one, Scene::smooth);
  studio.add(scenes::prisms, scene.far_one, Scene::flat);
  (void)studio.draw();
  ASSERT_FALSE(studio.status().ok());
  const auto after = small_frame();
  EXPECT_TRUE(studio.status().ok());
  EXPECT_TRUE(before == after);
}

INSTANTIATE_TEST_SUITE_P(Pools, Starved,
                         ::testing::Values(Pool::instances, Pool::vertices, Pool::shades, Pool::polygons, Pool::fans,
                                           Pool::active),
                         [](const auto& pool) { return to_string(pool.param); });

// Regression: polygons that only follow one another need room together while the band of the change is drawn.
TEST(ActivePool, TheNamedSizeIsEnoughWherePolygonsTakeTurns) {
  const std::vector<Corners> turns{
      {Corner{100, 15 * 16, 50}, Corner{900, 15 * 16, 50}, Corner{500, 25 * 16, 50}},  // rows 15 … 24, submitted first
      {Corner{100, 5 * 16, 60}, Corner{900, 5 * 16, 60}, Corner{500, 15 * 16, 60}}};   // rows 5 … 14
  Capacity capacity = screen_capacity(64, 40, 2, 10);
  capacity.active = 0;
  for (int step = 0; step < 5; ++step) {
    Studio<Traits> studio(capacity);
    (void)studio.draw_screen(turns);
    if (studio.status().ok()) return;
    ASSERT_EQ(studio.status().pool, Pool::active);
    ASSERT_GT(studio.status().wanted, capacity.active) << "the named size was given and was not enough";
    capacity.active = studio.status().wanted;
  }
  FAIL() << "no size is enough";
}

TEST(ActivePool, TheNamedSizeIsEnoughForRandomSoups) {
  TriangleMaker make(3, 100, 100, 0, 65534);
  for (int i = 0; i < rounds(200); ++i) {
    std::vector<Corners> soup;
    for (std::size_t k = 0; k < 40; ++k) soup.push_back(make(all_triangle_kinds[k % all_triangle_kinds.size()]));
    Capacity capacity = screen_capacity(100, 100, soup.size(), 1 + i % 30);
    capacity.active = 0;
    Studio<Traits> starved(capacity);
    (void)starved.draw_screen(soup);
    if (starved.status().ok()) continue;
    ASSERT_EQ(starved.status().pool, Pool::active);
    capacity.active = starved.status().wanted;
    Studio<Traits> fed(capacity);
    (void)fed.draw_screen(soup);
    ASSERT_TRUE(fed.status().ok()) << "round " << i << ": " << capacity.active << " active, then "
                                   << fed.status().wanted;
  }
}

}  // namespace
}  // namespace spanline::test
