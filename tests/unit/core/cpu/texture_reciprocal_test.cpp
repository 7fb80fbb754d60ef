// The division of perspective textures: within its stated error, and right on the average.
#include "spanline/cpu/texture_reciprocal.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/effort.hpp"
#include "support/random.hpp"

namespace spanline::test {
namespace {

TEST(TextureReciprocal, SharesAreWithinTheirStatedError) {
  Random random(1);
  for (int i = 0; i < rounds(1000000); ++i) {
    const auto w = static_cast<std::uint32_t>(random.wide(1LL << 31, (1LL << 32) - 1)),
               part = static_cast<std::uint32_t>(random.wide(0, w));
    const double exact = static_cast<double>(part) / w;
    const double got = std::ldexp(static_cast<double>(TextureReciprocal::of(w).share(part)), -30);
    ASSERT_LE(std::fabs(got - exact), exact * 0x1p-17 + 0x1p-20) << part << " / " << w;
  }
}

// The square of the seed's error is left out, which makes every share too small: its mean is put back, so that textures
// do not creep to one side.
TEST(TextureReciprocal, SharesAreNeitherTooGreatNorTooSmallOnTheAverage) {
  double sum = 0;
  constexpr std::uint32_t step = 1u << 12;
  std::uint32_t w = 1u << 31;
  int count = 0;
  for (; w >= 1u << 31; w += step, ++count)
    sum += std::ldexp(static_cast<double>(TextureReciprocal::of(w).share(w & ~1023u)), -30) / (w & ~1023u) * w - 1;
  const double mean = sum / count;
  std::printf("2^%.2f of the share on the average\n", std::log2(std::fabs(mean)));
  EXPECT_LT(std::fabs(mean), 0x1p-20 * 0.6);
}

}  // namespace
}  // namespace spanline::test
