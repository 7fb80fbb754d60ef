// 16 bits against 24: pictures differ only where two depths lie within two 16-bit units of each other (design, section
// 5).
#include <gtest/gtest.h>
#include <spanline/frame/ready_made_traits.hpp>

#include <cmath>
#include <vector>

#include "support/effort.hpp"
#include "support/exact_triangle.hpp"
#include "support/ready_made_studios.hpp"
#include "support/triangle_kinds.hpp"

namespace spanline::test {
namespace {

TEST(DepthBits, PicturesDifferOnlyWhereDepthsAreWithinTwoUnits) {
  constexpr int width = 160, height = 120;
  TriangleMaker make(23, width, height, 256, (65534 << 8) - 256);
  std::size_t different = 0, pixels = 0;
  double widest = 0;
  for (int i = 0; i < rounds(60); ++i) {
    std::vector<Corners> fine, coarse;
    const bool flat = i % 2 == 1;  // depths close together: many near ties
    for (std::size_t k = 0; k < 66; ++k) {
      Corners t = make(all_triangle_kinds[k % all_triangle_kinds.size()]);
      if (flat)
        for (Corner& c : t) c.z = 0x400000 + (c.z & 0x3fff);
      fine.push_back(t);
      for (Corner& c : t) c.z = (c.z + 128) >> 8;
      coarse.push_back(t);
    }
    Studio<IdTraits<Depth24<>>> studio24(screen_capacity(width, height, fine.size()));
    Studio<IdTraits<Depth16<>>> studio16(screen_capacity(width, height, fine.size()));
    const auto p24 = studio24.draw_screen(fine);
    const auto p16 = studio16.draw_screen(coarse);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const std::uint32_t a = p24.pixels[p24.at(x, y)], b = p16.pixels[p16.at(x, y)];
        ++pixels;
        if (a == b) continue;
        ++different;
        ASSERT_TRUE(a != 0 && b != 0);
        const double gap =
            std::fabs(ExactTriangle(fine[a - 1]).depth(x, y) - ExactTriangle(fine[b - 1]).depth(x, y)) / 256;
        ASSERT_LE(gap, 2.0) << "pixel " << x << ", " << y << " of round " << i;
        widest = std::max(widest, gap);
      }
  }
  EXPECT_GT(different, 0U) << "the soups hold no near tie: the test shows nothing";
  std::printf("%zu of %zu pixels differ, depths up to %.3f units apart\n", different, pixels, widest);
}

}  // namespace
}  // namespace spanline::test
