// The benchmark's scenes for algorithms that sort polygons are what they are said to be.
#include "scenes/sorting_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "spanline/frame/ready_made_traits.hpp"
#include "spanline/frame/renderer.hpp"
#include "spanline/model/validate.hpp"

namespace spanline::test {
namespace {

constexpr int width = 320, height = 240;
constexpr std::uint16_t background = 0;

/// The pixels of a frame that `submit(renderer)` starts and fills.
template <class Submit>
std::vector<std::uint16_t> picture(const Capacity& capacity, Submit submit) {
  using Traits = FlatTraits<Rgb565, Depth24<>>;
  std::vector<std::byte> memory(Renderer<Traits>::bytes_needed(capacity));
  Renderer<Traits> renderer(capacity, memory);
  submit(renderer);
  std::vector<std::uint16_t> pixels;
  EXPECT_TRUE(renderer
                  .draw([&](const auto& band) {
                    pixels.assign(band.pixels.begin(), band.pixels.end());
                    return true;
                  })
                  .ok());
  return pixels;
}

struct Soup {
  explicit Soup(std::size_t triangles) : vertices(3 * triangles), colours(triangles) {}
  operator scenes::ScreenSoup() { return {vertices, colours}; }
  std::vector<ScreenVertex> vertices;
  std::vector<std::uint16_t> colours;
};

/// The picture of triangles on screen.
std::vector<std::uint16_t> picture_of(const Soup& soup) {
  const auto triangles = static_cast<std::uint32_t>(soup.colours.size());
  return picture({.band_lines = height, .colour_bands = 1, .polygons = triangles}, [&](auto& renderer) {
    FrameSettings settings;
    settings.cull = Cull::none;
    ASSERT_TRUE(renderer.begin(settings).ok());
    ASSERT_TRUE(renderer.add_screen(soup.vertices, soup.colours).ok());
  });
}

TEST(SortingScenes, TheBallIsAValidMeshOfSharedVerticesAndADiscOnScreen) {
  using namespace scenes::ball;
  EXPECT_TRUE(validate(mesh).ok());
  EXPECT_EQ(mesh.vertex_count(), 29u * 29u);
  EXPECT_EQ(mesh.polygon_count(), 1568u);
  const Capacity capacity{.band_lines = height, .colour_bands = 1, .vertices = 29 * 29, .polygons = 1568};
  const auto pixels = picture(capacity, [](auto& renderer) {
    ASSERT_TRUE(renderer.begin(settings()).ok());
    ASSERT_TRUE(renderer.add(mesh, {}, {}).ok());
    // Nearly all face the eye, and all are in view.
    const PolygonCounts polygons = renderer.statistics().polygons;
    EXPECT_EQ(polygons.outside, 0u);
    EXPECT_LE(polygons.back, 8u);
  });
  const double disc = 3.14159265 * 100 * 100;
  EXPECT_NEAR(static_cast<double>(std::count_if(pixels.begin(), pixels.end(), [](auto p) { return p != background; })),
              disc, 0.01 * disc);
  const auto is_drawn = [&](int x, int y) { return pixels[static_cast<std::size_t>(y * width + x)] != background; };
  for (const int y : {22, 217}) EXPECT_TRUE(is_drawn(160, y)) << y;
  for (const int y : {18, 221}) EXPECT_FALSE(is_drawn(160, y)) << y;
  for (const int x : {64, 255}) EXPECT_TRUE(is_drawn(x, 120)) << x;
  for (const int x : {58, 261}) EXPECT_FALSE(is_drawn(x, 120)) << x;
}

TEST(SortingScenes, TheLandscapeHasNoGapsBelowItsHorizon) {
  Soup soup(scenes::landscape::triangles);
  EXPECT_EQ(soup.colours.size(), 2400u);
  scenes::landscape::make(24, soup);
  std::fill(soup.colours.begin(), soup.colours.end(), std::uint16_t{0xffff});
  const auto pixels = picture_of(soup);
  EXPECT_EQ(std::count(pixels.begin() + 40 * width, pixels.begin() + 220 * width, background), 0);
}

/// Among all pairs of triangles, the share of those of which one is wholly nearer than the other.
double share_apart_in_depth(const Soup& soup) {
  const auto range = [&](std::size_t i) {
    const auto* at = &soup.vertices[3 * i];
    return std::minmax({at[0].depth_word, at[1].depth_word, at[2].depth_word});
  };
  std::size_t apart = 0, pairs = 0;
  for (std::size_t i = 0; i < soup.colours.size(); ++i)
    for (std::size_t j = 0; j < i; ++j, ++pairs) {
      const auto [near_i, far_i] = range(i);
      const auto [near_j, far_j] = range(j);
      apart += far_i < near_j || far_j < near_i;
    }
  return static_cast<double>(apart) / static_cast<double>(pairs);
}

TEST(SortingScenes, PenetratingTrianglesOverlapInDepthWhereTheOthersDoNot) {
  Soup penetrating(100), layered(100);
  scenes::make_penetrating_triangles(128, 100, 24, penetrating);
  scenes::make_right_triangles(128, 100, 24, layered);
  EXPECT_LT(share_apart_in_depth(penetrating), 0.2);
  EXPECT_GT(share_apart_in_depth(layered), 0.9);
}

TEST(SortingScenes, SixteenBitsOfDepthAreTheTopOfTwentyFour) {
  Soup coarse(scenes::landscape::triangles), fine(scenes::landscape::triangles);
  scenes::landscape::make(16, coarse);
  scenes::landscape::make(24, fine);
  for (std::size_t i = 0; i < fine.vertices.size(); ++i)
    ASSERT_EQ(coarse.vertices[i].depth_word, fine.vertices[i].depth_word) << i;
}

TEST(SortingScenes, ShrinkingTrianglesCoverAPixelUpToTwice) {
  for (const auto& [triangles, leg] : {std::pair{100u, 69u}, std::pair{2500u, 11u}, std::pair{60000u, 2u}}) {
    EXPECT_EQ(scenes::even_cover_leg(2, triangles, width, height), leg);
    EXPECT_GE(scenes::even_cover_count(2, leg, width, height), triangles);
    EXPECT_LT(scenes::even_cover_count(2, leg + 1, width, height), triangles);
  }
}

}  // namespace
}  // namespace spanline::test
