#pragma once
#include <cstdint>

#if defined(__ARM_FEATURE_DSP)
namespace spanline::dsp {

/// first + (first / 2^16) · correction / 2^8 in one instruction, for |correction| < 2^23. TextureReciprocal::share
/// computes the same.
[[nodiscard]] inline std::uint32_t corrected(std::uint32_t first, std::int32_t correction) {
  std::uint32_t sum;  // the upper half of `first` times 32 bits, without the lowest 16, and `first`
  __asm__("smlawt %0, %1, %2, %2" : "=r"(sum) : "r"(correction * 256), "r"(first));
  return sum;
}

}  // namespace spanline::dsp
#endif
