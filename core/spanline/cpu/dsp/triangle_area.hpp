#pragma once
#include <cstdint>

#include "spanline/math/bits.hpp"

#if defined(__ARM_FEATURE_SIMD32)
#include <arm_acle.h>

namespace spanline::dsp {

/// Twice the signed area of a triangle. A corner is a word of two 16-bit coordinates.
[[nodiscard]] inline std::int32_t narrow_area(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  const auto from_a = [a](std::uint32_t v) { return __ssub16(signed_word(v), signed_word(a)); };
  return __smusdx(from_a(b), from_a(c));
}

}  // namespace spanline::dsp
#endif
