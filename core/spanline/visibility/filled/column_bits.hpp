#pragma once
#include <cstdint>

#include "spanline/math/bits.hpp"

namespace spanline {

/// Sets of columns as bits, 32 columns a word. The first column is the most significant bit, so that counting leading
/// zeros finds the first one of a set.
namespace column_bits {

inline constexpr std::int32_t columns_a_word = 32;

[[nodiscard]] constexpr std::int32_t word_of(std::int32_t column) { return column >> 5; }
/// The columns of a word from `column` on, [0, 31] modulo 32.
[[nodiscard]] constexpr std::uint32_t from(std::int32_t column) { return ~std::uint32_t{0} >> (column & 31); }
/// The columns of a word up to `column`, which is one of them.
[[nodiscard]] constexpr std::uint32_t up_to(std::int32_t column) {
  return word(signed_word(0x80000000u) >> (column & 31));
}

/// The columns [first, end) of a word, not empty.
[[nodiscard]] constexpr std::uint32_t between(std::int32_t first, std::int32_t end) {
  return (~std::uint32_t{0} >> first) & word(signed_word(0x80000000u) >> (end - 1));
}

/// Calls use(first, end) for each run of set bits in a word whose first column is `column`. A run that was open at the
/// word's start begins at `open`, or −1 if there is none. Output: the start of a run that is open at the word's end,
/// or −1.
template <class Use>
[[gnu::always_inline]] inline std::int32_t for_each_run(std::uint32_t bits, std::int32_t column, std::int32_t open,
                                                        Use use) {
  if (bits == ~std::uint32_t{0}) return open >= 0 ? open : column;
  std::int32_t at = 0;
  if (open >= 0) {
    const int ones = leading_zeros_32(~bits);
    use(open, column + ones);
    bits <<= ones;
    at = ones;
  }
  while (bits != 0) {
    const int zeros = leading_zeros_32(bits);
    bits <<= zeros;
    at += zeros;
    const int ones = leading_zeros_32(~bits);
    if (at + ones == columns_a_word) return column + at;
    use(column + at, column + at + ones);
    bits <<= ones;
    at += ones;
  }
  return -1;
}

}  // namespace column_bits
}  // namespace spanline
