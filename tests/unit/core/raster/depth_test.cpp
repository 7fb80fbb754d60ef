// The depth of every covered pixel against the exact plane of the snapped triangle (promise 5).
#include <gtest/gtest.h>
#include <spanline/frame/ready_made_traits.hpp>
#include <spanline/raster/surface_blocks.hpp>

#include "support/effort.hpp"
#include "support/exact_triangle.hpp"
#include "support/ready_made_studios.hpp"
#include "support/triangle_kinds.hpp"

namespace spanline::test {
namespace {

template <class DepthT>
class DepthOf : public ::testing::Test {};

using Depths = ::testing::Types<Depth16<>, Depth16<DepthSense::larger_is_nearer>, Depth24<>,
                                Depth24<DepthSense::larger_is_nearer>>;

struct DepthNames {
  template <class Depth>
  static std::string GetName(int) {
    return "bits" + std::to_string(Depth::bits) + (Depth::smaller ? "_smaller" : "_larger");
  }
};
TYPED_TEST_SUITE(DepthOf, Depths, DepthNames);

/// The greatest error over random triangles of a kind, units of the depth format.
template <class Depth>
double worst_error(TriangleKind kind, int width, int height, int wanted) {
  Studio<FlatTraits<Rgb565, Depth>> studio(screen_capacity(width, height, 1));
  TriangleMaker make(31 + static_cast<std::uint32_t>(kind), width, height, Depth::nearest, Depth::farthest);
  double worst = 0;
  for (int i = 0; i < rounds(wanted); ++i) {
    const Corners corners = make(kind);
    const auto picture = studio.draw_screen({&corners, 1});
    const ExactTriangle exact(corners);
    exact.for_each_pixel(width, height, [&](int x, int y) {
      const double error = exact.depth_error(x, y, picture.depth_integer(x, y));
      if (error > worst) worst = error;
      if (error > (Depth::bits == 16 ? 1.0 : 2.0)) ADD_FAILURE() << corners << "at " << x << ", " << y << ": " << error;
    });
    if (::testing::Test::HasFailure()) break;
  }
  return worst;
}

template <class Depth>
void check_kinds(int width, int height, int small_rounds, int large_rounds) {
  double worst = 0;
  for (const TriangleKind kind : all_triangle_kinds) {
    const bool small = kind <= TriangleKind::medium || kind == TriangleKind::right_angled;
    worst = std::max(worst, worst_error<Depth>(kind, width, height, small ? small_rounds : large_rounds));
  }
  std::printf("%d bits, %dx%d: %.4f units at most\n", Depth::bits, width, height, worst);
}

TYPED_TEST(DepthOf, EveryPixelIsWithinItsBoundAt320x240) { check_kinds<TypeParam>(320, 240, 1500, 60); }

TYPED_TEST(DepthOf, EveryPixelIsWithinItsBoundAt448x320) { check_kinds<TypeParam>(448, 320, 100, 60); }

TYPED_TEST(DepthOf, EveryPixelIsWithinItsBoundAt700x68) { check_kinds<TypeParam>(700, 68, 100, 60); }

TYPED_TEST(DepthOf, EveryPixelIsWithinItsBoundAt64x50) { check_kinds<TypeParam>(64, 50, 1500, 600); }

TYPED_TEST(DepthOf, NoDepthWrapsOntoTheClearValue) {
  using Depth = TypeParam;
  Studio<FlatTraits<Rgb565, Depth>> studio(screen_capacity(96, 64, 1));
  TriangleMaker make(77, 96, 64, Depth::nearest, Depth::farthest);
  for (int i = 0; i < rounds(3000); ++i) {
    Corners corners = make(all_triangle_kinds[static_cast<std::size_t>(i) % all_triangle_kinds.size()]);
    for (Corner& c : corners) c.z = make.random().chance(2) ? Depth::nearest : Depth::farthest;
    const auto picture = studio.draw_screen({&corners, 1});
    std::size_t covered = 0;
    ExactTriangle(corners).for_each_pixel(96, 64, [&](int, int) { ++covered; });
    ASSERT_EQ(picture.drawn_count(), covered) << corners;
  }
}

}  // namespace
}  // namespace spanline::test
