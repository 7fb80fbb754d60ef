// Vectors: normalising at any scale, products of unit vectors.
#include "spanline/math/vector.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/effort.hpp"
#include "support/random.hpp"

namespace spanline::test {
namespace {

double value(Q2_30 q) { return q.raw() * 0x1p-30; }

TEST(Vectors, NormalisedComponentsAreWithin2ToTheMinus28AtAnyScale) {
  Random random(9);
  double worst = 0;
  for (int i = 0; i < rounds(400000); ++i) {
    std::int64_t v[3];
    const int scale = random.between(0, 62);
    for (std::int64_t& c : v)
      c = random.wide(-(std::int64_t{1} << 62), std::int64_t{1} << 62) >>
          (62 - std::max(0, scale - random.between(0, 8)));
    if (v[0] == 0 && v[1] == 0 && v[2] == 0) continue;
    const long double x = static_cast<long double>(v[0]), y = static_cast<long double>(v[1]),
                      z = static_cast<long double>(v[2]);
    const long double length = std::sqrt(x * x + y * y + z * z);
    const Direction d = normalise(v[0], v[1], v[2]);
    const auto off = [length](Q2_30 got, long double wanted) {
      return static_cast<double>(std::fabs(static_cast<long double>(value(got)) - wanted / length));
    };
    const double error = std::max({off(d.x, x), off(d.y, y), off(d.z, z)});
    ASSERT_LE(error, 0x1p-28) << v[0] << ", " << v[1] << ", " << v[2];
    worst = std::max(worst, error);
  }
  std::printf("normalise: 2^%.2f at most\n", std::log2(worst));
}

TEST(Vectors, NormalisingZeroGivesZero) { EXPECT_EQ(normalise(0, 0, 0), Direction{}); }

RC_GTEST_PROP(Vectors, NormalisingDoesNotDependOnAPowerOfTwo, (std::int16_t x, std::int16_t y, std::int16_t z)) {
  const int shift = *rc::gen::inRange(0, 46);
  const auto scaled = [shift](std::int64_t v) { return v * (std::int64_t{1} << shift); };
  RC_ASSERT(normalise(x, y, z) == normalise(scaled(x), scaled(y), scaled(z)));
}

RC_GTEST_PROP(Vectors, CrossProductsOfUnitVectorsAreExactToRounding,
              (std::int16_t ax, std::int16_t ay, std::int16_t az, std::int16_t bx, std::int16_t by, std::int16_t bz)) {
  const Direction a = normalise(ax, ay, az), b = normalise(bx, by, bz), c = cross(a, b);
  RC_ASSERT(std::fabs(value(c.x) - (value(a.y) * value(b.z) - value(a.z) * value(b.y))) <= 0x1p-28);
  RC_ASSERT(std::fabs(value(c.y) - (value(a.z) * value(b.x) - value(a.x) * value(b.z))) <= 0x1p-28);
  RC_ASSERT(std::fabs(value(c.z) - (value(a.x) * value(b.y) - value(a.y) * value(b.x))) <= 0x1p-28);
  RC_ASSERT(std::fabs(value(dot(a, b)) -
                      (value(a.x) * value(b.x) + value(a.y) * value(b.y) + value(a.z) * value(b.z))) <= 0x1p-28);
}

RC_GTEST_PROP(Vectors, DirectionsBetweenPositionsPointFromOneToTheOther,
              (std::int32_t x, std::int32_t y, std::int32_t z)) {
  const Position from{Q16_16::from_raw(x), Q16_16::from_raw(y), Q16_16::from_raw(z)};
  const Position to{Q16_16::from_raw(~x), Q16_16::from_raw(-(y / 2)), Q16_16::from_raw(z)};
  const Direction d = direction_between(from, to);
  RC_ASSERT((d.x.raw() > 0) == (static_cast<std::int64_t>(~x) > x) || d.x.raw() == 0);
  RC_ASSERT(d.z.raw() == 0);
}

}  // namespace
}  // namespace spanline::test
