// More polygons than records: the farthest are left out of a row, of equally far ones the latest; what is drawn is
// drawn right, and the status says what would do.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "brute_force.hpp"
#include "generators.hpp"
#include "sizes.hpp"
#include "support/effort.hpp"
#include "verdict.hpp"

namespace spanline::contract {
namespace {

Manner with_room(std::uint32_t active, int band_lines = 0) {
  Manner manner;
  manner.active = active;
  manner.band_lines = band_lines;
  return manner;
}

std::size_t wrong_pixels(const Drawing& want, const Drawing& got) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < want.pixels.size(); ++i)
    if (want.pixels[i] != got.pixels[i]) ++count;
  return count;
}

class FullPool : public ::testing::TestWithParam<std::uint32_t> {
 protected:
  /// Draws random scenes by `span` with this much room, and calls f(scene, picture) where that is not enough.
  template <class F>
  void for_each_starved(int rounds, F f) {
    for (const char* name : {"mixed_soup", "penetrating", "stack", "nested", "quads_on_centres", "soup_tiny"})
      for (int i = 0; i < rounds; ++i) {
        const int round = i + 5'000'000;
        Random random(seed_of(generator(name), round));
        const Scene scene = generator(name).make(random);
        const Drawing got = draw(span_, scene, with_room(GetParam(), 1 + i % 20));
        if (got.status.ok()) {
          ASSERT_EQ(difference(reference(scene), got), "") << name << ", seed " << seed_of(generator(name), round);
          continue;
        }
        ++starved_;
        f(scene, got);
        if (HasFatalFailure()) FAIL() << name << ", seed " << seed_of(generator(name), round);
      }
    EXPECT_GT(starved_, 0) << "there was room enough everywhere: nothing is shown";
  }

  const AlgorithmEntry& span_ = algorithm("span");
  int starved_ = 0;
};

TEST_P(FullPool, TheStatusNamesASizeThatIsEnough) {
  for_each_starved(test::rounds(24), [&](const Scene& scene, const Drawing& got) {
    ASSERT_EQ(got.status.fault, Fault::pool_full);
    ASSERT_EQ(got.status.pool, Pool::awake);
    ASSERT_GT(got.status.wanted, GetParam());
    const Drawing whole = draw(span_, scene, with_room(got.status.wanted));
    ASSERT_TRUE(whole.status.ok()) << got.status.wanted << " were named, then " << whole.status.wanted;
    ASSERT_EQ(difference(reference(scene), whole), "");
  });
}

TEST_P(FullPool, ThePictureIsTheSameEveryTimeAndInBandsOfAnyHeight) {
  for_each_starved(test::rounds(24), [&](const Scene& scene, const Drawing& got) {
    for (const int lines : {0, 1, 7}) {
      const Drawing again = draw(span_, scene, with_room(GetParam(), lines));
      ASSERT_EQ(difference(got, again), "");
      ASSERT_EQ(again.status, got.status);
    }
  });
}

TEST_P(FullPool, EveryPixelIsShadedOnceByAPolygonThatCoversIt) {
  for_each_starved(test::rounds(24), [&](const Scene& scene, const Drawing& got) {
    ASSERT_EQ(got.counters.named("shaded"), scene.pixel_count());
    ASSERT_EQ(garbage_pixels(scene, got), 0U);
  });
}

// The rule of wake_bucket.hpp row by row. Pictures of 12 rows: none is worth a sleep there, so that the records of a
// row hold exactly the polygons that the rule keeps.
TEST_P(FullPool, TheNearestPolygonsOfARowAreKept) {
  for (const char* name : {"mixed_soup", "penetrating", "stack", "quads_on_centres", "coplanar_ties", "nested"})
    for (int i = 0; i < test::rounds(60); ++i) {
      const int round = i + 6'000'000;
      Random random(seed_of(generator(name), round));
      Scene scene = generator(name).make(random);
      scene.height = 12;
      if (i % 2 == 0)
        for (Corners& t : scene.triangles)
          for (Corner& c : t) c.y /= scene.height;  // rather than cut off what lies below
      const Drawing got = draw(span_, scene, with_room(GetParam()));
      ASSERT_EQ(got.counters.named("sleeps"), 0U);
      ASSERT_EQ(difference(brute_force(scene, GetParam()), got), "")
          << name << ", seed " << seed_of(generator(name), round) << '\n'
          << text_of(scene);
      if (!got.status.ok()) ++starved_;
    }
  EXPECT_GT(starved_, 0);
}

TEST_P(FullPool, FewPixelsAreWrong) {
  std::size_t wrong = 0, pixels = 0;
  for_each_starved(test::sample_size(24), [&](const Scene& scene, const Drawing& got) {
    wrong += wrong_pixels(reference(scene), got);
    pixels += scene.pixel_count();
  });
  const double share = 100.0 * static_cast<double>(wrong) / static_cast<double>(std::max<std::size_t>(pixels, 1));
  // A third more than what was measured when this was written.
  const double bound = GetParam() == 64 ? 1.5 : GetParam() == 32 ? 4 : GetParam() == 16 ? 14 : 75;
  EXPECT_LE(share, bound);
  std::printf("room for %u: %d scenes ran full, %.2f %% of their pixels are wrong\n", GetParam(), starved_, share);
}

INSTANTIATE_TEST_SUITE_P(RoomFor, FullPool, ::testing::Values(64, 32, 16, 1),
                         [](const auto& room) { return std::to_string(room.param); });

// Regression: the outcode of the nearest corner, below its depth, decided between equally far polygons.
TEST(FullPoolTies, GoByNumberWhereverTheCornersLie) {
  const auto nearest_at = [](int x, int y) {
    return Corners{Corner{x, y, 5000}, Corner{700, 0, 6000}, Corner{0, 600, 6000}};
  };
  for (const Corner& beyond : {Corner{-160, 0, 0}, Corner{0, -160, 0}, Corner{0, 0, 0}, Corner{1600, 0, 0}}) {
    Scene scene;
    scene.triangles = {nearest_at(beyond.x, beyond.y), nearest_at(0, 0)};
    const Drawing got = draw(algorithm("span"), scene, with_room(1));
    EXPECT_EQ(difference(brute_force(scene, 1), got), "") << beyond.x << ", " << beyond.y;
  }
}

TEST(FullPoolWithoutRoom, ShowsTheBackgroundAndSaysWhatIsWanted) {
  Random random(1);
  const Scene scene = mixed_soup(random);
  const Drawing got = draw(algorithm("span"), scene, with_room(0));
  EXPECT_EQ(got.status.pool, Pool::awake);
  EXPECT_EQ(got.pixels, std::vector<std::uint32_t>(scene.pixel_count(), 0));
  EXPECT_TRUE(draw(algorithm("span"), scene, with_room(got.status.wanted)).status.ok());
}

}  // namespace
}  // namespace spanline::contract
