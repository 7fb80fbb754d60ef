// The checks of reciprocals and bit counts, for whichever code path the including file has chosen. Included twice: once
// as the host compiles the headers, once with the path of cores without CLZ, long multiply and divide (ARMv6-M).
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>

#include "spanline/math/reciprocal.hpp"
#include "support/effort.hpp"
#include "support/random.hpp"

namespace spanline::test {
namespace {

TEST(SPANLINE_RECIPROCAL_SUITE, LeadingZerosAreRightForEveryShortNumber) {
  for (std::uint32_t v = 1; v < 65536; ++v) {
    ASSERT_EQ(leading_zeros_16(v), std::countl_zero(static_cast<std::uint16_t>(v)));
    ASSERT_EQ(leading_zeros_32(v << 13 | (v >> 3)), std::countl_zero(v << 13 | (v >> 3)));
    const std::uint64_t wide = static_cast<std::uint64_t>(v) * v * v * v;
    ASSERT_EQ(leading_zeros_64(wide | 1), std::countl_zero(wide | 1));
  }
}

TEST(SPANLINE_RECIPROCAL_SUITE, HighProductsAreExact) {
  Random random(1);
  const auto exact = [](std::uint32_t a, std::uint32_t b) {
    return static_cast<std::uint32_t>((static_cast<std::uint64_t>(a) * b) >> 32);
  };
  for (const std::uint32_t a : {0u, 1u, 0xffffu, 0x10000u, 0x7fffffffu, 0x80000000u, 0xffff0000u, 0xffffffffu})
    for (const std::uint32_t b : {0u, 1u, 0xffffu, 0x10000u, 0x7fffffffu, 0x80000000u, 0xffff0000u, 0xffffffffu})
      ASSERT_EQ(multiply_high(a, b), exact(a, b)) << a << " * " << b;
  for (int i = 0; i < rounds(1000000); ++i) {
    const auto a = static_cast<std::uint32_t>(random.wide(0, 0xffffffff)),
               b = static_cast<std::uint32_t>(random.wide(0, 0xffffffff));
    ASSERT_EQ(multiply_high(a, b), exact(a, b)) << a << " * " << b;
  }
}

TEST(SPANLINE_RECIPROCAL_SUITE, SumsOfProductsAreRoundedDown) {
  Random random(3);
  for (int i = 0; i < rounds(1000000); ++i) {
    const auto a = static_cast<std::int32_t>(random.wide(-0x80000000LL, 0x7fffffff)),
               b = static_cast<std::int32_t>(random.wide(-0x80000000LL, 0x7fffffff));
    const std::int32_t x = random.between(-131072, 131072), y = random.between(-131072, 131072);
    const int bits = random.between(0, 10);
    const std::int64_t exact = (std::int64_t{a} * x + std::int64_t{b} * y) >> bits;
    ASSERT_EQ(sum_of_products(a, x, b, y, bits), static_cast<std::uint32_t>(static_cast<std::uint64_t>(exact)))
        << a << " * " << x << " + " << b << " * " << y << " over 2^" << bits;
  }
}

TEST(SPANLINE_RECIPROCAL_SUITE, ShortReciprocalsAreWithinTwoUnitsForEveryDivisor) {
  double worst = 0;
  for (std::uint32_t d = 32768; d < 65536; ++d) {
    const std::uint32_t r = reciprocal_16(d);
    ASSERT_GE(r, 32767U) << d;
    ASSERT_LT(r, 65536U) << d;
    worst = std::max(worst, std::fabs(r - 0x1p31 / d));
  }
  EXPECT_LE(worst, 2.0);
  std::printf("reciprocal_16: %.4f units at most\n", worst);
}

TEST(SPANLINE_RECIPROCAL_SUITE, LongReciprocalsAreWithinTheirRelativeError) {
  Random random(2);
  double worst = 0;
  const auto check = [&](std::uint32_t d) {
    const std::uint32_t r = reciprocal_32(d);
    ASSERT_GE(r, 1u << 30) << d;
    ASSERT_LE(r, 1u << 31) << d;
    worst = std::max(worst, std::fabs(r * static_cast<double>(d) / 0x1p62 - 1));
  };
  for (std::uint32_t high = 32768; high < 65536; ++high) {
    check(high << 16);
    check(high << 16 | 0xffff);
    for (int i = 0; i < rounds(16); ++i) check(high << 16 | static_cast<std::uint32_t>(random.between(0, 0xffff)));
    if (HasFatalFailure()) return;
  }
  EXPECT_LE(worst, 0x1p-27);
  std::printf("reciprocal_32: relative error 2^%.2f at most\n", std::log2(worst));
}

TEST(SPANLINE_RECIPROCAL_SUITE, ShortDivisionsAreExact) {
  Random random(3);
  for (std::uint32_t d = 1; d < 65536; d += stride(5)) {
    const std::uint32_t largest = 0x7fffffffu, multiple = largest / d * d;
    for (const std::uint32_t n : {0u, 1u, d - 1, d, d + 1, 65535u, 65536u, multiple - 1, multiple, largest})
      ASSERT_EQ(divide_16(n, d), n / d) << n << " / " << d;
    for (int i = 0; i < 16; ++i) {
      const auto n = static_cast<std::uint32_t>(random.between(0, 0x7fffffff)) >> random.between(0, 30);
      ASSERT_EQ(divide_16(n, d), n / d) << n << " / " << d;
    }
  }
}

TEST(SPANLINE_RECIPROCAL_SUITE, RoundedShiftsAreRoundedDivisions) {
  Random random(4);
  for (int bits = 1; bits < 31; ++bits)
    for (int i = 0; i < 1000; ++i) {
      const auto value = static_cast<std::int32_t>(random.between(-(1 << 30), 1 << 30));
      ASSERT_EQ(shift_right_rounded(value, bits), (std::int64_t{value} + (std::int64_t{1} << (bits - 1))) >> bits);
    }
}

}  // namespace
}  // namespace spanline::test
