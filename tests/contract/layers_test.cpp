// Sorted blending against a sort per pixel in double: random soups of see-through polygons, penetrating ones included.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "generators.hpp"
#include "layers.hpp"
#include "spanline/shade/layer/stipple.hpp"
#include "support/effort.hpp"
#include "support/exact_triangle.hpp"
#include "verdict.hpp"

namespace spanline::contract {
namespace {

using Channels = std::array<double, 3>;
constexpr std::array<unsigned, 3> full{31, 63, 31};

std::array<unsigned, 3> split(std::uint32_t rgb565) { return {rgb565 >> 11, (rgb565 >> 5) & 63, rgb565 & 31}; }

/// A polygon's fragment at a pixel.
struct Fragment {
  double depth;
  std::size_t triangle;
};

/// What a pixel must be: once with every layer's result rounded, as RGB565 stores it, and once not.
struct Expected {
  std::array<unsigned, 3> rounded{};
  Channels exact{};
  int layers = 0;
};

void lay(Expected& pixel, std::uint32_t rgb565, const Material& material) {
  const unsigned alpha = (material.opacity * 64u + 255) / 510;
  const auto colour = split(rgb565);
  ++pixel.layers;
  for (std::size_t c = 0; c < 3; ++c) {
    if (material.transparency == Transparency::add) {
      pixel.rounded[c] = std::min(full[c], pixel.rounded[c] + (colour[c] * alpha + 16) / 32);
      pixel.exact[c] = std::min<double>(full[c], pixel.exact[c] + colour[c] * alpha / 32.0);
    } else {
      pixel.rounded[c] = (colour[c] * alpha + pixel.rounded[c] * (32 - alpha) + 16) / 32;
      pixel.exact[c] = (colour[c] * alpha + pixel.exact[c] * (32 - alpha)) / 32.0;
    }
  }
}

/// Whether the pixel has a layer that mixes, one that is opaque, or none.
enum class Presence : std::uint8_t { none, opaque, mixes };

/// `batch` numbers materials and, since each batch is a group, patterns.
Presence presence(const Corners& t, std::size_t batch, int x, int y) {
  const Material material = material_of(batch);
  const auto level = static_cast<std::uint32_t>(std::lround(material.opacity * 64 / 255.0));
  const bool stippled =
      material.transparency == Transparency::screen_door || material.transparency == Transparency::stochastic;
  if (!stippled) {
    const bool opaque = material.transparency == Transparency::blend && material.opacity >= 252;
    return opaque ? Presence::opaque : Presence::mixes;
  }
  if (level >= 64) return Presence::opaque;
  const std::int64_t area = static_cast<std::int64_t>(t[1].x - t[0].x) * (t[2].y - t[0].y) -
                            static_cast<std::int64_t>(t[1].y - t[0].y) * (t[2].x - t[0].x);
  const std::uint32_t back = area > 0 ? 1 : 0;
  const auto number = static_cast<std::uint32_t>(batch), u = static_cast<std::uint32_t>(x),
             v = static_cast<std::uint32_t>(y);
  const std::uint32_t mask =
      material.transparency == Transparency::screen_door
          ? stipple::ordered_mask((number & 127) + 4 * back, level, v)
          : stipple::random_mask(2 * number * static_cast<std::uint32_t>(batch_length) + back, level, u & ~31u, v, 0);
  return (mask >> (u & 31) & 1) != 0 ? Presence::opaque : Presence::none;
}

/// The pixel by a sort of its fragments; false where two depths are so near that rounding may decide, or are equal.
bool expected(const Scene& scene, const std::vector<test::ExactTriangle>& exact, int x, int y, Expected& pixel) {
  std::vector<Fragment> fragments;
  for (std::size_t i = 0; i < exact.size(); ++i)
    if (exact[i].covers(x, y)) fragments.push_back({exact[i].depth(x, y), i});
  std::sort(fragments.begin(), fragments.end(), [](const Fragment& a, const Fragment& b) { return a.depth > b.depth; });
  constexpr double rounding = 4.1;  // two units a plane
  for (std::size_t i = 1; i < fragments.size(); ++i)
    if (fragments[i - 1].depth - fragments[i].depth < rounding) return false;
  pixel = {};
  for (const Fragment& f : fragments) {
    const auto colour = static_cast<std::uint16_t>(f.triangle * 40503u + 1u);
    const std::size_t batch = f.triangle / batch_length;
    const Presence here = presence(scene.triangles[f.triangle], batch, x, y);
    if (here == Presence::mixes) {
      lay(pixel, colour, material_of(batch));
    } else if (here == Presence::opaque) {
      pixel = {};
      pixel.rounded = split(colour);
      for (std::size_t c = 0; c < 3; ++c) pixel.exact[c] = pixel.rounded[c];
    }
  }
  return true;
}

/// Pixels that could be told.
std::size_t check(const Scene& scene, const Drawing& drawing) {
  const std::vector<test::ExactTriangle> exact(scene.triangles.begin(), scene.triangles.end());
  std::size_t told = 0;
  for (int y = 0; y < scene.height; ++y)
    for (int x = 0; x < scene.width; ++x) {
      Expected want;
      if (!expected(scene, exact, x, y, want)) continue;
      ++told;
      const auto got = split(drawing.pixels[drawing.at(x, y)]);
      EXPECT_EQ(got, want.rounded) << "column " << x << ", row " << y << '\n' << text_of(scene);
      if (got != want.rounded) return told;
      for (std::size_t c = 0; c < 3; ++c) EXPECT_LE(std::abs(got[c] - want.exact[c]), 0.5 * want.layers + 1e-9);
    }
  return told;
}

TEST(Layers, EveryAlgorithmBlendsAsASortPerPixelWould) {
  std::size_t told = 0, pixels = 0;
  for (const char* name : {"penetrating", "mixed_soup", "soup_large", "soup_medium", "soup_screen"}) {
    for (int round = 0; round < test::rounds(6); ++round) {
      Random random(seed_of(generator(name), 3'000'000 + round));
      const Scene scene = generator(name).make(random);
      if (scene.triangles.size() * scene.pixel_count() > 3'000'000) continue;  // for the sake of time
      for (const AlgorithmEntry& entry : algorithms_for(scene)) {
        if (entry.exactness != Exactness::exact) continue;
        const Drawing drawing = draw(entry, scene, {.content = Manner::Content::layers, .band_lines = 5 + round});
        ASSERT_TRUE(drawing.status.ok()) << entry.name;
        told += check(scene, drawing);
        pixels += scene.pixel_count();
        if (HasFailure()) FAIL() << entry.name << ", " << name << ", round " << round;
      }
    }
  }
  EXPECT_GT(told * 10, pixels * 5);  // depths are seldom that near
}

/// Layers of white, each before the next by far, over a whole picture.
Scene stacked(int layers) {
  Scene scene(32, 16);
  for (int i = 0; i < layers * static_cast<int>(batch_length); ++i)
    scene.triangles.push_back({Corner{-100, -100, 1'000'000 + 50'000 * i}, Corner{2000, -100, 1'000'000 + 50'000 * i},
                               Corner{-100, 2000, 1'000'000 + 50'000 * i}});
  return scene;
}

TEST(Layers, APoolThatRunsFullIsToldOfAndTheSizeThatIsNamedIsEnough) {
  const Scene scene = stacked(5);
  for (const AlgorithmEntry& entry : algorithms_for(scene)) {
    const Manner plenty{.content = Manner::Content::layers, .band_lines = 3, .layers = 100'000};
    const Drawing want = draw(entry, scene, plenty);
    ASSERT_TRUE(want.status.ok()) << entry.name;
    ASSERT_EQ(difference(reference(scene, plenty), want), "") << entry.name;
    for (const std::uint32_t room : {0U, 1U, 2U, 7U}) {
      Manner starved = plenty;
      starved.layers = room;
      const Drawing got = draw(entry, scene, starved);
      if (entry.exactness == Exactness::order_bound) {
        // Layers that come in their order are laid at once, without a pool.
        ASSERT_TRUE(got.status.ok()) << entry.name;
        ASSERT_EQ(difference(want, got), "") << entry.name;
        continue;
      }
      ASSERT_EQ(got.status.fault, Fault::pool_full) << entry.name;
      ASSERT_TRUE(is_of_layers(got.status.pool)) << to_string(got.status.pool);
      // Layers that do not interleave are laid in passes, whatever their number.
      if (std::string_view(entry.name) == "span" && room > 0) {
        EXPECT_EQ(difference(want, got), "") << room;
      }
      starved.layers = got.status.wanted;
      const Drawing fed = draw(entry, scene, starved);
      ASSERT_TRUE(fed.status.ok()) << entry.name << ", " << got.status.wanted;
      ASSERT_EQ(difference(want, fed), "");
      starved.layers = got.status.wanted - 1;
      EXPECT_FALSE(draw(entry, scene, starved).status.ok()) << entry.name << ": more was named than it takes";
    }
  }
}

TEST(Layers, InSpanAPoolThatRunsFullDrawsTheSameInBandsOfAnyHeightAndOnTwoCores) {
  for (const char* name : {"penetrating", "mixed_soup", "soup_medium"}) {
    for (int round = 0; round < test::rounds(6); ++round) {
      Random random(seed_of(generator(name), 4'000'000 + round));
      const Scene scene = generator(name).make(random);
      Manner manner{.content = Manner::Content::layers, .layers = static_cast<std::uint32_t>(1 + round % 3)};
      const Drawing want = draw(algorithm("span"), scene, manner);
      for (const int lines : {1, 5}) {
        manner.band_lines = lines;
        ASSERT_EQ(difference(want, draw(algorithm("span"), scene, manner)), "") << name << ", bands of " << lines;
      }
      manner.two_cores = true;
      ASSERT_EQ(difference(want, draw(algorithm("span"), scene, manner)), "") << name << ", two cores";
    }
  }
}

/// Submitted from the farthest to the nearest, so that each fragment that is laid at once is laid right.
TEST(Layers, AFullPoolLaysTheFarthestAtOnceWhichIsRightForPolygonsThatComeBackToFront) {
  Scene scene = stacked(1);
  ASSERT_EQ(scene.triangles.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i)
    ASSERT_EQ(presence(scene.triangles[i], 0, 0, 0), Presence::mixes) << "all blend, and their order shows";
  std::reverse(scene.triangles.begin(), scene.triangles.end());
  Manner manner{.content = Manner::Content::layers, .layers = 100'000};
  const Drawing want = draw(algorithm("zbuffer"), scene, manner);
  for (const std::uint32_t room : {0U, 1U, 100U, 800U, 1500U}) {
    manner.layers = room;
    const Drawing got = draw(algorithm("zbuffer"), scene, manner);
    EXPECT_FALSE(got.status.ok());
    EXPECT_EQ(difference(want, got), "") << "room for " << room;
  }
  // Submitted the other way round, full pools lay the wrong ones at once: the order does show.
  std::reverse(scene.triangles.begin(), scene.triangles.end());
  manner.layers = 1;
  EXPECT_NE(difference(want, draw(algorithm("zbuffer"), scene, manner)), "");
}

}  // namespace
}  // namespace spanline::contract
