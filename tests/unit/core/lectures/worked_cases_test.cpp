// The z-buffer cases that the source lectures work through (seeds: lectures 000, 001, 002 and 003), against their
// tables.
#include <gtest/gtest.h>
#include <spanline/frame/ready_made_traits.hpp>
#include <spanline/model/cull.hpp>

#include <array>
#include <cmath>
#include <vector>

#include "lectures/fragments.hpp"
#include "lectures/lecture_triangle.hpp"
#include "support/exact_triangle.hpp"

namespace spanline::test {
namespace {

constexpr std::int32_t empty = -1;

using Table = std::vector<std::vector<std::int32_t>>;

/// Depths of a picture in the lecture's units, `empty` where nothing was drawn.
template <class Picture, class Unit>
Table table_of(const Picture& picture, Unit unit) {
  Table table(static_cast<std::size_t>(picture.height));
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      table[static_cast<std::size_t>(y)].push_back(picture.drawn(x, y) ? unit(picture.depth_integer(x, y)) : empty);
  return table;
}

// Lecture 000 (Komura): 4 × 4, larger is nearer, start −1.0; depths −1 … 0 stand for tenths here.
TEST(Lecture000, TheFourByFourRunGivesItsFourTables) {
  using Depth = Depth16<DepthSense::larger_is_nearer>;
  // −0.3 is nearer than −0.5: the vertices' smaller-is-nearer depths are −10·z tenths times 1000.
  const auto square = [](int row, int column, int tenths, std::uint16_t colour) {
    std::vector<Fragment> f;
    for (int y = row; y < row + 2; ++y)
      for (int x = column; x < column + 2; ++x) f.push_back({x, y, tenths * 1000, colour});
    return f;
  };
  const auto blue = square(2, 0, 5, 0x001f), yellow = square(1, 1, 3, 0xffe0), red = square(0, 2, 8, 0xf800);
  const auto tenths = [](std::int64_t depth) { return static_cast<std::int32_t>(depth / 1000); };
  std::vector<Fragment> fragments;
  EXPECT_EQ(table_of(draw_fragments<Depth>(4, 4, fragments), tenths), Table(4, std::vector<std::int32_t>(4, empty)));
  fragments.insert(fragments.end(), blue.begin(), blue.end());
  EXPECT_EQ(table_of(draw_fragments<Depth>(4, 4, fragments), tenths),
            (Table{{-1, -1, -1, -1}, {-1, -1, -1, -1}, {5, 5, -1, -1}, {5, 5, -1, -1}}));
  fragments.insert(fragments.end(), yellow.begin(), yellow.end());
  EXPECT_EQ(table_of(draw_fragments<Depth>(4, 4, fragments), tenths),
            (Table{{-1, -1, -1, -1}, {-1, 3, 3, -1}, {5, 3, 3, -1}, {5, 5, -1, -1}}));
  fragments.insert(fragments.end(), red.begin(), red.end());
  const auto last = draw_fragments<Depth>(4, 4, fragments);
  EXPECT_EQ(table_of(last, tenths), (Table{{-1, -1, 8, 8}, {-1, 3, 3, 8}, {5, 3, 3, -1}, {5, 5, -1, -1}}));
  EXPECT_EQ(last.pixels[last.at(2, 1)], 0xffe0) << "red is hidden by yellow";
}

template <class Depth>
Table draw_triangles(const std::vector<LectureTriangle>& triangles, int unit, int turn_over = 0) {
  std::vector<Corners> corners;
  for (const LectureTriangle& t : triangles) {
    corners.push_back(t.grown(8, unit));
    if (turn_over != 0)
      for (Corner& c : corners.back()) c.z = turn_over * unit - c.z;
  }
  Studio<FlatTraits<Rgb565, Depth>> studio(screen_capacity(8, 8, corners.size()));
  const auto picture = studio.draw_screen(corners);
  return table_of(picture, [&](std::int64_t depth) {
    const auto lecture = static_cast<std::int32_t>(std::lround(static_cast<double>(depth) / unit));
    return turn_over != 0 ? turn_over - lecture : lecture;
  });
}

// Lecture 002 (Crawfis): 8 × 8, smaller is nearer, start ∞.
TEST(Lecture002, BothEightByEightRunsGiveTheirTables) {
  constexpr std::int32_t o = empty;
  const LectureTriangle level{{{{0, 1, 5}, {0, 7, 5}, {6, 7, 5}}}}, slope{{{{0, 1, 2}, {0, 6, 7}, {5, 1, 7}}}};
  const Table first{{5, 5, 5, 5, 5, 5, 5, o}, {5, 5, 5, 5, 5, 5, o, o}, {5, 5, 5, 5, 5, o, o, o},
                    {5, 5, 5, 5, o, o, o, o}, {5, 5, 5, o, o, o, o, o}, {5, 5, o, o, o, o, o, o},
                    {5, o, o, o, o, o, o, o}, {o, o, o, o, o, o, o, o}};
  const Table second{{5, 5, 5, 5, 5, 5, 5, o}, {5, 5, 5, 5, 5, 5, o, o}, {5, 5, 5, 5, 5, o, o, o},
                     {5, 5, 5, 5, o, o, o, o}, {4, 5, 5, 7, o, o, o, o}, {3, 4, 5, 6, 7, o, o, o},
                     {2, 3, 4, 5, 6, 7, o, o}, {o, o, o, o, o, o, o, o}};
  EXPECT_EQ(draw_triangles<Depth16<>>({level}, 4096), first);
  EXPECT_EQ(draw_triangles<Depth16<>>({level, slope}, 4096), second);
  EXPECT_EQ(draw_triangles<Depth16<>>({slope, level}, 4096), second) << "the order does not matter where depths differ";
  EXPECT_EQ(draw_triangles<Depth24<>>({level, slope}, 1 << 20), second);
}

// Lecture 003 (Chen): 8 × 8, larger is nearer, start 0; depths turn over to the vertices' sense and back.
TEST(Lecture003, TheEightByEightRunGivesItsTables) {
  using Depth = Depth16<DepthSense::larger_is_nearer>;
  constexpr std::int32_t o = empty;
  const LectureTriangle level{{{{0, 1, 5}, {0, 7, 5}, {6, 7, 5}}}}, slope{{{{0, 1, 8}, {0, 6, 3}, {5, 1, 3}}}};
  const Table first{{5, 5, 5, 5, 5, 5, 5, o}, {5, 5, 5, 5, 5, 5, o, o}, {5, 5, 5, 5, 5, o, o, o},
                    {5, 5, 5, 5, o, o, o, o}, {5, 5, 5, o, o, o, o, o}, {5, 5, o, o, o, o, o, o},
                    {5, o, o, o, o, o, o, o}, {o, o, o, o, o, o, o, o}};
  const Table second{{5, 5, 5, 5, 5, 5, 5, o}, {5, 5, 5, 5, 5, 5, o, o}, {5, 5, 5, 5, 5, o, o, o},
                     {5, 5, 5, 5, o, o, o, o}, {6, 5, 5, 3, o, o, o, o}, {7, 6, 5, 4, 3, o, o, o},
                     {8, 7, 6, 5, 4, 3, o, o}, {o, o, o, o, o, o, o, o}};
  EXPECT_EQ(draw_triangles<Depth>({level}, 4096, 10), first);
  EXPECT_EQ(draw_triangles<Depth>({level, slope}, 4096, 10), second);
}

// Lecture 002: rectangle and triangle, 32 × 32. No result is printed: it is computed here, depth · 2^12 in 16 bits.
TEST(Lecture002, TheRectangleAndTheTriangleShowTheNearerOfBoth) {
  constexpr int size = 32, unit = 4096;
  const auto at = [](int x, int y, int z) { return Corner{x * 16, y * 16, std::min(z * unit, 65534)}; };
  const std::vector<Corners> scene{{at(10, 5, 10), at(10, 25, 10), at(25, 25, 10)},
                                   {at(10, 5, 10), at(25, 25, 10), at(25, 5, 10)},
                                   {at(15, 15, 15), at(25, 25, 5), at(30, 10, 5)}};
  const std::vector<std::uint16_t> colours{1, 1, 2};
  Studio<FlatTraits<Rgb565, Depth16<>>> studio(screen_capacity(size, size, scene.size()));
  const auto vertices = vertices_of(scene, 16, size, size);
  FrameSettings settings;
  settings.cull = Cull::none;
  studio.begin(settings);
  studio.add_screen(vertices, colours);
  const auto picture = studio.draw();
  int seen[3] = {};
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      std::uint16_t want = 0;
      double nearest_depth = 1e9, second = 1e9;
      for (std::size_t k = 0; k < scene.size(); ++k) {
        const ExactTriangle exact(scene[k]);
        if (!exact.covers(x, y)) continue;
        const double depth = exact.depth(x, y);
        if (depth < nearest_depth) {
          second = nearest_depth;
          nearest_depth = depth;
          want = colours[k];
        } else {
          second = std::min(second, depth);
        }
      }
      ++seen[want];
      if (second - nearest_depth > 2 || nearest_depth > 1e8) {
        EXPECT_EQ(picture.pixels[picture.at(x, y)], want) << x << ", " << y;
      }
    }
  EXPECT_GT(seen[1], 100);
  EXPECT_GT(seen[2], 30);
}

// Lecture 001 (Mcloughlin): two triangles whose printed depths are not planar, start 999,999. Fragments row by row.
TEST(Lecture001, TheThirteenColumnTablesFollowFromTheirFragments) {
  constexpr std::int32_t o = empty;
  // The first triangle as its table prints it.
  const Table first{{o, o, o, o, o, 90, o, o, o, o, o, o, o},       {o, o, o, o, 87, 89, o, o, o, o, o, o, o},
                    {o, o, o, o, 85, 88, o, o, o, o, o, o, o},      {o, o, o, 83, 85, 87, o, o, o, o, o, o, o},
                    {o, o, o, 81, 83, 84, 86, o, o, o, o, o, o},    {o, o, 79, 81, 83, 85, 86, o, o, o, o, o, o},
                    {o, 75, 77, 78, 80, 82, 85, o, o, o, o, o, o},  {o, 72, 74, 76, 79, 81, 84, o, o, o, o, o, o},
                    {70, 72, 76, 78, 81, 82, 83, o, o, o, o, o, o}, {o, o, 73, 74, 78, 80, 82, o, o, o, o, o, o},
                    {o, o, o, o, 75, 78, 81, o, o, o, o, o, o},     {o, o, o, o, o, o, 81, 80, o, o, o, o, o},
                    {o, o, o, o, o, o, 80, 80, o, o, o, o, o}};
  // Both together. Where it shows a depth that the first does not have, the second triangle has that depth.
  const Table both{{o, o, o, o, o, 90, o, o, o, o, o, o, o},        {o, o, o, o, 87, 89, o, o, o, o, o, o, o},
                   {o, o, o, o, 85, 88, o, o, o, 100, o, o, o},     {o, o, o, 83, 85, 87, o, o, 95, o, o, o, o},
                   {o, o, o, 81, 83, 84, 86, 90, 91, o, o, o, o},   {o, o, 79, 81, 83, 85, 85, 88, o, o, o, o, o},
                   {o, 75, 77, 78, 80, 81, 83, 86, o, o, o, o, o},  {o, 72, 74, 75, 77, 80, 83, o, o, o, o, o, o},
                   {70, 67, 75, 75, 77, 80, 81, 82, o, o, o, o, o}, {63, 66, 70, 73, 77, 79, 82, o, o, o, o, o, o},
                   {63, 65, 70, 72, 75, 78, 81, o, o, o, o, o, o},  {o, 65, 70, 73, o, 78, 81, 80, o, o, o, o, o},
                   {o, o, 67, 70, o, o, 80, 80, o, o, o, o, o}};
  std::vector<Fragment> fragments;
  const auto add = [&](const Table& table, std::uint16_t colour, auto wanted) {
    for (int y = 0; y < 13; ++y)
      for (int x = 0; x < 13; ++x) {
        const std::int32_t depth = table[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
        if (depth != o && wanted(x, y)) fragments.push_back({x, y, depth, colour});
      }
  };
  const auto always = [](int, int) { return true; };
  const auto depths = [](std::int64_t depth) { return static_cast<std::int32_t>(depth); };
  add(first, 1, always);
  EXPECT_EQ(table_of(draw_fragments<Depth16<>>(13, 13, fragments), depths), first);
  const auto differs = [&](int x, int y) {
    return first[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] !=
           both[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
  };
  add(both, 2, differs);
  const auto picture = draw_fragments<Depth16<>>(13, 13, fragments);
  EXPECT_EQ(table_of(picture, depths), both);
  for (int y = 0; y < 13; ++y)
    for (int x = 0; x < 13; ++x)
      if (picture.drawn(x, y)) {
        EXPECT_EQ(picture.pixels[picture.at(x, y)], differs(x, y) ? 2 : 1);
      }
  // The other way round nothing changes but the owner of equal depths: there are none.
  std::stable_sort(fragments.begin(), fragments.end(),
                   [](const Fragment& a, const Fragment& b) { return a.colour > b.colour; });
  EXPECT_TRUE(draw_fragments<Depth16<>>(13, 13, fragments) == picture);
}

}  // namespace
}  // namespace spanline::test
