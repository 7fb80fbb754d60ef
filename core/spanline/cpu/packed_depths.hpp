#pragma once
#include <cstdint>

#include "spanline/cpu/dsp/paired_depths.hpp"
#include "spanline/cpu/form.hpp"

namespace spanline {

/// The upper halves of two plane words, one behind the other as they lie in memory.
template <Form form = Form::fastest>
[[nodiscard, gnu::always_inline]] inline std::uint32_t packed_depths(std::uint32_t left, std::uint32_t right) {
#if defined(__ARM_FEATURE_SIMD32)
  if constexpr (form == Form::fastest) return dsp::packed_depths(left, right);
#endif
  return (right & 0xffff0000) | left >> 16;
}

/// Whether writing depths of 16 bits by twos takes fewer instructions than one by one.
inline constexpr bool packing_pays =
#if defined(__ARM_FEATURE_SIMD32)
    true;
#else
    false;
#endif

}  // namespace spanline
