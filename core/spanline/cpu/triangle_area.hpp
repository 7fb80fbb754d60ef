#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>

#include "spanline/cpu/dsp/triangle_area.hpp"
#include "spanline/cpu/form.hpp"
#include "spanline/math/bits.hpp"
#include "spanline/raster/screen_vertex.hpp"
#include "spanline/raster/signed_area.hpp"

namespace spanline {

/// A vertex's position as one word: x in the low half, y in the high half.
[[nodiscard]] inline std::uint32_t position_word(const ScreenVertex& v) {
  static_assert(std::endian::native == std::endian::little && offsetof(ScreenVertex, y) == 2);
  using Word [[gnu::may_alias]] = const std::uint32_t;
  return *reinterpret_cast<Word*>(&v);
}

/// A vertex's biased y. On cores with narrow_area it is taken from the position's word, which is in a register already.
template <Form form = Form::fastest>
[[nodiscard]] inline std::int32_t biased_y(const ScreenVertex& v) {
#if defined(__ARM_FEATURE_SIMD32) || defined(__ARM_ARCH_6M__)
  if constexpr (form == Form::fastest) return signed_word(position_word(v) >> 16);
#endif
  return v.y;
}

/// The same as signed_area, for coordinates that differ by at most 2,047 pixels.
template <Form form = Form::fastest>
[[nodiscard]] inline std::int32_t narrow_area(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c) {
#if defined(__ARM_FEATURE_SIMD32)
  if constexpr (form == Form::fastest) return dsp::narrow_area(position_word(a), position_word(b), position_word(c));
#elif defined(__ARM_ARCH_6M__)
  if constexpr (form == Form::fastest) {
    // Differences of position words are 65,536·dy + dx; they take fewer loads and addresses.
    const std::uint32_t d1 = position_word(b) - position_word(a), d2 = position_word(c) - position_word(a);
    const std::int32_t dx1 = static_cast<std::int16_t>(d1), dx2 = static_cast<std::int16_t>(d2);
    const std::int32_t dy1 = signed_word(d1 - word(dx1)) >> 16, dy2 = signed_word(d2 - word(dx2)) >> 16;
    return dx1 * dy2 - dx2 * dy1;
  }
#endif
  return signed_area<std::int32_t>(a, b, c);
}

}  // namespace spanline
