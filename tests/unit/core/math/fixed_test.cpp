// Fixed-point formats: conversions, rounding, products and literals.
#include "spanline/math/fixed.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <type_traits>

namespace spanline::test {
namespace {

template <class F>
double value(F f) {
  return std::ldexp(static_cast<double>(f.raw()), -F::fraction_bits);
}

/// x rounded to nearest, halves upwards.
double rounded(double x) { return std::floor(x + 0.5); }

template <class A, class B>
concept Addable = requires(A a, B b) {
  a + b;
};
template <class A, class B>
concept Comparable = requires(A a, B b) {
  a < b;
};
static_assert(!Addable<Q16_16, Q2_30> && !Comparable<Q16_16, Q12_4>, "formats do not mix");
static_assert(!std::is_convertible_v<int, Q16_16> && !std::is_constructible_v<Q16_16, int>,
              "raw integers have one door");
static_assert(sizeof(Q12_4) == 2 && sizeof(Q16_16) == 4);

static_assert((1.5_q16).raw() == 98304);
static_assert((0.0000152587890625_q16).raw() == 1);
static_assert((32767.99999_q16).raw() == 0x7fffffff);
static_assert((1'024.25_q16).raw() == 1024 * 65536 + 16384);
static_assert((7_q16).raw() == 7 * 65536);
static_assert((0.75_q24).raw() == 3 << 22);
static_assert((127.5_q24).raw() == 255 << 23);
static_assert((0.70710678118_q30).raw() == 759250125);
static_assert((-1.0_q30).raw() == -(1 << 30));

TEST(Fixed, WholeNumbersAndRatiosAreExactOrNearest) {
  EXPECT_EQ(Q16_16::from_int(-3).raw(), -3 * 65536);
  EXPECT_EQ(Q12_4::from_int(-2047).raw(), -32752);
  EXPECT_EQ(Q16_16::from_ratio(1, 3).raw(), 21845);
  EXPECT_EQ(Q16_16::from_ratio(-1, 3).raw(), -21845);
  EXPECT_EQ(Q16_16::from_ratio(2, 3).raw(), 43691);
  EXPECT_EQ(Fixed<0>::from_ratio(5, 2).raw(), 3) << "ties go away from zero";
  EXPECT_EQ(Fixed<0>::from_ratio(-5, 2).raw(), -3);
}

TEST(Fixed, FloorAndRoundAgreeWithDoubleOnEveryScreenCoordinate) {
  for (int raw = -32768; raw <= 32767; ++raw) {
    const auto x = Q12_4::from_raw(static_cast<std::int16_t>(raw));
    ASSERT_EQ(x.floor(), std::floor(value(x)));
    if (raw <= 32767 - 8) {
      ASSERT_EQ(x.round(), rounded(value(x)));
    }
  }
}

RC_GTEST_PROP(Fixed, ConversionRoundsHalvesUpwards, (std::int32_t raw)) {
  const auto x = Q16_16::from_raw(raw);
  RC_ASSERT((x.convert<Fixed<4, std::int64_t>>().raw()) == rounded(value(x) * 16));
  RC_ASSERT((x.convert<Fixed<40, std::int64_t>>().raw()) == static_cast<std::int64_t>(raw) << 24);
  RC_ASSERT((x.convert<Fixed<40, std::int64_t>>().template convert<Q16_16>()) == x);
}

RC_GTEST_PROP(Fixed, ProductsRoundToNearest, (std::int32_t a, std::int16_t b)) {
  const auto x = Q2_30::from_raw(a);
  const auto y = Q12_4::from_raw(b);
  const auto product = multiply<Fixed<20, std::int64_t>>(x, y);
  const std::int64_t exact = static_cast<std::int64_t>(a) * b;  // Q34
  RC_ASSERT(std::llabs((product.raw() << 14) - exact) <= (1 << 13));
}

RC_GTEST_PROP(Fixed, SumsAndOrderAreThoseOfTheRawNumbers, (std::int16_t a, std::int16_t b)) {
  const auto x = Q16_16::from_raw(a), y = Q16_16::from_raw(b);
  RC_ASSERT((x + y).raw() == a + b);
  RC_ASSERT((x - y).raw() == a - b);
  RC_ASSERT((-x).raw() == -a);
  RC_ASSERT((x < y) == (a < b));
  RC_ASSERT((x == y) == (a == b));
  auto sum = x;
  sum += y;
  sum -= y;
  RC_ASSERT(sum == x);
}

RC_GTEST_PROP(Fixed, RatiosAreWithinHalfAUnit, (std::int32_t numerator)) {
  const auto denominator = *rc::gen::inRange<std::int64_t>(1, std::int64_t{1} << 31);
  const auto x = Fixed<16, std::int64_t>::from_ratio(numerator, denominator);
  const double exact = std::ldexp(static_cast<double>(numerator), 16) / static_cast<double>(denominator);
  RC_ASSERT(std::fabs(static_cast<double>(x.raw()) - exact) <= 0.5 + 1e-6);
}

}  // namespace
}  // namespace spanline::test
