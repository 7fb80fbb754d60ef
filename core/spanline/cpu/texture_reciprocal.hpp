#pragma once
#include <array>
#include <cstdint>

#include "spanline/cpu/dsp/reciprocal_correction.hpp"
#include "spanline/cpu/form.hpp"
#include "spanline/math/bits.hpp"

namespace spanline {

namespace detail {
/// 2^31 / d, 9 bits, at the middle of each of 256 intervals of d in [2^22, 2^23).
inline constexpr std::array<std::uint16_t, 256> texture_reciprocal_seed = [] {
  std::array<std::uint16_t, 256> table{};
  for (std::uint32_t i = 0; i < 256; ++i) {
    const std::uint32_t doubled_middle = 2 * (256 + i) + 1;
    table[i] = static_cast<std::uint16_t>(((1u << 19) + doubled_middle) / (2 * doubled_middle));
  }
  return table;
}();
}  // namespace detail

/// The division for a perspective texture: 1/w as a 9-bit seed with a first-order correction. It uses only 32-bit
/// products, which are one instruction on every core. All words are normalised: shifted left together until bit 31 of w
/// is set.
struct TextureReciprocal {
  std::uint32_t seed;       ///< 2^40 / w with a relative error of at most 2^-8.4
  std::int32_t correction;  ///< 1 − seed · w, plus the mean of the second-order term; Q24

  [[nodiscard]] static TextureReciprocal of(std::uint32_t w) {
    constexpr std::int32_t mean_square = 16;
    const std::uint32_t seed = detail::texture_reciprocal_seed[(w >> 23) & 255];
    return {seed, mean_square - (signed_word((w >> 9) * seed << 1) >> 8)};
  }
  /// part/w in Q30 for part in [0, w], with a relative error of at most 2^-17 and another 2^-20 (tested).
  template <Form form = Form::fastest>
  [[nodiscard]] std::uint32_t share(std::uint32_t part) const {
    const std::uint32_t first = (part >> 10) * seed;
#if defined(__ARM_FEATURE_DSP)
    if constexpr (form == Form::fastest) return dsp::corrected(first, correction);
#endif
    return first + word((signed_word(first >> 16) * correction) >> 8);
  }
  /// How far the parabola that approximates the hyperbola deviates from the chord at its middle, as a share of the
  /// distance between the ends, Q16. w has fallen by `fall` · 2^16, at most a quarter, to its present value w. The
  /// deviation is (w − w0) / (2 (w0 + w)), that is share/4 · (1 + share/2 + …) where share is the relative difference
  /// in w. The error is at most a thousandth of the distance.
  [[nodiscard]] std::int32_t bow(std::int32_t fall) const {
    const std::int32_t share = fall * signed_word(seed) >> 8;
    return (share - (share * share >> 17)) >> 2;
  }
};

}  // namespace spanline
