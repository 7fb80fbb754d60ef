#pragma once
/// @file
/// Reciprocals by a table and Newton's method, x ← x + x·(1 − d·x), for cores whose division is slow or missing.
#include <array>
#include <cstdint>

#include "spanline/math/bits.hpp"

namespace spanline {

namespace detail {
/// 2^31 / d for d in [2^15, 2^16), at the middles of 128 intervals. The index is d / 256, so the lower half of the
/// table is unused; this saves a subtraction.
inline constexpr std::array<std::uint16_t, 256> reciprocal_seed = [] {
  std::array<std::uint16_t, 256> table{};
  for (std::uint32_t i = 128; i < 256; ++i) {
    const std::uint32_t middle = i * 256 + 128;
    const std::uint32_t value = (0x80000000u + middle / 2) / middle;
    table[i] = static_cast<std::uint16_t>(value > 65535 ? 65535 : value);
  }
  return table;
}();
}  // namespace detail

/// ≈ 2^31 / divisor for a normalised divisor in [2^15, 2^16): a table of 128 entries and one Newton step. The result is
/// in [32768, 65536]; its error is at most 1 unit and relatively at most 1.8·10^-5 (tested over every divisor).
[[nodiscard]] constexpr std::uint32_t reciprocal_16(std::uint32_t divisor) {
  const std::uint32_t seed = detail::reciprocal_seed[divisor >> 8];
#if defined(__ARM_ARCH_6M__)
  // This form avoids large constants, which take two instructions each on ARMv6-M. Doubling the product shifts its top
  // bit out, which leaves twice the error as a signed number.
  const std::int32_t error = signed_word(0u - (divisor * seed << 1)) >> 9;
#else
  const std::int32_t error = signed_word(0x80000000u - divisor * seed) >> 8;
#endif
  return seed + word(shift_right_rounded(error * signed_word(seed), 23));
}

/// ≈ 2^62 / divisor for a normalised divisor in [2^31, 2^32): a 16-bit reciprocal, then a Newton step to 32 bits.
/// The result is in [2^30, 2^31]; relative error at most 2^-27 (tested).
[[nodiscard]] constexpr std::uint32_t reciprocal_32(std::uint32_t divisor) {
  const std::uint32_t seed = reciprocal_16(divisor >> 16) << 15;                       // 2^62 / divisor, 15 good bits
  const std::int32_t error = signed_word(0x40000000u - multiply_high(divisor, seed));  // 2^30 (1 − divisor·seed / 2^62)
  // seed + seed·error / 2^30. Since |error| < 2^17, the factors can be shortened to fit a 32-bit product without loss
  // of a significant bit.
  return seed + word((signed_word(seed >> 16) * (error >> 1)) >> 13);
}

/// dividend / divisor, rounded down exactly, for dividend < 2^31 and divisor in [1, 65535]. Cores without a divide
/// instruction multiply by the reciprocal and correct the last unit of the quotient.
[[nodiscard]] constexpr std::uint32_t divide_16(std::uint32_t dividend, std::uint32_t divisor) {
#if defined(__ARM_ARCH_6M__)
  const int shift = leading_zeros_16(divisor);
  const std::uint32_t inverse = reciprocal_16(divisor << shift);
  std::uint32_t quotient = ((dividend >> 16) * inverse + (((dividend & 0xffff) * inverse) >> 16)) >> (15 - shift);
  std::int32_t remainder = signed_word(dividend - quotient * divisor);
  while (remainder < 0) {
    remainder += signed_word(divisor);
    --quotient;
  }
  while (remainder >= signed_word(divisor)) {
    remainder -= signed_word(divisor);
    ++quotient;
  }
  return quotient;
#else
  return dividend / divisor;
#endif
}

}  // namespace spanline
