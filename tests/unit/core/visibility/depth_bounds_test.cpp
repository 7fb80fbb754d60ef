// Depth bounds for tiles of a line: the same bytes as without them, and most depths never looked at where large
// polygons hide one another.
#include <gtest/gtest.h>
#include <spanline/frame/ready_made_traits.hpp>
#include <spanline/model/cull.hpp>

#include <vector>

#include "scenes/screen_soups.hpp"
#include "support/effort.hpp"
#include "support/ready_made_studios.hpp"
#include "support/triangle_kinds.hpp"

namespace spanline::test {
namespace {

template <class Depth>
class DepthBoundsOf : public ::testing::Test {};
using Depths = ::testing::Types<Depth16<>, Depth16<DepthSense::larger_is_nearer>, Depth24<>,
                                Depth24<DepthSense::larger_is_nearer>>;
TYPED_TEST_SUITE(DepthBoundsOf, Depths);

/// Triangles of one kind or of all, their depths anywhere, close together, or one behind the other.
std::vector<Corners> soup_of(TriangleMaker& make, std::size_t kind, std::size_t count, int order) {
  std::vector<Corners> soup;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t chosen = kind < all_triangle_kinds.size() ? kind : i % all_triangle_kinds.size();
    Corners t = make(all_triangle_kinds[chosen]);
    const auto step = static_cast<std::int32_t>(order == 1 ? i : count - i);
    if (order != 0)
      for (Corner& c : t) c.z = 100 + step * 400 + c.z % 300;
    soup.push_back(t);
  }
  return soup;
}

TYPED_TEST(DepthBoundsOf, ChangeNoByte) {
  constexpr std::size_t count = 80;
  for (const auto& [width, height] : {std::pair{320, 240}, {97, 61}, {33, 40}, {500, 30}})
    for (std::size_t kind = 0; kind <= all_triangle_kinds.size(); ++kind)
      for (int i = 0; i < rounds(6); ++i) {
        TriangleMaker make(static_cast<std::uint32_t>(kind) * 100 + static_cast<std::uint32_t>(i), width, height,
                           TypeParam::nearest, TypeParam::farthest);
        const auto soup = soup_of(make, kind, count, i % 3);
        Studio<IdTraits<TypeParam>> plain(screen_capacity(width, height, count));
        const auto want = plain.draw_screen(soup);
        for (const int lines : {0, 1, 7, 16}) {
          Studio<IdTraits<TypeParam, BoundedZBuffer>> bounded(screen_capacity(width, height, count, lines));
          const auto got = bounded.draw_screen(soup);
          ASSERT_TRUE(bounded.status().ok());
          ASSERT_EQ(got.pixels, want.pixels) << "kind " << kind << ", round " << i << ", bands of " << lines;
          ASSERT_EQ(got.depth, want.depth) << "kind " << kind << ", round " << i << ", bands of " << lines;
        }
      }
}

/// Depth comparisons of twenty quads over the whole picture.
template <class Visibility>
std::uint64_t tests_of_quads(bool back_to_front) {
  std::vector<ScreenVertex> vertices(120);
  std::vector<std::uint16_t> colours(40);
  scenes::make_full_screen_quads(back_to_front, 16, {vertices, colours});
  Studio<FlatTraits<Rgb565, Depth16<>, Counted, Visibility>> studio(screen_capacity(320, 240, 40));
  FrameSettings settings;
  settings.cull = Cull::none;
  studio.begin(settings);
  studio.add_screen(vertices, colours);
  (void)studio.draw();
  return studio.statistics().visibility.depth_tests;
}

TEST(DepthBounds, RejectAndAcceptWholeBlocks) {
  constexpr std::uint64_t all = std::uint64_t{20} * 320 * 240;
  EXPECT_EQ(tests_of_quads<ZBuffer>(false), all);
  EXPECT_EQ(tests_of_quads<ZBuffer>(true), all);
  // What is left is the blocks that a diagonal cuts: their other half may be anything.
  EXPECT_LT(tests_of_quads<BoundedZBuffer>(false), all / 10);
  EXPECT_LT(tests_of_quads<BoundedZBuffer>(true), all / 10);
}

}  // namespace
}  // namespace spanline::test
