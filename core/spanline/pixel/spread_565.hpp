#pragma once
#include <cstdint>

namespace spanline {

/// An RGB565 word spread so that there is room between its channels: green in bits 26…21, red in 15…11, blue in 4…0. In
/// a product with a number up to 32 the channels do not overlap, and each stands five bits higher.
namespace spread_565 {

inline constexpr std::uint32_t mask = 0x07e0f81f;

[[nodiscard]] constexpr std::uint32_t from(std::uint32_t rgb565) { return (rgb565 | rgb565 << 16) & mask; }
[[nodiscard]] constexpr std::uint32_t joined(std::uint32_t spread) { return (spread | spread >> 16) & 0xffff; }
/// A colour scaled by `level`/32.
[[nodiscard]] constexpr std::uint32_t lit(std::uint32_t spread, std::uint32_t level) {
  return ((spread * level) >> 5) & mask;
}
/// Linear interpolation: `level`/32 of `above` and (32 − level)/32 of `below`.
[[nodiscard]] constexpr std::uint32_t mixed(std::uint32_t below, std::uint32_t above, std::uint32_t level) {
  return ((below * (32 - level) + above * level) >> 5) & mask;
}

}  // namespace spread_565
}  // namespace spanline
