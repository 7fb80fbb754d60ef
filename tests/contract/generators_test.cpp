// Scenes that show nothing test nothing.
#include "generators.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "draw_surfaces.hpp"
#include "support/effort.hpp"

namespace spanline::contract {
namespace {

class Generators : public ::testing::TestWithParam<Generator> {};

TEST_P(Generators, MakeScenesThatShowPolygonsAndTheSameOnesAgain) {
  int shown = 0;
  const int count = test::sample_size(24);
  for (int round = 0; round < count; ++round) {
    Random random(seed_of(GetParam(), round)), again(seed_of(GetParam(), round));
    const Drawing drawing = reference(GetParam().make(random));
    ASSERT_TRUE(drawing.status.ok()) << to_string(drawing.status.pool);
    ASSERT_EQ(drawing.pixels, reference(GetParam().make(again)).pixels);
    std::vector<std::uint32_t> ids = drawing.pixels;
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    if (ids.size() > 2) ++shown;
  }
  EXPECT_GE(3 * shown, count) << "scenes with more than one polygon to be seen";
}

std::string name_of(const ::testing::TestParamInfo<Generator>& info) { return info.param.name; }
INSTANTIATE_TEST_SUITE_P(OnScreen, Generators, ::testing::ValuesIn(screen_generators()), name_of);
INSTANTIATE_TEST_SUITE_P(OfMeshes, Generators, ::testing::ValuesIn(mesh_generators()), name_of);
INSTANTIATE_TEST_SUITE_P(OfSurfaces, Generators, ::testing::Values(surface_generator()), name_of);

TEST(SurfaceGenerator, MakesPicturesOfManyColours) {
  int colourful = 0;
  const int count = test::sample_size(40);
  for (int round = 0; round < count; ++round) {
    Random random(seed_of(surface_generator(), round));
    const Drawing drawing = reference_of_surfaces(surfaces(random), {});
    ASSERT_TRUE(drawing.status.ok()) << to_string(drawing.status.fault);
    if (std::set<std::uint32_t>(drawing.pixels.begin(), drawing.pixels.end()).size() > 30) ++colourful;
  }
  EXPECT_GE(3 * colourful, 2 * count);
}

TEST(NestedGenerator, MakesPolygonsSleep) {
  std::uint64_t sleeps = 0;
  int with_sleep = 0;
  const int count = test::sample_size(80);
  for (int round = 0; round < count; ++round) {
    Random random(seed_of(generator("nested"), round));
    const std::uint64_t here = draw(algorithm("span"), nested_polygons(random), {}).counters.named("sleeps");
    sleeps += here;
    if (here != 0) ++with_sleep;
  }
  std::printf("%llu sleeps in %d of %d scenes\n", static_cast<unsigned long long>(sleeps), with_sleep, count);
  EXPECT_GE(2 * with_sleep, count);
}

}  // namespace
}  // namespace spanline::contract
