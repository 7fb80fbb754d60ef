// Sines and rotations against double, at their stated errors.
#include "spanline/math/trigonometry.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "spanline/math/matrix.hpp"
#include "support/effort.hpp"
#include "support/random.hpp"

namespace spanline::test {
namespace {

double radians(Angle a) { return a.raw() * 0x1p-31 * std::numbers::pi; }
double value(Q2_30 q) { return q.raw() * 0x1p-30; }

TEST(Trigonometry, SineAndCosineAreWithin2ToTheMinus27) {
  double worst = 0;
  const auto check = [&](std::uint32_t raw) {
    const Angle a = Angle::from_raw(raw);
    worst = std::max(
        {worst, std::fabs(value(sine(a)) - std::sin(radians(a))), std::fabs(value(cosine(a)) - std::cos(radians(a)))});
  };
  for (std::uint64_t raw = 0; raw < (std::uint64_t{1} << 32); raw += 2003 * stride(11))
    check(static_cast<std::uint32_t>(raw));
  for (std::uint32_t index = 0; index < 1024; ++index)  // both sides of each entry of the table
    for (std::uint32_t near : {0u, 1u, 2u, 0xffffffffu, 0xfffffffeu}) check((index << 22) + near);
  EXPECT_LE(worst, 0x1p-27);
  std::printf("sine, cosine: 2^%.2f at most\n", std::log2(worst));
}

TEST(Trigonometry, TheFourQuartersAreExact) {
  const Q2_30 one = Q2_30::from_int(1), zero{};
  EXPECT_EQ(sine(Angle::from_degrees(0)), zero);
  EXPECT_EQ(sine(Angle::from_degrees(90)), one);
  EXPECT_EQ(sine(Angle::from_degrees(180)), zero);
  EXPECT_EQ(sine(Angle::from_degrees(270)), -one);
  EXPECT_EQ(cosine(Angle::from_degrees(0)), one);
  EXPECT_EQ(cosine(Angle::from_degrees(90)), zero);
  EXPECT_EQ(cosine(Angle::from_degrees(-180)), -one);
}

RC_GTEST_PROP(Trigonometry, SineIsOddAndNeverLeavesItsRange, (std::uint32_t raw)) {
  const Angle a = Angle::from_raw(raw);
  RC_ASSERT(sine(Angle::from_raw(0u - raw)) == -sine(a));
  RC_ASSERT(std::abs(sine(a).raw()) <= 1 << 30);
}

RC_GTEST_PROP(Trigonometry, AnglesWrapAsTurnsDo, (std::int16_t degrees)) {
  RC_ASSERT(Angle::from_degrees(degrees) == Angle::from_degrees(degrees + 360));
  RC_ASSERT(Angle::from_degrees(degrees) + Angle::from_degrees(-degrees) == Angle{});
  RC_ASSERT(Angle::from_turns(degrees, 360) == Angle::from_degrees(degrees));
}

TEST(Rotations, TurnCounterClockwiseLookingAgainstTheAxis) {
  const Direction x{Q2_30::from_int(1), {}, {}}, y{{}, Q2_30::from_int(1), {}}, z{{}, {}, Q2_30::from_int(1)};
  const Angle quarter = Angle::from_degrees(90);
  EXPECT_EQ(rotation_x(quarter) * y, z);
  EXPECT_EQ(rotation_y(quarter) * z, x);
  EXPECT_EQ(rotation_z(quarter) * x, y);
}

TEST(Rotations, ProductsStayNearTheExactRotation) {
  Random random(5);
  double worst = 0;
  for (int i = 0; i < rounds(20000); ++i) {
    const Angle a = Angle::from_raw(static_cast<std::uint32_t>(random.wide(0, 0xffffffff)));
    const Angle b = Angle::from_raw(static_cast<std::uint32_t>(random.wide(0, 0xffffffff)));
    const Rotation r = rotation_x(a) * rotation_y(b);
    const double sa = std::sin(radians(a)), ca = std::cos(radians(a)), sb = std::sin(radians(b)),
                 cb = std::cos(radians(b));
    const double exact[3][3] = {{cb, 0, sb}, {sa * sb, ca, -sa * cb}, {-ca * sb, sa, ca * cb}};
    for (int row = 0; row < 3; ++row) {
      const Direction& d = r.row[row];
      worst = std::max({worst, std::fabs(value(d.x) - exact[row][0]), std::fabs(value(d.y) - exact[row][1]),
                        std::fabs(value(d.z) - exact[row][2])});
    }
    // Transposed is inverse.
    const Rotation identity = r * r.transposed();
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column) {
        const Direction d = identity.column(column);
        const double entry = value(row == 0 ? d.x : row == 1 ? d.y : d.z);
        ASSERT_NEAR(entry, row == column ? 1 : 0, 0x1p-25);
      }
  }
  EXPECT_LE(worst, 0x1p-26) << "two sines of 2^-27 each";
  std::printf("products of two rotations: 2^%.2f at most\n", std::log2(worst));
}

}  // namespace
}  // namespace spanline::test
