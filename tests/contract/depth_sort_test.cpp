// Painter's algorithm and depth sort: the lectures' pictures of what each can do, and depth sort in the form of the
// textbook, which shares neither lists, masks nor tests with the real one.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "generators.hpp"
#include "sizes.hpp"
#include "support/effort.hpp"
#include "textbook_depth_sort.hpp"
#include "verdict.hpp"

namespace spanline::contract {
namespace {

Drawing draw_by(const char* name, const Scene& scene, const Manner& manner = {}) {
  return draw(algorithm(name), scene, manner);
}

class DepthSortOfTheTextbook : public ::testing::TestWithParam<const char*> {};

TEST_P(DepthSortOfTheTextbook, DrawsWhatTheZBufferAndDepthSortDraw) {
  const Generator& kind = generator(GetParam());
  int moves = 0, splits = 0;
  for (int i = 0; i < test::rounds(48); ++i) {
    const int round = i + 10'000'000;
    Random random(seed_of(kind, round));
    Scene scene = kind.make(random);
    constexpr std::size_t most = 24;  // for the sake of time
    if (scene.triangles.size() > most) scene.triangles.resize(most);
    const TextbookDepthSort textbook(scene);
    moves += textbook.moves();
    splits += textbook.splits();
    ASSERT_EQ(difference(reference(scene), textbook.drawing()), "") << "seed " << seed_of(kind, round) << '\n'
                                                                    << text_of(scene);
    ASSERT_EQ(difference(textbook.drawing(), draw_by("depth-sort", scene, {.band_lines = 1 + i % 20})), "")
        << "seed " << seed_of(kind, round) << '\n'
        << text_of(scene);
  }
  EXPECT_GT(moves, 0);
  EXPECT_GT(splits, 0);
}

INSTANTIATE_TEST_SUITE_P(Of, DepthSortOfTheTextbook,
                         ::testing::Values("penetrating", "cyclic_bars", "mixed_soup", "coplanar_ties"),
                         [](const auto& kind) { return std::string(kind.param); });

/// Triangles of constant depths, of which some are equal.
Scene level_polygons(Random& random) {
  Scene scene = sized(random);
  test::TriangleMaker make(static_cast<std::uint32_t>(random.between(0, 1 << 30)), scene.width, scene.height,
                           nearest_depth, farthest_depth);
  const int count = random.between(2, 60), depths = random.between(1, 40);
  const std::int32_t step = random.chance(2) ? 1 : farthest_depth / 64;
  for (int i = 0; i < count; ++i) {
    Corners t = make(test::all_triangle_kinds[static_cast<std::size_t>(i) % test::all_triangle_kinds.size()]);
    const std::int32_t z = depth_near(random.between(0, depths) * std::int64_t{step} + 1000);
    for (Corner& c : t) c.z = z;
    scene.triangles.push_back(t);
  }
  return scene;
}

// Lecture 003, "The Painter's Algorithm": for planes with constant z, not for real 3D, just for 2½D.
TEST(TwoAndAHalfDimensions, PainterAndDepthSortDrawTheZBuffersBytes) {
  for (int round = 0; round < test::rounds(120); ++round) {
    Random random(static_cast<std::uint32_t>(round + 1));
    const Scene scene = level_polygons(random);
    for (const auto content : {Manner::Content::ids, Manner::Content::colours})
      for (const auto sense : {DepthSense::smaller_is_nearer, DepthSense::larger_is_nearer}) {
        Manner manner{.content = content, .sense = sense};
        const Drawing want = reference(scene, manner);
        for (const int lines : {1, 7, 16, 0}) {
          manner.band_lines = lines;
          for (const char* name : {"painter", "depth-sort"})
            ASSERT_EQ(difference(want, draw_by(name, scene, manner)), "")
                << name << ", round " << round << ", bands of " << lines << '\n'
                << text_of(scene);
        }
      }
  }
}

TEST(TwoAndAHalfDimensions, OfEqualDepthsTheFirstSubmittedIsSeen) {
  Scene scene(32, 32);
  const Corners low{Corner{0, 0, 5000}, Corner{512, 0, 5000}, Corner{0, 512, 5000}};
  const Corners high{Corner{512, 512, 5000}, Corner{0, 512, 5000}, Corner{512, 0, 5000}};
  const Corners across{Corner{0, 128, 5000}, Corner{512, 128, 5000}, Corner{512, 384, 5000}};
  scene.triangles = {low, across, high, low};
  for (const char* name : {"painter", "depth-sort"}) {
    const Drawing got = draw_by(name, scene);
    EXPECT_EQ(got.pixels[got.at(4, 9)], 1U) << name;
    EXPECT_EQ(got.pixels[got.at(30, 12)], 2U) << name;
    EXPECT_EQ(got.pixels[got.at(30, 30)], 3U) << name;
    EXPECT_EQ(difference(reference(scene), got), "") << name;
  }
}

/// A picture of the lectures that painter draws wrong and depth sort right.
class OverlapCase : public ::testing::Test {
 protected:
  OverlapCase() : scene_(64, 64) {}

  static Corner at(int x, int y, std::int32_t z) { return {16 * x, 16 * y, z}; }
  void add(const Corner& a, const Corner& b, const Corner& c) { scene_.triangles.push_back({a, b, c}); }
  /// A parallelogram of corners a, b, a + d, b + d as two triangles.
  void add_bar(const Corner& a, const Corner& b, int dx, int dy) {
    const Corner c{b.x + 16 * dx, b.y + 16 * dy, b.z}, d{a.x + 16 * dx, a.y + 16 * dy, a.z};
    add(a, b, c);
    add(a, c, d);
  }
  /// Returns painter's picture.
  Drawing expect_that_painter_is_wrong_and_the_others_are_not() {
    const Drawing want = reference(scene_);
    for (const int lines : {1, 7, 16, 0}) {
      const Manner manner{.band_lines = lines};
      EXPECT_NE(difference(want, draw_by("painter", scene_, manner)), "");
      EXPECT_EQ(difference(want, draw_by("depth-sort", scene_, manner)), "");
    }
    EXPECT_EQ(difference(want, TextbookDepthSort(scene_).drawing()), "");
    EXPECT_EQ(fault_in(scene_, {}), "");
    return draw_by("painter", scene_);
  }

  Scene scene_;
};

// Lecture 000, "Painters algorithm — Doesn't always work": Q reaches farther back than P and hides it all the same.
TEST_F(OverlapCase, TheFartherCornerIsNotAlwaysOfTheFartherPolygon) {
  add(at(6, 8, 8 << 20), at(30, 8, 8 << 20), at(18, 40, 8 << 20));    // P, level
  add(at(2, 10, 1 << 20), at(2, 44, 1 << 20), at(62, 20, 14 << 20));  // Q, in front where both are
  const Drawing painter = expect_that_painter_is_wrong_and_the_others_are_not();
  EXPECT_EQ(painter.pixels[painter.at(17, 24)], 1U);
  EXPECT_EQ(reference(scene_).pixels[painter.at(17, 24)], 2U);
  EXPECT_EQ(TextbookDepthSort(scene_).splits(), 0) << "the order alone is to be found";
}

// Depth sort's own trouble: the polygon with the nearer corner is the hidden one.
TEST_F(OverlapCase, TheNearerCornerIsNotAlwaysOfTheNearerPolygon) {
  add(at(30, 8, 5 << 20), at(54, 8, 5 << 20), at(42, 40, 5 << 20));   // P, level
  add(at(2, 10, 1 << 20), at(2, 44, 1 << 20), at(62, 20, 14 << 20));  // Q, behind where both are
  const Drawing want = reference(scene_), got = draw_by("depth-sort", scene_);
  EXPECT_EQ(want.pixels[want.at(42, 20)], 1U);
  EXPECT_EQ(difference(want, got), "");
  EXPECT_EQ(difference(want, TextbookDepthSort(scene_).drawing()), "");
  EXPECT_EQ(TextbookDepthSort(scene_).moves(), 1);
  EXPECT_EQ(got.counters.named("moves"), 1U);
  EXPECT_EQ(got.counters.named("resolved"), 0U);
}

// Lecture 000, "Another situation it does not work": each bar over the next one and under the one before.
TEST_F(OverlapCase, ThreeBarsOverlapInACycle) {
  constexpr std::int32_t near = 2 << 20, far = 12 << 20;
  add_bar(at(2, 46, near), at(58, 46, far), 0, 8);
  add_bar(at(56, 62, near), at(26, 2, far), 8, 0);
  add_bar(at(30, 2, near), at(0, 62, far), 8, 0);
  expect_that_painter_is_wrong_and_the_others_are_not();
  EXPECT_GT(TextbookDepthSort(scene_).splits(), 0);
  const Drawing want = reference(scene_);
  const auto bar_at = [&](int x, int y) { return (want.pixels[want.at(x, y)] + 1) / 2; };
  EXPECT_EQ(bar_at(12, 50), 1U) << "over the third";
  EXPECT_EQ(bar_at(50, 50), 2U) << "over the first";
  EXPECT_EQ(bar_at(30, 7), 3U) << "over the second";
}

TEST_F(OverlapCase, TwoPolygonsPenetrate) {
  add(at(4, 32, 2 << 20), at(60, 6, 12 << 20), at(60, 58, 12 << 20));
  add(at(60, 30, 2 << 20), at(4, 58, 12 << 20), at(4, 4, 12 << 20));
  expect_that_painter_is_wrong_and_the_others_are_not();
  const Drawing want = reference(scene_);
  EXPECT_EQ(want.pixels[want.at(20, 31)], 1U);
  EXPECT_EQ(want.pixels[want.at(44, 31)], 2U);
  EXPECT_EQ(TextbookDepthSort(scene_).splits(), 1);
  EXPECT_EQ(draw_by("depth-sort", scene_).counters.named("resolved"), 1U);
}

}  // namespace
}  // namespace spanline::contract
