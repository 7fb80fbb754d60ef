#include "spanline/cpu/clamp_to_bits.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace spanline::test {
namespace {

template <Form form>
void expect_clamped() {
  EXPECT_EQ((clamp_to_bits<8, form>(-1)), 0U);
  EXPECT_EQ((clamp_to_bits<8, form>(std::numeric_limits<std::int32_t>::min())), 0U);
  EXPECT_EQ((clamp_to_bits<8, form>(0)), 0U);
  EXPECT_EQ((clamp_to_bits<8, form>(255)), 255U);
  EXPECT_EQ((clamp_to_bits<8, form>(256)), 255U);
  EXPECT_EQ((clamp_to_bits<28, form>(std::numeric_limits<std::int32_t>::max())), (1U << 28) - 1);
}

TEST(ClampToBits, StaysInItsRange) {
  expect_clamped<Form::portable>();
  expect_clamped<Form::fastest>();
}

}  // namespace
}  // namespace spanline::test
