#pragma once
#include <array>
#include <cstdint>

namespace spanline {

/// Screen-door transparency (lecture 000): a surface of opacity n/64 is drawn opaque at n/64 of its pixels and left out
/// at the others. Patterns are fixed in screen space.
///
/// `ordered` patterns are 8 × 8 pixels, each with a different threshold in [0, 63]. A pixel is drawn if its threshold
/// is below the level, so every 8 × 8 pixels hold exactly the level's share. There are eight patterns, for surfaces
/// that overlap. The thresholds of any two are nearly independent: the share of the background that is seen through
/// both layers is (1 − α₁)(1 − α₂) to within 1/20 (tested over all pairs of levels).
///
/// `random` patterns are independent from pixel to pixel and from surface to surface, and repeatable by a seed. They
/// serve stochastic transparency, which averages several of them.
namespace stipple {

inline constexpr std::uint32_t levels = 64;  ///< the level of an opaque surface; with 0 there are 65 levels

/// The level of an opacity in [0, 255], rounded to nearest.
[[nodiscard]] constexpr std::uint32_t level_of(std::uint32_t opacity) { return (opacity * 128 + 255) / 510; }

/// An 8 × 8 pattern. The threshold at (x, y) is column[x & 7] ^ row[y & 7]: a linear map over GF(2) from the six bits
/// of the coordinates to the six bits of the threshold.
struct OrderedPattern {
  std::array<std::uint8_t, 8> column, row;
};

/// These patterns were found by search. Of 60,000 random maps, the 2,500 with the most even levels were kept: every
/// rectangle of up to 32 pixels, which may wrap around the pattern, holds its share of every level to within 3.1
/// pixels. From these a set was chosen in which the thresholds of any two patterns have a star discrepancy below 1/20.
inline constexpr std::array<OrderedPattern, 8> ordered_patterns{{
    {{12, 52, 40, 16, 59, 3, 31, 39}, {0, 62, 17, 47, 8, 54, 25, 39}},
    {{38, 23, 6, 55, 24, 41, 56, 9}, {0, 37, 26, 63, 38, 3, 60, 25}},
    {{19, 50, 1, 32, 12, 45, 30, 63}, {0, 57, 36, 29, 11, 50, 47, 22}},
    {{60, 6, 49, 11, 45, 23, 32, 26}, {0, 16, 33, 49, 15, 31, 46, 62}},
    {{39, 21, 56, 10, 47, 29, 48, 2}, {0, 41, 11, 34, 29, 52, 22, 63}},
    {{9, 63, 20, 34, 0, 54, 29, 43}, {0, 50, 39, 21, 41, 27, 14, 60}},
    {{31, 38, 35, 26, 8, 49, 52, 13}, {0, 36, 8, 44, 58, 30, 50, 22}},
    {{52, 41, 13, 16, 45, 48, 20, 9}, {0, 40, 26, 50, 19, 59, 9, 33}},
}};

/// The columns that are drawn, of 32 on row y: bit i stands for column x + i, where x is a multiple of 32.
[[nodiscard]] constexpr std::uint32_t ordered_mask(std::uint32_t surface, std::uint32_t level, std::uint32_t y) {
  const OrderedPattern& pattern = ordered_patterns[surface % ordered_patterns.size()];
  const std::uint32_t row = pattern.row[y & 7];
  std::uint32_t mask = 0;
  for (std::uint32_t x = 0; x < 8; ++x) mask |= ((pattern.column[x] ^ row) < level ? 1u : 0u) << x;
  return mask * 0x01010101u;
}

/// The threshold of one pixel, which is drawn if this is below the level. It agrees with `ordered_mask`.
[[nodiscard]] constexpr std::uint32_t ordered_threshold(std::uint32_t surface, std::uint32_t x, std::uint32_t y) {
  const OrderedPattern& pattern = ordered_patterns[surface % ordered_patterns.size()];
  return pattern.column[x & 7] ^ pattern.row[y & 7];
}

/// A hash of 32 bits, "lowbias32" (Wellons, "Prospecting for Hash Functions", 2018). It is a bijection.
[[nodiscard]] constexpr std::uint32_t scrambled(std::uint32_t word) {
  word = (word ^ word >> 16) * 0x7feb352du;
  word = (word ^ word >> 15) * 0x846ca68bu;
  return word ^ word >> 16;
}

inline constexpr std::uint32_t random_step = 0x9e3779b9u;
/// The start of the random sequence for the aligned group of 32 columns that holds x, on row y.
[[nodiscard]] constexpr std::uint32_t random_start(std::uint32_t surface, std::uint32_t x, std::uint32_t y,
                                                   std::uint32_t seed) {
  return scrambled(scrambled(seed + surface * random_step) + (y << 6 | x >> 5));
}

/// The same as ordered_mask for a random pattern: each bit is set with probability level/64. One random word is used
/// for each binary digit of the level, from the lowest up: for a digit 1, OR with the word sets half of the zeros; for
/// a digit 0, AND clears half of the ones.
[[nodiscard]] constexpr std::uint32_t random_mask(std::uint32_t surface, std::uint32_t level, std::uint32_t x,
                                                  std::uint32_t y, std::uint32_t seed) {
  if (level >= levels) return ~std::uint32_t{0};
  std::uint32_t word = random_start(surface, x, y, seed), mask = 0;
  for (std::uint32_t digit = 1; digit < levels; digit <<= 1) {
    word = scrambled(word + random_step);
    mask = (level & digit) != 0 ? mask | word : mask & word;
  }
  return mask;
}

/// The threshold in [0, 63] of one pixel, which is drawn if this is below the level. It agrees with `random_mask`: the
/// highest digit in which level and threshold differ decides, and there the pixel's bit of the random word equals the
/// level's digit.
[[nodiscard]] constexpr std::uint32_t random_threshold(std::uint32_t surface, std::uint32_t x, std::uint32_t y,
                                                       std::uint32_t seed) {
  std::uint32_t word = random_start(surface, x, y, seed), threshold = 0;
  for (std::uint32_t digit = 1; digit < levels; digit <<= 1) {
    word = scrambled(word + random_step);
    if ((word >> (x & 31) & 1) == 0) threshold |= digit;
  }
  return threshold;
}

}  // namespace stipple
}  // namespace spanline
