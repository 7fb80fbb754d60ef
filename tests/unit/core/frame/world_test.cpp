// What an algorithm is told of a frame before its first band.
#include <gtest/gtest.h>

#include <spanline/frame/ready_made_traits.hpp>
#include <vector>

#include "scenes/torus_mesh.hpp"
#include "support/ready_made_studios.hpp"

namespace spanline::test {
namespace {

using namespace spanline::literals;

/// What the last frame began with.
struct Seen {
  Link polygons = 0;
  Viewport viewport{};
  std::int32_t band_lines = 0;
  bool has_world = false;
  Position eye{};
  std::vector<PlacedInstance> instances;
} seen;

/// The z-buffer, which notes what a frame begins with.
template <AlgorithmNeeds Needs>
struct Witness {
  template <class Depth, class Pixel, class Shaders, bool Counting>
  struct Algorithm : DepthBuffer<Depth, Pixel, Shaders, Counting> {
    using Base = DepthBuffer<Depth, Pixel, Shaders, Counting>;
    using Base::Base;
    static constexpr AlgorithmNeeds needs = Needs;
    void begin_frame(const FrameInput& input) {
      seen = {input.table.polygon_count, input.viewport, input.band_lines, input.world != nullptr, {}, {}};
      if (input.world != nullptr) {
        seen.eye = input.world->camera.eye;
        seen.instances.assign(input.world->instances.begin(), input.world->instances.end());
      }
      Base::begin_frame(input);
    }
  };
};

using InWorld = FlatTraits<Rgb565, Witness<AlgorithmNeeds::world>>;
using OnScreen = FlatTraits<Rgb565, Witness<AlgorithmNeeds::screen_polygons>>;

FrameSettings settings_from(Position eye) {
  FrameSettings settings;
  settings.camera.eye = eye;
  return settings;
}
Transform at(Q16_16 x, Q16_16 z) {
  Transform transform;
  transform.translation = {x, {}, z};
  return transform;
}

TEST(FrameInput, HasTheWholeTableTheViewportAndTheWorldBeforeTheFirstBand) {
  Studio<InWorld> studio(mesh_capacity(80, 60, 4, 2000, 1000));
  studio.begin(settings_from({0.1_q16, 0.2_q16, 0.3_q16}));
  studio.add(scenes::torus, at(0.5_q16, -4.0_q16), {});
  studio.add(scenes::torus, at(0.0_q16, 400.0_q16), {});  // behind the eye: left out
  studio.add(scenes::torus, at(-0.5_q16, -5.0_q16), {});
  (void)studio.draw();
  EXPECT_TRUE(studio.status().ok());
  EXPECT_GT(seen.polygons, 100U);
  EXPECT_EQ(seen.viewport.width, 80);
  EXPECT_EQ(seen.viewport.height, 60);
  EXPECT_EQ(seen.band_lines, 60);
  ASSERT_TRUE(seen.has_world);
  EXPECT_EQ(seen.eye.y.raw(), (0.2_q16).raw());
  ASSERT_EQ(seen.instances.size(), 2U);
  EXPECT_EQ(seen.instances[0].mesh, &scenes::torus);
  EXPECT_EQ(seen.instances[0].transform.translation.x.raw(), (0.5_q16).raw());
  EXPECT_EQ(seen.instances[1].transform.translation.z.raw(), (-5.0_q16).raw());
  EXPECT_EQ(seen.instances[1].group, 1U);
}

TEST(FrameInput, HasNoWorldForThoseThatTakePolygonsOnScreenAlone) {
  Studio<OnScreen> studio(screen_capacity(80, 60, 1));
  const Corners t{Corner{0, 0, 5}, Corner{700, 0, 5}, Corner{0, 700, 5}};
  (void)studio.draw_screen({&t, 1});
  EXPECT_EQ(seen.polygons, 1U);
  EXPECT_FALSE(seen.has_world);
}

TEST(FrameInput, PolygonsOnScreenAreRefusedByAnAlgorithmOfTheWorld) {
  Studio<InWorld> studio(screen_capacity(80, 60, 1));
  const Corners t{Corner{0, 0, 5}, Corner{700, 0, 5}, Corner{0, 700, 5}};
  (void)studio.draw_screen({&t, 1});
  EXPECT_EQ(studio.status().fault, Fault::no_world);
}

}  // namespace
}  // namespace spanline::test
