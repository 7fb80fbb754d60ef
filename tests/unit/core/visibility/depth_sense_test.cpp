// Both senses of depth draw the same picture, and their depths are complements.
#include <gtest/gtest.h>
#include <spanline/frame/ready_made_traits.hpp>

#include <vector>

#include "support/effort.hpp"
#include "support/ready_made_studios.hpp"
#include "support/triangle_kinds.hpp"

namespace spanline::test {
namespace {

template <class Smaller, class Larger>
void check_senses() {
  constexpr int width = 200, height = 150;
  TriangleMaker make(17, width, height, Smaller::nearest, Smaller::farthest);
  for (int i = 0; i < rounds(20); ++i) {
    std::vector<Corners> soup;
    for (std::size_t k = 0; k < 99; ++k) soup.push_back(make(all_triangle_kinds[k % all_triangle_kinds.size()]));
    Studio<IdTraits<Smaller>> smaller(screen_capacity(width, height, 99));
    Studio<IdTraits<Larger>> larger(screen_capacity(width, height, 99, 7));
    const auto a = smaller.draw_screen(soup);
    const auto b = larger.draw_screen(soup);
    ASSERT_EQ(a.pixels, b.pixels) << "round " << i;
    for (std::size_t p = 0; p < a.depth.size(); ++p) {
      // Clear values are complements as well.
      ASSERT_EQ(a.depth[p], static_cast<typename Smaller::Word>(~b.depth[p])) << "pixel " << p;
      ASSERT_EQ(Smaller::integer(a.depth[p]) + Larger::integer(b.depth[p]), (1u << Smaller::bits) - 1);
    }
  }
}

TEST(DepthSense, PicturesAreTheSameAt16Bits) { check_senses<Depth16<>, Depth16<DepthSense::larger_is_nearer>>(); }
TEST(DepthSense, PicturesAreTheSameAt24Bits) { check_senses<Depth24<>, Depth24<DepthSense::larger_is_nearer>>(); }

}  // namespace
}  // namespace spanline::test
