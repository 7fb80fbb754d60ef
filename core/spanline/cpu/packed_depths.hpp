#pragma once
#include <cstdint>

#include "spanline/cpu/dsp/paired_depths.hpp"
#include "spanline/cpu/form.hpp"

namespace spanline {

/// Packs the upper halves of two plane words into one word, in the order of their pixels in memory.
template <Form form = Form::fastest>
[[nodiscard, gnu::always_inline]] inline std::uint32_t packed_depths(std::uint32_t left, std::uint32_t right) {
#if defined(__ARM_FEATURE_SIMD32)
  if constexpr (form == Form::fastest) return dsp::packed_depths(left, right);
#endif
  return (right & 0xffff0000) | left >> 16;
}

/// Whether writing two 16-bit depths at a time takes fewer instructions than writing them one by one.
inline constexpr bool packing_pays =
#if defined(__ARM_FEATURE_SIMD32)
    true;
#else
    false;
#endif

}  // namespace spanline
