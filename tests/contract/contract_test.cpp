// One suite for every visibility algorithm: what is listed is tested, by the class that it states there.
#include <gtest/gtest.h>

#include <algorithm>

#include "draw_surfaces.hpp"
#include "generators.hpp"
#include "support/effort.hpp"
#include "verdict.hpp"

namespace spanline::contract {
namespace {

constexpr int band_heights[] = {16, 1, 0, 7};  // 0: the whole picture

/// Every way of drawing comes up in turn.
Manner manner_of(int round, Manner::Content content) {
  Manner manner;
  manner.content = content;
  manner.band_lines = band_heights[round % 4];
  if (round / 4 % 2 == 1) manner.sense = DepthSense::larger_is_nearer;
  return manner;
}

class Contract : public ::testing::TestWithParam<Generator> {};

TEST_P(Contract, EveryAlgorithmDrawsIdsAndDepthsByItsClass) {
  const Generator& generator = GetParam();
  for (int round = 0; round < test::rounds(generator.rounds); ++round) {
    Random random(seed_of(generator, round));
    const Scene scene = generator.make(random);
    ASSERT_EQ(fault_in(scene, manner_of(round, Manner::Content::ids)), "")
        << generator.name << ", seed " << seed_of(generator, round);
  }
}

TEST_P(Contract, EveryAlgorithmDrawsColoursByItsClass) {
  const Generator& generator = GetParam();
  const int rounds = test::rounds(generator.rounds / 4);
  for (int i = 0; i < rounds; ++i) {
    const int round = i + 1'000'000;  // other scenes than above
    Random random(seed_of(generator, round));
    const Scene scene = generator.make(random);
    ASSERT_EQ(fault_in(scene, manner_of(i, Manner::Content::colours)), "")
        << generator.name << ", seed " << seed_of(generator, round);
  }
}

TEST_P(Contract, EveryAlgorithmDrawsLayersByItsClass) {
  const Generator& generator = GetParam();
  const int rounds = test::rounds(std::max(generator.rounds / 4, 1));
  for (int i = 0; i < rounds; ++i) {
    const int round = i + 2'000'000;
    Random random(seed_of(generator, round));
    const Scene scene = generator.make(random);
    ASSERT_EQ(fault_in(scene, manner_of(i, Manner::Content::layers)), "")
        << generator.name << ", seed " << seed_of(generator, round);
  }
}

TEST(ContractOfSurfaces, EveryAlgorithmDrawsThemByItsClass) {
  const Generator& generator = surface_generator();
  for (int round = 0; round < test::rounds(generator.rounds); ++round) {
    Random random(seed_of(generator, round));
    const Scene scene = generator.make(random);
    Manner manner;
    manner.content = Manner::Content::colours;
    manner.band_lines = band_heights[round % 4];
    ASSERT_EQ(fault_in(scene, manner, surface_drawer), "") << "seed " << seed_of(generator, round);
  }
}

std::string name_of(const ::testing::TestParamInfo<Generator>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(OnScreen, Contract, ::testing::ValuesIn(screen_generators()), name_of);
INSTANTIATE_TEST_SUITE_P(OfMeshes, Contract, ::testing::ValuesIn(mesh_generators()), name_of);

TEST(ContractList, EveryAlgorithmIsOfferedWhatItTakes) {
  Scene on_screen;
  on_screen.triangles.emplace_back();
  ASSERT_GE(algorithms_for(on_screen).size(), 3U);
  for (const AlgorithmEntry& entry : algorithms_for(on_screen))
    EXPECT_TRUE(entry.takes_screen_polygons()) << entry.name;
  EXPECT_EQ(algorithms_for(Scene{}).size(), algorithm_registry.size());
}

}  // namespace
}  // namespace spanline::contract
