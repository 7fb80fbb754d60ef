// What order-bound algorithms are held to says something in every scene: a painter's picture passes, and pictures with
// anything wrong that an order decides do not.
#include "ordered_pixels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "generators.hpp"
#include "support/effort.hpp"
#include "support/exact_triangle.hpp"
#include "verdict.hpp"

namespace spanline::contract {
namespace {

/// Ids, laid over one another in this order.
Drawing painted(const Scene& scene, const std::vector<std::size_t>& order) {
  Drawing drawing;
  drawing.width = scene.width;
  drawing.height = scene.height;
  drawing.pixels.assign(scene.pixel_count(), 0);
  for (const std::size_t i : order)
    test::ExactTriangle(scene.triangles[i]).for_each_pixel(scene.width, scene.height, [&](int x, int y) {
      drawing.pixels[drawing.at(x, y)] = static_cast<std::uint32_t>(i + 1);
    });
  return drawing;
}

std::vector<std::size_t> by_submission(const Scene& scene) {
  std::vector<std::size_t> order(scene.triangles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  return order;
}

/// Painter's algorithm: from the farthest to the nearest corner.
std::vector<std::size_t> by_depth(const Scene& scene) {
  std::vector<std::size_t> order = by_submission(scene);
  const auto nearest = [&](std::size_t i) {
    const Corners& t = scene.triangles[i];
    return std::min({t[0].z, t[1].z, t[2].z});
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return nearest(a) > nearest(b); });
  return order;
}

std::string fault_of_painted(const Scene& scene, const Drawing& got) {
  const Drawing want = reference(scene);
  return fault_of(Exactness::order_bound, want, got, want, scene);
}

/// Calls f(scene) for a few scenes of a kind.
template <class F>
void for_each_scene(const Generator& generator, F f) {
  for (int i = 0; i < test::sample_size(4); ++i) {
    const int round = i + 9'000'000;
    Random random(seed_of(generator, round));
    SCOPED_TRACE(generator.name + ", seed " + std::to_string(seed_of(generator, round)));
    f(generator.make(random));
  }
}

TEST(OrderBound, APaintersPicturePassesInEveryKindOfScene) {
  for (const Generator& generator : screen_generators())
    for_each_scene(generator, [](const Scene& scene) {
      EXPECT_EQ(fault_of_painted(scene, painted(scene, by_depth(scene))), "") << text_of(scene);
    });
}

TEST(OrderBound, ALostPolygonIsFoundWhereAnOrderDecides) {
  std::size_t kinds = 0;
  for (const Generator& generator : screen_generators()) {
    bool decided = false;
    for_each_scene(generator, [&](const Scene& scene) {
      const Drawing want = reference(scene);
      const std::vector<bool> ordered = ordered_pixels(scene);
      std::uint32_t lost = 0;
      for (std::size_t i = 0; i < ordered.size() && lost == 0; ++i) lost = ordered[i] ? want.pixels[i] : 0;
      if (lost == 0) return;
      decided = true;
      std::vector<std::size_t> order = by_depth(scene);
      std::erase(order, std::size_t{lost} - 1);
      EXPECT_NE(fault_of_painted(scene, painted(scene, order)), "") << text_of(scene);
    });
    kinds += decided ? 1U : 0U;
  }
  EXPECT_GE(10 * kinds, 8 * screen_generators().size()) << "kinds of scenes with such pixels";
  std::printf("%zu of %zu kinds of scenes have pixels that an order decides\n", kinds, screen_generators().size());
}

TEST(OrderBound, TheOrderOfSubmissionIsFoundInManyKindsOfScenes) {
  std::size_t kinds = 0;
  for (const Generator& generator : screen_generators()) {
    bool found = false;
    for_each_scene(generator, [&](const Scene& scene) {
      found = found || !fault_of_painted(scene, painted(scene, by_submission(scene))).empty();
    });
    kinds += found ? 1U : 0U;
  }
  EXPECT_GE(2 * kinds, screen_generators().size());
  std::printf("%zu of %zu kinds\n", kinds, screen_generators().size());
}

TEST(OrderBound, BackgroundIsHeldInScenesOfInstances) {
  for (const Generator& generator : mesh_generators()) {
    Random random(seed_of(generator, 0));
    const Scene scene = generator.make(random);
    const Drawing want = reference(scene);
    EXPECT_EQ(fault_of(Exactness::order_bound, want, want, want, scene), "");
    for (const bool drawn : {false, true}) {
      const auto at = std::find_if(want.pixels.begin(), want.pixels.end(), [&](auto id) { return (id != 0) == drawn; });
      if (at == want.pixels.end()) continue;
      Drawing got = want;
      got.pixels[static_cast<std::size_t>(at - want.pixels.begin())] = drawn ? 0 : 1;
      EXPECT_NE(fault_of(Exactness::order_bound, want, got, want, scene), "") << generator.name;
    }
  }
}

TEST(OrderedPixels, AreThoseWhereNoTwoPolygonsOverlapInDepth) {
  const auto at = [](int x, std::int32_t low, std::int32_t high) {
    return Corners{Corner{x, 0, low}, Corner{x + 320, 0, high}, Corner{x, 320, high}};
  };
  Scene scene(64, 32);
  const std::size_t inside = 2 * 64 + 2;  // near the upper left corner of those at 0
  scene.triangles = {at(0, 500, 600), at(0, 100, 200), at(0, 300, 400), at(320, 150, 550)};
  EXPECT_TRUE(ordered_pixels(scene)[inside]) << "the fourth lies elsewhere";
  scene.triangles.push_back(at(0, 395, 450));
  EXPECT_FALSE(ordered_pixels(scene)[inside]);
  EXPECT_TRUE(ordered_pixels(scene)[inside + 30]);
}

}  // namespace
}  // namespace spanline::contract
