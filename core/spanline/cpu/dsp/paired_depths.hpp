#pragma once
#include <cstddef>
#include <cstdint>

#include "spanline/math/bits.hpp"

#if defined(__ARM_FEATURE_SIMD32)
#include <arm_acle.h>

namespace spanline::dsp {

/// Packs the upper halves of two plane words into one word, in the order of their pixels in memory.
[[gnu::always_inline]] inline std::uint32_t packed_depths(std::uint32_t left, std::uint32_t right) {
  std::uint32_t pair;
  __asm__("pkhtb %0, %1, %2, asr #16" : "=r"(pair) : "r"(right), "r"(left));
  return pair;
}

/// Draws pixels of one value against 16-bit depths, smaller is nearer, in groups of eight while at least eight are
/// left. USUB16 compares two depths at once and SEL selects the nearer of each. `depth` is word-aligned. Output: the
/// arguments are advanced to the first pixel not drawn.
template <class Word, class Pixel>
[[gnu::always_inline]] inline void paired_depths(Word*& depth, Pixel*& pixels, std::uint32_t& count, std::uint32_t& z,
                                                 std::uint32_t dz, Pixel pixel) {
  static_assert(sizeof(Word) == 2 && sizeof(Pixel) == 2);
  const std::uint32_t both_pixels = pixel * 0x10001u;
  std::uint32_t z_right = z + dz;
  const std::uint32_t two = 2 * dz;
  const auto pair = [&](std::size_t i) __attribute__((always_inline)) {
    std::uint32_t kept;
    const std::uint32_t candidates = packed_depths(z, z_right);
    __builtin_memcpy(&kept, depth + 2 * i, 4);
    __usub16(candidates, kept);  // sets GE where candidate >= kept
    const std::uint32_t nearest = __sel(kept, candidates);
    if (nearest != kept) {
      std::uint32_t old_pixels;
      __builtin_memcpy(&old_pixels, pixels + 2 * i, 4);
      const std::uint32_t new_pixels = __sel(old_pixels, both_pixels);
      __builtin_memcpy(depth + 2 * i, &nearest, 4);
      __builtin_memcpy(pixels + 2 * i, &new_pixels, 4);
    }
    z += two;
    z_right += two;
  };
  for (; count >= 8; count -= 8) {
#pragma GCC unroll 4
    for (std::size_t i = 0; i < 4; ++i) pair(i);
    depth += 8;
    pixels += 8;
  }
}

}  // namespace spanline::dsp
#endif
