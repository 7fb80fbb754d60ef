// Stipples: the share of pixels that is there, and what is seen through two layers.
#include "spanline/shade/layer/stipple.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "spanline/frame/ready_made_traits.hpp"
#include "support/ready_made_studios.hpp"

namespace spanline::test {
namespace {

constexpr auto patterns = static_cast<std::uint32_t>(stipple::ordered_patterns.size());

/// Pixels of an 8 × 8 square.
template <class Mask>
int count_8x8(Mask mask) {
  int count = 0;
  for (std::uint32_t y = 0; y < 8; ++y) count += std::popcount(mask(y) & 0xffu);
  return count;
}

TEST(Stipple, EveryEightByEightPixelsHoldTheLevelsShareExactly) {
  for (std::uint32_t surface = 0; surface < patterns; ++surface)
    for (std::uint32_t level = 0; level <= 64; ++level)
      EXPECT_EQ(count_8x8([&](std::uint32_t y) { return stipple::ordered_mask(surface, level, y); }),
                static_cast<int>(level));
}

TEST(Stipple, AnyWindowsShareIsWithinA64thOfTheOpacity) {
  // Squares of 128 pixels at every offset, of which whole patterns are the least part.
  for (std::uint32_t opacity = 0; opacity <= 255; opacity += 3) {
    const std::uint32_t level = stipple::level_of(opacity);
    for (std::uint32_t surface = 0; surface < patterns; ++surface) {
      std::uint32_t there = 0;
      for (std::uint32_t y = 3; y < 3 + 121; ++y)
        for (std::uint32_t x = 5; x < 5 + 123; ++x) there += stipple::ordered_mask(surface, level, y) >> (x & 31) & 1;
      EXPECT_NEAR(there / (121.0 * 123.0), opacity / 255.0, 1.0 / 64) << "pattern " << surface << " at " << opacity;
    }
  }
}

TEST(Stipple, HigherLevelsKeepThePixelsOfLowerOnes) {
  for (std::uint32_t surface = 0; surface < patterns; ++surface)
    for (std::uint32_t level = 0; level < 64; ++level)
      for (std::uint32_t y = 0; y < 8; ++y) {
        const std::uint32_t low = stipple::ordered_mask(surface, level, y);
        ASSERT_EQ(low & stipple::ordered_mask(surface, level + 1, y), low);
      }
}

TEST(Stipple, ThresholdsOfSinglePixelsAreThoseOfTheMasks) {
  for (std::uint32_t surface = 0; surface < 9; ++surface)
    for (std::uint32_t y = 0; y < 11; ++y)
      for (std::uint32_t x = 64; x < 96; ++x) {
        const std::uint32_t ordered = stipple::ordered_threshold(surface, x, y),
                            random = stipple::random_threshold(surface, x, y, surface + 5);
        for (std::uint32_t level = 0; level <= 64; ++level) {
          ASSERT_EQ(stipple::ordered_mask(surface, level, y) >> (x & 31) & 1, ordered < level ? 1u : 0u);
          ASSERT_EQ(stipple::random_mask(surface, level, 64, y, surface + 5) >> (x & 31) & 1, random < level ? 1u : 0u);
        }
      }
}

TEST(Stipple, WhatLiesBehindTwoLayersIsSeenInTheirProductsShare) {
  double worst = 0;
  for (std::uint32_t first = 0; first < patterns; ++first)
    for (std::uint32_t second = 0; second < first; ++second)
      for (std::uint32_t a = 0; a <= 64; ++a)
        for (std::uint32_t b = 0; b <= 64; ++b) {
          const int through = count_8x8([&](std::uint32_t y) {
            return ~(stipple::ordered_mask(first, a, y) | stipple::ordered_mask(second, b, y));
          });
          worst = std::max(worst, std::abs(through / 64.0 - (1 - a / 64.0) * (1 - b / 64.0)));
        }
  EXPECT_LE(worst, 0.05);
}

TEST(Stipple, OneLayerOverItselfHidesWhatLiesBehindAsOneLayerWould) {
  const int through = count_8x8(
      [](std::uint32_t y) { return ~(stipple::ordered_mask(3, 32, y) | stipple::ordered_mask(3 + patterns, 32, y)); });
  EXPECT_EQ(through, 32);  // where patterns come round again
}

TEST(Stipple, OpacitiesOfEightBitsAreRoundedToTheNearestLevel) {
  for (std::uint32_t opacity = 0; opacity <= 255; ++opacity)
    EXPECT_EQ(stipple::level_of(opacity), static_cast<std::uint32_t>(std::lround(opacity * 64 / 255.0)));
}

/// 64 × 32 pixels under one layer that covers all: where it is there.
std::vector<std::uint16_t> layer_by_seed(Transparency transparency, std::uint8_t seed) {
  using Shaders = ShaderList<FlatShader<Rgb565>, SeeThroughShader<Rgb565, FlatShader<Rgb565>>>;
  Studio<RendererTraits<Rgb565, Shaders>> studio(screen_capacity(64, 32, 1));
  const Corners over_all{Corner{-160, -160, 4000}, Corner{9000, -160, 4000}, Corner{-160, 9000, 4000}};
  const auto vertices = vertices_of(std::span(&over_all, 1), 16, 64, 32);
  const std::uint16_t white = 0xffff;
  FrameSettings settings;
  settings.cull = Cull::none;
  settings.stipple_seed = seed;
  Material material;
  material.opacity = 128;
  material.transparency = transparency;
  studio.begin(settings);
  studio.add_screen(vertices, {&white, 1}, material);
  auto picture = studio.draw();
  EXPECT_TRUE(studio.status().ok());
  return std::move(picture.pixels);
}

TEST(Stipple, EverySeedOfAFrameHasAStochasticPatternOfItsOwn) {
  std::set<std::vector<std::uint16_t>> patterns_seen;
  for (std::uint8_t seed = 0; seed < 128; ++seed) patterns_seen.insert(layer_by_seed(Transparency::stochastic, seed));
  EXPECT_EQ(patterns_seen.size(), 128U);
  EXPECT_EQ(layer_by_seed(Transparency::stochastic, 9), layer_by_seed(Transparency::stochastic, 9));
}

TEST(Stipple, TheSeedOfAFrameChangesNoScreenDoor) {
  EXPECT_EQ(layer_by_seed(Transparency::screen_door, 0), layer_by_seed(Transparency::screen_door, 77));
}

TEST(Stipple, RandomMasksHoldTheLevelsShare) {
  for (std::uint32_t level = 0; level <= 64; ++level) {
    int there = 0;
    for (std::uint32_t y = 0; y < 256; ++y)
      for (std::uint32_t x = 0; x < 1024; x += 32) there += std::popcount(stipple::random_mask(5, level, x, y, 1));
    const double share = level / 64.0, deviation = std::sqrt(share * (1 - share) / (256.0 * 1024));
    EXPECT_NEAR(there / (256.0 * 1024), share, 5 * deviation) << "level " << level;
  }
}

TEST(Stipple, RandomMasksOfTwoSurfacesAreIndependent) {
  constexpr double pixels = 256.0 * 1024;
  for (std::uint32_t a = 4; a < 64; a += 12)
    for (std::uint32_t b = 4; b < 64; b += 12)
      for (std::uint32_t surface = 1; surface < 4; ++surface) {
        int through = 0;
        for (std::uint32_t y = 0; y < 256; ++y)
          for (std::uint32_t x = 0; x < 1024; x += 32)
            through +=
                std::popcount(~(stipple::random_mask(0, a, x, y, 9) | stipple::random_mask(surface, b, x, y, 9)));
        const double share = (1 - a / 64.0) * (1 - b / 64.0), deviation = std::sqrt(share * (1 - share) / pixels);
        EXPECT_NEAR(through / pixels, share, 5 * deviation) << "levels " << a << " and " << b;
      }
}

TEST(Stipple, RandomMasksRepeatBySeedAndDifferBetweenSeeds) {
  std::set<std::uint32_t> words;
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    const std::uint32_t mask = stipple::random_mask(2, 32, 64, 11, seed);
    EXPECT_EQ(mask, stipple::random_mask(2, 32, 64, 11, seed));
    words.insert(mask);
  }
  EXPECT_EQ(words.size(), 100U);
}

}  // namespace
}  // namespace spanline::test
