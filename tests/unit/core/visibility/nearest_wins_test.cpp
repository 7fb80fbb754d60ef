// Which polygon a pixel shows: the nearest, and at equal depth the one that was submitted first.
#include <gtest/gtest.h>
#include <spanline/frame/ready_made_traits.hpp>
#include <spanline/raster/surface_blocks.hpp>

#include <vector>

#include "support/effort.hpp"
#include "support/exact_triangle.hpp"
#include "support/ready_made_studios.hpp"
#include "support/triangle_kinds.hpp"

namespace spanline::test {
namespace {

constexpr int width = 160, height = 120;

std::vector<Corners> mixed_soup(TriangleMaker& make, std::size_t count) {
  std::vector<Corners> soup;
  for (std::size_t i = 0; i < count; ++i) soup.push_back(make(all_triangle_kinds[i % all_triangle_kinds.size()]));
  return soup;
}

/// At every pixel: the shown triangle covers it, and none that covers it is nearer by more than both roundings.
template <class Depth>
void check_winners(const std::vector<Corners>& soup, const Picture<IdTraits<Depth>>& picture) {
  constexpr double bound = Depth::bits == 16 ? 2.0 : 4.0;
  std::vector<double> least(picture.pixels.size(), 1e18), shown(picture.pixels.size(), 1e18);
  for (std::size_t k = 0; k < soup.size(); ++k) {
    const ExactTriangle exact(soup[k]);
    exact.for_each_pixel(width, height, [&](int x, int y) {
      const std::size_t p = picture.at(x, y);
      const double depth = exact.depth(x, y);
      least[p] = std::min(least[p], depth);
      if (picture.pixels[p] == k + 1) shown[p] = depth;
    });
  }
  for (std::size_t p = 0; p < least.size(); ++p) {
    ASSERT_EQ(picture.pixels[p] != 0, least[p] < 1e18) << "pixel " << p;
    ASSERT_LE(shown[p], least[p] + bound) << "pixel " << p;
  }
}

template <class Depth>
class NearestWins : public ::testing::Test {};
using Depths = ::testing::Types<Depth16<>, Depth16<DepthSense::larger_is_nearer>, Depth24<>,
                                Depth24<DepthSense::larger_is_nearer>>;
TYPED_TEST_SUITE(NearestWins, Depths);

TYPED_TEST(NearestWins, AgainstEveryFragmentOfEveryTriangle) {
  TriangleMaker make(5, width, height, TypeParam::nearest, TypeParam::farthest);
  Studio<IdTraits<TypeParam>> studio(screen_capacity(width, height, 88));
  for (int i = 0; i < rounds(25); ++i) {
    const auto soup = mixed_soup(make, 88);
    check_winners<TypeParam>(soup, studio.draw_screen(soup));
    if (this->HasFatalFailure()) return;
  }
}

TYPED_TEST(NearestWins, AtEqualDepthTheEarlierPolygonStays) {
  TriangleMaker make(6, width, height, TypeParam::nearest, TypeParam::farthest);
  Studio<IdTraits<TypeParam>> studio(screen_capacity(width, height, 40));
  for (int i = 0; i < rounds(60); ++i) {
    auto soup = mixed_soup(make, 40);
    const std::int32_t z = make.depth();
    for (Corners& t : soup)
      for (Corner& c : t) c.z = z;
    const auto picture = studio.draw_screen(soup);
    std::vector<std::uint32_t> first(picture.pixels.size());
    for (std::size_t k = soup.size(); k-- > 0;)
      ExactTriangle(soup[k]).for_each_pixel(
          width, height, [&](int x, int y) { first[picture.at(x, y)] = static_cast<std::uint32_t>(k) + 1; });
    ASSERT_EQ(picture.pixels, first) << "round " << i;
  }
}

TYPED_TEST(NearestWins, ATriangleNeverHidesItsOwnCopy) {
  TriangleMaker make(7, width, height, TypeParam::nearest, TypeParam::farthest);
  Studio<IdTraits<TypeParam>> studio(screen_capacity(width, height, 2));
  for (int i = 0; i < rounds(300); ++i) {
    const Corners t = make(all_triangle_kinds[static_cast<std::size_t>(i) % all_triangle_kinds.size()]);
    const std::vector<Corners> both{t, t};
    const auto picture = studio.draw_screen(both);
    for (const std::uint32_t id : picture.pixels) ASSERT_NE(id, 2U) << t;
  }
}

}  // namespace
}  // namespace spanline::test
