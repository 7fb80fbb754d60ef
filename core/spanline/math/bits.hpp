#pragma once
#include <array>
#include <bit>
#include <cstdint>

namespace spanline {

namespace detail {
/// Leading zeros of a byte, for cores without CLZ (ARMv6-M). The entry for 0 is not used.
inline constexpr std::array<std::uint8_t, 256> leading_zeros_of_byte = [] {
  std::array<std::uint8_t, 256> table{};
  for (unsigned i = 0; i < 256; ++i)
    table[i] = static_cast<std::uint8_t>(std::countl_zero(static_cast<std::uint8_t>(i | (i == 0))));
  return table;
}();
}  // namespace detail

/// Leading zeros of `value`, a 16-bit number in [1, 65535], counted within 16 bits: 0 … 15.
[[nodiscard]] constexpr int leading_zeros_16(std::uint32_t value) {
#if defined(__ARM_ARCH_6M__)
  return value >= 256 ? detail::leading_zeros_of_byte[value >> 8] : 8 + detail::leading_zeros_of_byte[value];
#else
  return std::countl_zero(value) - 16;
#endif
}

/// Leading zeros of `value` in [1, 2^32 − 1]: 0 … 31.
[[nodiscard]] constexpr int leading_zeros_32(std::uint32_t value) {
#if defined(__ARM_ARCH_6M__)
  return value >= 65536 ? leading_zeros_16(value >> 16) : 16 + leading_zeros_16(value);
#else
  return std::countl_zero(value);
#endif
}

/// Leading zeros of `value` in [1, 2^64 − 1]: 0 … 63.
[[nodiscard]] constexpr int leading_zeros_64(std::uint64_t value) {
  const auto high = static_cast<std::uint32_t>(value >> 32);
  return high != 0 ? leading_zeros_32(high) : 32 + leading_zeros_32(static_cast<std::uint32_t>(value));
}

/// The high word of the 64-bit product a·b. This is one instruction on cores with a long multiply. ARMv6-M has none,
/// and takes four 16-bit products instead.
[[nodiscard]] constexpr std::uint32_t multiply_high(std::uint32_t a, std::uint32_t b) {
#if defined(__ARM_ARCH_6M__)
  const std::uint32_t a_low = a & 0xffff, a_high = a >> 16, b_low = b & 0xffff, b_high = b >> 16;
  const std::uint32_t low = a_low * b_low;
  const std::uint32_t middle = a_high * b_low + (low >> 16);
  const std::uint32_t cross = a_low * b_high + (middle & 0xffff);
  return a_high * b_high + (middle >> 16) + (cross >> 16);
#else
  return static_cast<std::uint32_t>((static_cast<std::uint64_t>(a) * b) >> 32);
#endif
}

/// The high word of the signed product a·b, rounded to nearest.
[[nodiscard]] inline std::int32_t multiply_high_rounded(std::int32_t a, std::int32_t b) {
#if defined(__ARM_FEATURE_DSP)
  std::int32_t high;
  __asm__("smmulr %0, %1, %2" : "=r"(high) : "r"(a), "r"(b));
  return high;
#else
  return static_cast<std::int32_t>((static_cast<std::int64_t>(a) * b + 0x80000000) >> 32);
#endif
}

/// value / 2^bits, rounded to nearest, halves upwards; |value| < 2^31 − 2^(bits − 1). Both forms give the same result.
/// The first needs no large constant, which would cost ARMv6-M extra instructions.
[[nodiscard]] constexpr std::int32_t shift_right_rounded(std::int32_t value, int bits) {
#if defined(__ARM_ARCH_6M__)
  return ((value >> (bits - 1)) + 1) >> 1;
#else
  return (value + (1 << (bits - 1))) >> bits;
#endif
}

/// |value| as an unsigned number, also correct for −2^31.
[[nodiscard]] constexpr std::uint32_t magnitude(std::int32_t value) {
  return value < 0 ? 0u - static_cast<std::uint32_t>(value) : static_cast<std::uint32_t>(value);
}

/// Conversions between signed and unsigned words, for arithmetic modulo 2^32. The renderer's linear functions of (x, y)
/// may overflow outside their polygon; modulo 2^32 they still return to the exact values inside.
[[nodiscard]] constexpr std::uint32_t word(std::int32_t value) { return static_cast<std::uint32_t>(value); }
[[nodiscard]] constexpr std::int32_t signed_word(std::uint32_t value) { return static_cast<std::int32_t>(value); }

/// value / 255, rounded to nearest, for values in [0, 255²].
[[nodiscard]] constexpr std::int32_t in_255ths(std::int32_t value) { return ((value + 127) * 0x8081) >> 23; }

/// (a·x + b·y) / 2^bits, rounded down, modulo 2^32; |x|, |y| ≤ 2^17, bits in [0, 10]. ARMv6-M has no long product and
/// multiplies the integer part and the fraction of a and b separately.
[[nodiscard]] constexpr std::uint32_t sum_of_products(std::int32_t a, std::int32_t x, std::int32_t b, std::int32_t y,
                                                      int bits) {
#if defined(__ARM_ARCH_6M__)
  const std::int32_t mask = (1 << bits) - 1;
  const std::int32_t rest = (a & mask) * x + (b & mask) * y;
  return word(a >> bits) * word(x) + word(b >> bits) * word(y) + word(rest >> bits);
#else
  const std::int64_t sum = static_cast<std::int64_t>(a) * x + static_cast<std::int64_t>(b) * y;
  return static_cast<std::uint32_t>(static_cast<std::uint64_t>(sum >> bits));
#endif
}

}  // namespace spanline
