#pragma once
#include <array>
#include <cstdint>

namespace spanline {

/// Screen-door transparency (lecture 000): a surface of opacity n/64 is drawn at n/64 of its pixels, opaque there, and
/// left out at the others. Patterns are fixed in screen space.
///
/// `ordered` patterns are 8 × 8 pixels with a threshold in [0, 63] each, all different: a pixel is there if its
/// threshold is below the level, so that every 8 × 8 pixels hold exactly the level's share. There are eight, for
/// surfaces that lie over one another: of any two, thresholds are as good as independent (below), and through both
/// layers (1 − α₁)(1 − α₂) of what lies behind is seen, within 1/20 (tested over all pairs of levels).
///
/// `random` patterns are independent from pixel to pixel and from surface to surface, repeatable by a seed: for
/// stochastic transparency, which averages several of them.
namespace stipple {

inline constexpr std::uint32_t levels = 64;  ///< the level of an opaque surface; 65 with 0

/// An opacity of [0, 255] as a level, rounded to nearest.
[[nodiscard]] constexpr std::uint32_t level_of(std::uint32_t opacity) { return (opacity * 128 + 255) / 510; }

/// An 8 × 8 pattern: the threshold at (x, y) is column[x & 7] ^ row[y & 7], a linear map over GF(2) of the coordinates'
/// six bits on the threshold's.
struct OrderedPattern {
  std::array<std::uint8_t, 8> column, row;
};

/// Found by search: of 60,000 random maps the 2,500 whose levels are spread most evenly (each rectangle of up to 32
/// pixels, torus-wise, holds its share of every level within 3.1 pixels), and among them a set of which each two
/// thresholds have a star discrepancy below 1/20.
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

/// Which of 32 columns are there: bit i for column x + i, x a multiple of 32; any row y.
[[nodiscard]] constexpr std::uint32_t ordered_mask(std::uint32_t surface, std::uint32_t level, std::uint32_t y) {
  const OrderedPattern& pattern = ordered_patterns[surface % ordered_patterns.size()];
  const std::uint32_t row = pattern.row[y & 7];
  std::uint32_t mask = 0;
  for (std::uint32_t x = 0; x < 8; ++x) mask |= ((pattern.column[x] ^ row) < level ? 1u : 0u) << x;
  return mask * 0x01010101u;
}

/// The threshold of one pixel, below the level where it is there: `ordered_mask` one by one.
[[nodiscard]] constexpr std::uint32_t ordered_threshold(std::uint32_t surface, std::uint32_t x, std::uint32_t y) {
  const OrderedPattern& pattern = ordered_patterns[surface % ordered_patterns.size()];
  return pattern.column[x & 7] ^ pattern.row[y & 7];
}

/// A word whose bits look random, by "lowbias32" (Wellons, "Prospecting for Hash Functions", 2018): a bijection of 32
/// bits.
[[nodiscard]] constexpr std::uint32_t scrambled(std::uint32_t word) {
  word = (word ^ word >> 16) * 0x7feb352du;
  word = (word ^ word >> 15) * 0x846ca68bu;
  return word ^ word >> 16;
}

inline constexpr std::uint32_t random_step = 0x9e3779b9u;
/// Of the 32 columns around x on row y.
[[nodiscard]] constexpr std::uint32_t random_start(std::uint32_t surface, std::uint32_t x, std::uint32_t y,
                                                   std::uint32_t seed) {
  return scrambled(scrambled(seed + surface * random_step) + (y << 6 | x >> 5));
}

/// As ordered_mask, each bit set with probability level/64: six random words, one a binary digit of the level, from the
/// lowest up; OR with a word makes half of the zeros ones, AND half of the ones zeros.
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

/// The threshold in [0, 63] of one pixel, below the level where it is there: `random_mask` one by one. The last digit
/// in which level and threshold differ decides, and there the pixel's bit of the random word is the level's.
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
