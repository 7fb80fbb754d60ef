// More polygons than depth sort has members of a band: the farthest are left out of the band and come back in the next
// one; what is drawn is drawn right, and the status says what would do. The same for see-through polygons.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "brute_force.hpp"
#include "generators.hpp"
#include "layers.hpp"
#include "sizes.hpp"
#include "spanline/shade/layer/layering.hpp"
#include "support/effort.hpp"
#include "support/exact_triangle.hpp"
#include "verdict.hpp"

namespace spanline::contract {
namespace {

const AlgorithmEntry& depth_sort() { return algorithm("depth-sort"); }

Manner with_room(std::uint32_t members, int band_lines) { return {.band_lines = band_lines, .active = members}; }

class FullMembers : public ::testing::TestWithParam<std::uint32_t> {
 protected:
  /// Draws random scenes with this much room, and calls f(scene, band_lines, picture) where that is not enough.
  template <class F>
  void for_each_starved(F f) {
    for (const char* name : {"mixed_soup", "penetrating", "stack", "nested", "quads_on_centres", "soup_tiny"})
      for (int i = 0; i < test::rounds(24); ++i) {
        const int round = i + 11'000'000;
        Random random(seed_of(generator(name), round));
        const Scene scene = generator(name).make(random);
        const int band_lines = 1 + i % 20;
        const Drawing got = draw(depth_sort(), scene, with_room(GetParam(), band_lines));
        if (got.status.ok()) {
          ASSERT_EQ(difference(reference(scene), got), "") << name << ", seed " << seed_of(generator(name), round);
          continue;
        }
        ++starved_;
        f(scene, band_lines, got);
        if (HasFatalFailure()) FAIL() << name << ", seed " << seed_of(generator(name), round);
      }
    EXPECT_GT(starved_, 0) << "there was room enough everywhere: nothing is shown";
  }

  int starved_ = 0;
};

TEST_P(FullMembers, TheStatusNamesTheSizeThatIsEnough) {
  for_each_starved([&](const Scene& scene, int band_lines, const Drawing& got) {
    ASSERT_EQ(got.status.fault, Fault::pool_full);
    ASSERT_EQ(got.status.pool, Pool::members);
    const std::uint32_t wanted = got.status.wanted;
    ASSERT_GT(wanted, GetParam());
    const Drawing whole = draw(depth_sort(), scene, with_room(wanted, band_lines));
    ASSERT_TRUE(whole.status.ok()) << wanted << " were named, then " << whole.status.wanted;
    ASSERT_EQ(difference(reference(scene), whole), "");
    ASSERT_EQ(draw(depth_sort(), scene, with_room(wanted - 1, band_lines)).status, got.status);
  });
}

TEST_P(FullMembers, EveryPixelIsShadedOnceByAPolygonThatCoversIt) {
  for_each_starved([&](const Scene& scene, int, const Drawing& got) {
    ASSERT_EQ(got.counters.named("shaded"), scene.pixel_count());
    ASSERT_EQ(garbage_pixels(scene, got), 0U);
  });
}

/// Triangles of constant depths, all different, and no picture so high that boxes are rounded.
Scene level_polygons(Random& random) {
  Scene scene = sized(random);
  scene.height = std::min(scene.height, 128);
  const int count = random.between(20, 120);
  for (int i = 0; i < count; ++i) {
    const std::int32_t z = depth_near((i + 1) * std::int64_t{farthest_depth / 128});
    const auto corner = [&] {
      return Corner{random.between(0, 16 * scene.width), random.between(0, 16 * scene.height), z};
    };
    scene.triangles.push_back({corner(), corner(), corner()});
  }
  shuffle(random, scene.triangles);
  return scene;
}

/// Pixel centres lie between the outermost corners both ways, as a member of a band must have them.
bool reaches(const Corners& t, int Corner::*axis, int first, int end) {
  const auto [low, high] = std::minmax({t[0].*axis, t[1].*axis, t[2].*axis});
  return std::max((low + 7) >> 4, first) < std::min((high + 7) >> 4, end);
}

/// Of each band the nearest polygons that there is room for, drawn from back to front.
std::vector<std::uint32_t> picture_of_the_nearest(const Scene& scene, std::size_t room, int band_lines) {
  std::vector<std::uint32_t> pixels(scene.pixel_count());
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < scene.triangles.size(); ++i)
    if (reaches(scene.triangles[i], &Corner::x, 0, scene.width) &&
        reaches(scene.triangles[i], &Corner::y, 0, scene.height))
      order.push_back(i);
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return scene.triangles[a][0].z < scene.triangles[b][0].z; });
  for (int top = 0; top < scene.height; top += band_lines) {
    const int bottom = std::min(top + band_lines, scene.height);
    std::vector<std::size_t> members;
    for (const std::size_t i : order)
      if (members.size() < room && reaches(scene.triangles[i], &Corner::y, top, bottom)) members.push_back(i);
    for (auto i = members.rbegin(); i != members.rend(); ++i)
      test::ExactTriangle(scene.triangles[*i]).for_each_pixel(scene.width, bottom, [&](int x, int y) {
        if (y >= top) pixels[static_cast<std::size_t>(y * scene.width + x)] = static_cast<std::uint32_t>(*i + 1);
      });
  }
  return pixels;
}

TEST_P(FullMembers, TheNearestPolygonsOfEachBandAreKept) {
  for (int round = 0; round < test::rounds(160); ++round) {
    Random random(static_cast<std::uint32_t>(round + 1));
    const Scene scene = level_polygons(random);
    const int band_lines = std::min(1 + round % 17, scene.height);
    const Drawing got = draw(depth_sort(), scene, with_room(GetParam(), band_lines));
    ASSERT_EQ(got.pixels, picture_of_the_nearest(scene, GetParam(), band_lines))
        << "round " << round << ", bands of " << band_lines << '\n'
        << text_of(scene);
    if (!got.status.ok()) ++starved_;
  }
  EXPECT_GT(starved_, 0);
}

INSTANTIATE_TEST_SUITE_P(RoomFor, FullMembers, ::testing::Values(32, 16, 5, 1),
                         [](const auto& room) { return std::to_string(room.param); });

TEST(FullMembersWithoutRoom, ShowTheBackgroundAndSayWhatIsWanted) {
  Random random(1);
  const Scene scene = mixed_soup(random);
  const Drawing got = draw(depth_sort(), scene, with_room(0, 7));
  EXPECT_EQ(got.status.pool, Pool::members);
  EXPECT_EQ(got.pixels, std::vector<std::uint32_t>(scene.pixel_count(), 0));
  const Drawing whole = draw(depth_sort(), scene, with_room(got.status.wanted, 7));
  EXPECT_TRUE(whole.status.ok());
  EXPECT_EQ(difference(reference(scene), whole), "");
}

Manner layers_with_room(std::uint32_t layers, int band_lines) {
  return {.content = Manner::Content::layers, .band_lines = band_lines, .layers = layers};
}

TEST(FullLayers, TheStatusNamesTheSizeThatIsEnough) {
  int starved = 0;
  for (const char* name : {"mixed_soup", "penetrating", "soup_medium", "depth_layers"})
    for (int i = 0; i < test::rounds(24); ++i) {
      const int round = i + 12'000'000, band_lines = 1 + i % 20;
      Random random(seed_of(generator(name), round));
      const Scene scene = generator(name).make(random);
      const Drawing want = reference(scene, {.content = Manner::Content::layers});
      for (const std::uint32_t room : {0U, 1U, 8U}) {
        const Drawing got = draw(depth_sort(), scene, layers_with_room(room, band_lines));
        if (got.status.ok()) {
          ASSERT_EQ(difference(want, got), "");
          continue;
        }
        ++starved;
        ASSERT_EQ(got.status.fault, Fault::pool_full);
        ASSERT_EQ(got.status.pool, Pool::layers);
        const std::uint32_t wanted = got.status.wanted;
        ASSERT_GT(wanted, room);
        const Drawing whole = draw(depth_sort(), scene, layers_with_room(wanted, band_lines));
        ASSERT_TRUE(whole.status.ok()) << wanted << " were named, then " << whole.status.wanted;
        ASSERT_EQ(difference(want, whole), "") << name << ", seed " << seed_of(generator(name), round);
        ASSERT_EQ(draw(depth_sort(), scene, layers_with_room(wanted - 1, band_lines)).status, got.status);
      }
    }
  EXPECT_GT(starved, 0);
}

// Their sort begins with the farthest, so it is the nearest that find no room. The others are laid as if those were not
// there.
TEST(FullLayers, TheNearestAreLeftOut) {
  int starved = 0;
  for (int round = 0; round < test::rounds(60); ++round) {
    const auto make = [&] {
      Random random(static_cast<std::uint32_t>(round + 1));
      return level_polygons(random);
    };
    Scene scene = make();
    const auto room = static_cast<std::uint32_t>(round % 9);
    const Drawing got = draw(depth_sort(), scene, layers_with_room(room, 0));
    if (!got.status.ok()) ++starved;
    std::vector<std::size_t> layers;
    for (std::size_t i = 0; i < scene.triangles.size(); ++i)
      if (is_see_through(material_of(i / batch_length)) && reaches(scene.triangles[i], &Corner::x, 0, scene.width) &&
          reaches(scene.triangles[i], &Corner::y, 0, scene.height))
        layers.push_back(i);
    ASSERT_EQ(got.status.ok(), layers.size() <= room);
    std::sort(layers.begin(), layers.end(),
              [&](std::size_t a, std::size_t b) { return scene.triangles[a][0].z > scene.triangles[b][0].z; });
    for (std::size_t i = room; i < layers.size(); ++i) scene.triangles[layers[i]] = {};
    ASSERT_EQ(difference(reference(scene, {.content = Manner::Content::layers}), got), "") << "round " << round;
  }
  EXPECT_GT(starved, 0);
}

}  // namespace
}  // namespace spanline::contract
