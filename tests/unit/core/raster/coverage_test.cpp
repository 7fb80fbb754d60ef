// Every pixel that a triangle covers, and no other, against exact edge functions.
#include <gtest/gtest.h>
#include <spanline/frame/ready_made_traits.hpp>
#include <spanline/raster/surface_blocks.hpp>

#include "support/effort.hpp"
#include "support/exact_triangle.hpp"
#include "support/ready_made_studios.hpp"
#include "support/triangle_kinds.hpp"

namespace spanline::test {
namespace {

using Traits = FlatTraits<Rgb565, Depth16<>>;

class Coverage : public ::testing::TestWithParam<TriangleKind> {};

struct Difference {
  std::size_t covered = 0;  ///< pixels that the definition covers
  std::size_t missing = 0;  ///< of these, not drawn
  std::size_t extra = 0;    ///< drawn, but not covered
};

Difference compare(const ExactTriangle& exact, const Picture<Traits>& picture) {
  Difference d;
  exact.for_each_pixel(picture.width, picture.height, [&](int x, int y) {
    ++d.covered;
    if (!picture.drawn(x, y)) ++d.missing;
  });
  d.extra = picture.drawn_count() - (d.covered - d.missing);
  return d;
}

TEST_P(Coverage, NotOnePixelDiffersFromExactEdgeFunctions) {
  constexpr int width = 208, height = 160;
  Studio<Traits> studio(screen_capacity(width, height, 1));
  TriangleMaker make(1 + static_cast<std::uint32_t>(GetParam()), width, height, 0, 65534);
  std::size_t pixels = 0;
  const bool small = GetParam() <= TriangleKind::pixel;
  for (int i = 0; i < rounds(small ? 20000 : 3000); ++i) {
    const Corners corners = make(GetParam());
    const auto picture = studio.draw_screen({&corners, 1});
    ASSERT_TRUE(studio.status().ok());
    const Difference d = compare(ExactTriangle(corners), picture);
    ASSERT_EQ(d.missing + d.extra, 0U) << corners;
    pixels += d.covered;
  }
  std::printf("%s: %zu covered pixels\n", name_of(GetParam()), pixels);
}

TEST_P(Coverage, BothOrientationsCoverTheSame) {
  constexpr int width = 208, height = 160;
  Studio<Traits> studio(screen_capacity(width, height, 1));
  TriangleMaker make(100 + static_cast<std::uint32_t>(GetParam()), width, height, 0, 65534);
  for (int i = 0; i < rounds(400); ++i) {
    Corners corners = make(GetParam());
    const auto one = studio.draw_screen({&corners, 1});
    std::swap(corners[0], corners[1]);
    const auto other = studio.draw_screen({&corners, 1});
    for (std::size_t p = 0; p < one.depth.size(); ++p)
      ASSERT_EQ(one.depth[p] == Depth16<>::clear, other.depth[p] == Depth16<>::clear) << corners;
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, Coverage, ::testing::ValuesIn(all_triangle_kinds),
                         [](const auto& kind) { return name_of(kind.param); });

TEST(Coverage, TrianglesWithoutAreaDrawNothing) {
  Studio<Traits> studio(screen_capacity(64, 64, 1));
  Random random(7);
  for (int i = 0; i < rounds(2000); ++i) {
    const int x = random.between(-500, 1500), y = random.between(-500, 1500), dx = random.between(-40, 40),
              dy = random.between(-40, 40), k = random.between(-9, 9), m = random.between(-9, 9);
    const Corners line{Corner{x, y, 5}, Corner{x + k * dx, y + k * dy, 9}, Corner{x + m * dx, y + m * dy, 7}};
    ASSERT_EQ(studio.draw_screen({&line, 1}).drawn_count(), 0U) << line;
  }
}

}  // namespace
}  // namespace spanline::test
