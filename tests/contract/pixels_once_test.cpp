// Spanning algorithms write every pixel of the picture once, the background's too: seen from outside, by counting what
// is written, not by the algorithm's own counter.
#include <gtest/gtest.h>

#include "generators.hpp"
#include "recording_shaders.hpp"
#include "support/effort.hpp"

namespace spanline::contract {
namespace {

class PixelsOnce : public ::testing::TestWithParam<Generator> {};

TEST_P(PixelsOnce, NoneIsWrittenTwiceAndNoneIsMissed) {
  const Generator& generator = GetParam();
  for (int i = 0; i < test::rounds(generator.rounds / 4); ++i) {
    const int round = i + 4'000'000;
    Random random(seed_of(generator, round));
    const Scene scene = generator.make(random);
    constexpr std::uint32_t rooms[] = {4096, 32, 7, 1, 0};
    const Written written = count_writes(scene, 1 + i % 17, rooms[i % 5]);
    ASSERT_EQ(written.times.size(), scene.pixel_count());
    for (std::size_t pixel = 0; pixel < written.times.size(); ++pixel)
      ASSERT_EQ(written.times[pixel], 1U) << "pixel " << pixel << ", room for " << rooms[i % 5] << " polygons, seed "
                                          << seed_of(generator, round) << '\n'
                                          << text_of(scene);
    ASSERT_EQ(written.outside, 0U);
  }
}

std::string name_of(const ::testing::TestParamInfo<Generator>& info) { return info.param.name; }
INSTANTIATE_TEST_SUITE_P(OnScreen, PixelsOnce, ::testing::ValuesIn(screen_generators()), name_of);

}  // namespace
}  // namespace spanline::contract
