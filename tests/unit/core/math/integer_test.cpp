// Whole-number helpers: divisions, shifts, the square root.
#include "spanline/math/integer.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "spanline/math/bits.hpp"

namespace spanline::test {
namespace {

RC_GTEST_PROP(Integer, FloorDivisionLeavesARemainderBelowTheDivisor, (std::int64_t dividend)) {
  const auto divisor = *rc::gen::inRange<std::int64_t>(1, std::numeric_limits<std::int64_t>::max());
  const FloorDivision d = floor_divide(dividend, divisor);
  RC_ASSERT(d.remainder >= 0 && d.remainder < divisor);
  RC_ASSERT(static_cast<__int128>(d.quotient) * divisor + d.remainder == dividend);
}

RC_GTEST_PROP(Integer, RoundedDivisionIsNearestWithHalvesUpwards, (std::int64_t dividend)) {
  const auto divisor = *rc::gen::inRange<std::int64_t>(1, std::int64_t{1} << 40);
  const __int128 twice_rest =
      2 * (static_cast<__int128>(dividend) - static_cast<__int128>(divide_rounded(dividend, divisor)) * divisor);
  RC_ASSERT(twice_rest >= -static_cast<__int128>(divisor) && twice_rest < divisor);
}

RC_GTEST_PROP(Integer, RoundedShiftIsRoundedDivisionByAPowerOfTwo, (std::int32_t value)) {
  const int shift = *rc::gen::inRange(0, 40);
  RC_ASSERT(shift_rounded(value, shift) == divide_rounded(value, std::int64_t{1} << shift));
  RC_ASSERT(shift_rounded(value, -shift / 2) == static_cast<std::int64_t>(value) * (std::int64_t{1} << (shift / 2)));
}

RC_GTEST_PROP(Integer, SquareRootIsTheIntegerPart, (std::uint64_t value)) {
  const auto narrow = value >> *rc::gen::inRange(0, 64);
  const auto root = static_cast<unsigned __int128>(square_root(narrow));
  RC_ASSERT(root * root <= narrow && (root + 1) * (root + 1) > narrow);
}

RC_GTEST_PROP(Integer, HighWordOfAProductIsRounded, (std::int32_t a, std::int32_t b)) {
  RC_ASSERT(multiply_high_rounded(a, b) == shift_rounded(static_cast<std::int64_t>(a) * b, 32));
}

TEST(Integer, SquareRootIsRightAroundEverySquareOfSixteenBits) {
  for (std::uint64_t r = 1; r < 65536; ++r) {
    ASSERT_EQ(square_root(r * r - 1), r - 1);
    ASSERT_EQ(square_root(r * r), r);
    ASSERT_EQ(square_root(r * r + r * 2), r);
  }
  EXPECT_EQ(square_root(0), 0U);
  EXPECT_EQ(square_root(~std::uint64_t{0}), 0xffffffffU);
}

TEST(Integer, MagnitudeHoldsTheMostNegativeNumber) {
  EXPECT_EQ(magnitude(std::numeric_limits<std::int32_t>::min()), 0x80000000U);
  EXPECT_EQ(magnitude(-5), 5U);
  EXPECT_EQ(magnitude(5), 5U);
}

}  // namespace
}  // namespace spanline::test
