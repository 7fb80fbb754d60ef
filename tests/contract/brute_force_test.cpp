// Every algorithm against definitions alone: coverage by edge functions and the nearest plane word of all triangles.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "brute_force.hpp"
#include "generators.hpp"
#include "support/effort.hpp"
#include "support/exact_triangle.hpp"
#include "verdict.hpp"

namespace spanline::contract {
namespace {

class BruteForce : public ::testing::TestWithParam<Generator> {};

TEST_P(BruteForce, AgreesWithEveryAlgorithm) {
  const Generator& generator = GetParam();
  for (int i = 0; i < test::rounds(4 + generator.rounds / 4); ++i) {
    const int round = i + 2'000'000;
    Random random(seed_of(generator, round));
    const Scene scene = generator.make(random);
    const Drawing want = brute_force(scene);
    for (const AlgorithmEntry& entry : algorithms_for(scene)) {
      Manner manner;
      manner.band_lines = 1 + i % 20;
      const Drawing got = draw(entry, scene, manner);
      ASSERT_EQ(fault_of(entry.exactness, want, got, want, scene), "")
          << entry.name << ", seed " << seed_of(generator, round) << '\n'
          << text_of(scene);
    }
  }
}

// 16 bits have planes of their own: what shows must cover the pixel, and be the nearest but for both roundings (design:
// two units of 16 bits).
TEST_P(BruteForce, ShowsANearestTriangleAt16Bits) {
  const Generator& generator = GetParam();
  for (int i = 0; i < test::rounds(4); ++i) {
    const int round = i + 3'000'000;
    Random random(seed_of(generator, round));
    Scene scene = generator.make(random);
    if (scene.width + scene.height > 768) continue;  // promised up to there
    for (Corners& t : scene.triangles)
      for (Corner& c : t) c.z = std::min(c.z >> 8, 65534) << 8;  // what 16 bits can say
    const std::vector<test::ExactTriangle> exact(scene.triangles.begin(), scene.triangles.end());
    const Drawing nearest = brute_force(scene);
    for (const AlgorithmEntry& entry : algorithms_for(scene)) {
      if (entry.exactness != Exactness::exact) continue;
      const Drawing got = draw_16_bits(entry, scene);
      ASSERT_EQ(garbage_pixels(scene, got), 0U) << entry.name;
      for (int y = 0; y < scene.height; ++y)
        for (int x = 0; x < scene.width; ++x) {
          const std::uint32_t want = nearest.pixels[got.at(x, y)], id = got.pixels[got.at(x, y)];
          if (want == id) continue;
          ASSERT_TRUE(want != 0 && id != 0) << entry.name << ": " << x << ", " << y << '\n' << text_of(scene);
          ASSERT_LE((exact[id - 1].depth(x, y) - exact[want - 1].depth(x, y)) / 256, 2.0)
              << entry.name << ": " << x << ", " << y << " of seed " << seed_of(generator, round);
        }
    }
  }
}

std::string name_of(const ::testing::TestParamInfo<Generator>& info) { return info.param.name; }
INSTANTIATE_TEST_SUITE_P(OnScreen, BruteForce, ::testing::ValuesIn(screen_generators()), name_of);

}  // namespace
}  // namespace spanline::contract
