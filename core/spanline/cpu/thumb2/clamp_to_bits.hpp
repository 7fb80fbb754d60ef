#pragma once
#include <cstdint>

#if defined(__ARM_FEATURE_SAT)
#include <arm_acle.h>

namespace spanline::thumb2 {

/// Clamps a signed value to [0, 2^Bits) in one instruction.
template <int Bits>
[[nodiscard]] inline std::uint32_t clamp_to_bits(std::int32_t value) {
  return __usat(value, Bits);
}

}  // namespace spanline::thumb2
#endif
