// Two drawers share a frame, each every second band, in threads of their own: the picture stays the same.
#include <gtest/gtest.h>

#include "generators.hpp"
#include "support/effort.hpp"
#include "verdict.hpp"

namespace spanline::contract {
namespace {

class TwoCores : public ::testing::TestWithParam<Generator> {};

TEST_P(TwoCores, DrawWhatOneDraws) {
  constexpr int band_heights[] = {16, 1, 7};
  const Generator& generator = GetParam();
  const int rounds = test::rounds(generator.rounds / 3);
  for (int i = 0; i < rounds; ++i) {
    const int round = i + 2'000'000;  // other scenes than the contract's
    Random random(seed_of(generator, round));
    const Scene scene = generator.make(random);
    Manner manner;
    using enum Manner::Content;
    constexpr Manner::Content contents[] = {ids, colours, layers};
    manner.content = contents[i % 3];
    manner.band_lines = band_heights[i / 3 % 3];
    manner.two_cores = true;
    ASSERT_EQ(fault_in(scene, manner), "") << generator.name << ", seed " << seed_of(generator, round);
  }
}

std::string name_of(const ::testing::TestParamInfo<Generator>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(OnScreen, TwoCores, ::testing::ValuesIn(screen_generators()), name_of);
INSTANTIATE_TEST_SUITE_P(OfMeshes, TwoCores, ::testing::ValuesIn(mesh_generators()), name_of);

}  // namespace
}  // namespace spanline::contract
