#pragma once
#include <cstdint>

#include "spanline/cpu/form.hpp"
#include "spanline/cpu/thumb2/clamp_to_bits.hpp"
#include "spanline/math/bits.hpp"

namespace spanline {

/// Clamps a signed value to [0, 2^Bits).
template <int Bits, Form form = Form::fastest>
[[nodiscard]] inline std::uint32_t clamp_to_bits(std::int32_t value) {
#if defined(__ARM_FEATURE_SAT)
  if constexpr (form == Form::fastest) return thumb2::clamp_to_bits<Bits>(value);
#endif
  constexpr std::int32_t most = (1 << Bits) - 1;
  return word(value < 0 ? 0 : value > most ? most : value);
}

}  // namespace spanline
