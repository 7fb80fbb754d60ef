#pragma once
#include <bit>
#include <cstdint>

namespace spanline {

/// A quotient rounded towards minus infinity, and its remainder in [0, divisor).
struct FloorDivision {
  std::int64_t quotient;
  std::int64_t remainder;
};

/// Floor division of 64-bit integers; divisor > 0.
[[nodiscard]] constexpr FloorDivision floor_divide(std::int64_t dividend, std::int64_t divisor) {
  std::int64_t quotient = dividend / divisor;
  std::int64_t remainder = dividend - quotient * divisor;
  if (remainder < 0) {
    --quotient;
    remainder += divisor;
  }
  return {quotient, remainder};
}

/// dividend / divisor rounded to nearest, halves upwards; divisor > 0.
[[nodiscard]] constexpr std::int64_t divide_rounded(std::int64_t dividend, std::int64_t divisor) {
  const FloorDivision division = floor_divide(dividend, divisor);
  return division.quotient + (division.remainder >= divisor - division.remainder ? 1 : 0);
}

/// value / 2^shift rounded to nearest, halves upwards; shift in [0, 62], or negative to multiply by 2^−shift.
[[nodiscard]] constexpr std::int64_t shift_rounded(std::int64_t value, int shift) {
  if (shift <= 0) return value * (std::int64_t{1} << -shift);
  return (value + (std::int64_t{1} << (shift - 1))) >> shift;
}

/// The integer part of √value, computed one base-4 digit at a time (Woo's abacus method) in at most 32 steps, without
/// division.
[[nodiscard]] constexpr std::uint32_t square_root(std::uint64_t value) {
  if (value == 0) return 0;
  std::uint64_t bit = std::uint64_t{1} << ((63 - std::countl_zero(value)) & ~1);
  std::uint64_t root = 0;
  for (; bit != 0; bit >>= 2) {
    if (value >= root + bit) {
      value -= root + bit;
      root = (root >> 1) + bit;
    } else {
      root >>= 1;
    }
  }
  return static_cast<std::uint32_t>(root);
}

}  // namespace spanline
