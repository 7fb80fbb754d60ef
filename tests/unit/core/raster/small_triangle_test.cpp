// What the set-up of small triangles takes: slopes and errors as its header states them, on either side of the limits.
#include "spanline/raster/small_triangle.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "support/effort.hpp"
#include "support/random.hpp"

namespace spanline::test {
namespace {

using small_triangle::Precision;

/// A random triangle that fits, and the exact plane of a quantity over it, in units a pixel.
struct Sloped {
  std::array<ScreenVertex, 3> corners;
  Triangle triangle{};
  std::array<std::int32_t, 3> values{};
  double dx = 0, dy = 0;

  Sloped(Random& random, std::int32_t greatest) {
    do {
      for (ScreenVertex& v : corners) v = ScreenVertex::make(random.between(0, 320), random.between(0, 255), 0, 16, 0);
      triangle = Triangle::from(&corners[0], &corners[1], &corners[2]);
      if (triangle.doubled_area() < 0) triangle.flip();
    } while (!small_triangle::fits(triangle) || triangle.doubled_area() < 256 || triangle.doubled_area() >= 1 << 16);
    const std::int32_t middle = random.between(0, 65535), reach = random.between(1, greatest);
    for (std::int32_t& v : values) v = std::clamp(middle + random.between(-reach, reach), 0, 65535);
    const double area = triangle.doubled_area(), d1 = values[1] - values[0], d2 = values[2] - values[0];
    dx = 16 * (d1 * triangle.dy2 - d2 * triangle.dy1) / area;
    dy = 16 * (d2 * triangle.dx1 - d1 * triangle.dx2) / area;
  }

  template <Precision Wanted>
  [[nodiscard]] bool taken(LinearFunction& function) const {
    const small_triangle::Gradients gradients(static_cast<std::uint32_t>(triangle.doubled_area()));
    const std::int32_t row_offset = 8 - (triangle.ay & 15);
    return gradients.fit<Wanted>(triangle, values[0], values[1], values[2], row_offset, function);
  }
  [[nodiscard]] double steepness() const { return std::fabs(dx) + std::fabs(dy); }
};

template <Precision Wanted>
void check_limit(std::uint32_t seed, double limit, std::int32_t greatest) {
  Random random(seed);
  int below = 0, above = 0;
  for (int i = 0; i < rounds(40000); ++i) {
    const Sloped sloped(random, greatest);
    LinearFunction function{};
    const bool taken = sloped.taken<Wanted>(function);
    if (sloped.steepness() > limit * 1.01) {
      ASSERT_FALSE(taken) << "round " << i << ": " << sloped.steepness();
      ++above;
    } else if (sloped.steepness() < limit * 0.99) {
      ASSERT_TRUE(taken) << "round " << i << ": " << sloped.steepness();
      ++below;
    }
  }
  EXPECT_GT(below, rounds(40000) / 20);
  EXPECT_GT(above, rounds(40000) / 20);
}

TEST(SmallTriangle, TakesDepthsBelow1024UnitsAPixelAndNoSteeperOnes) { check_limit<Precision::depth>(1, 1024, 8000); }

TEST(SmallTriangle, TakesShadesBelow16384UnitsAPixelAndNoSteeperOnes) {
  check_limit<Precision::shade>(2, 16384, 65535);
}

/// The greatest difference from the exact plane at the triangle's corners, of what is taken.
template <Precision Wanted>
double worst_error(std::uint32_t seed, std::int32_t greatest) {
  Random random(seed);
  double worst = 0;
  for (int i = 0; i < rounds(40000); ++i) {
    const Sloped sloped(random, greatest);
    LinearFunction function{};
    if (!sloped.taken<Wanted>(function)) continue;
    const Triangle& t = sloped.triangle;
    // Steps from the pixel centre that the function counts from to each corner; ½ is added to values.
    const double start_x = (8 - (t.ax & 15)) / 16.0, start_y = (8 - (t.ay & 15)) / 16.0;
    const std::uint32_t from_a =
        function.at_origin + function.dx * small_triangle::margin - (word(sloped.values[0]) << 16) - 0x8000u;
    const double at_start = std::ldexp(static_cast<double>(signed_word(from_a)), -16);
    const double dx = std::ldexp(static_cast<double>(signed_word(function.dx)), -16),
                 dy = std::ldexp(static_cast<double>(signed_word(function.dy)), -16);
    const std::array<std::array<double, 2>, 3> corners{
        {{0, 0}, {t.dx1 / 16.0, t.dy1 / 16.0}, {t.dx2 / 16.0, t.dy2 / 16.0}}};
    for (std::size_t k = 0; k < 3; ++k) {
      const double got = at_start + (corners[k][0] - start_x) * dx + (corners[k][1] - start_y) * dy;
      worst = std::max(worst, std::fabs(got - (sloped.values[k] - sloped.values[0])));
    }
  }
  return worst;
}

TEST(SmallTriangle, DepthsAreWithinHalfAUnit) {
  const double worst = worst_error<Precision::depth>(3, 8000);
  std::printf("depth: %.3f units at most\n", worst);
  EXPECT_LE(worst, 0.5);
}

TEST(SmallTriangle, ShadesAreWithin52Units) {
  const double worst = worst_error<Precision::shade>(4, 65535);
  std::printf("shade: %.2f units at most\n", worst);
  EXPECT_LE(worst, 52);
}

}  // namespace
}  // namespace spanline::test
