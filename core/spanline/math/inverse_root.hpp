#pragma once
/// @file
/// The inverse square root by a table and Newton's method, x ← x + x·(1 − a·x²) / 2.
#include <array>
#include <cstdint>

#include "spanline/math/bits.hpp"
#include "spanline/math/integer.hpp"
#include "spanline/math/vector.hpp"

namespace spanline {

namespace detail {
/// 2^15 / √m for m in [1, 4), at the middles of 96 intervals of 1/32 each.
inline constexpr std::array<std::uint16_t, 96> inverse_root_seed = [] {
  std::array<std::uint16_t, 96> table{};
  // 2^15 / √((2i + 65) / 64) = √(2^36 / (2i + 65))
  for (std::uint32_t i = 0; i < 96; ++i)
    table[i] = static_cast<std::uint16_t>(square_root((std::uint64_t{1} << 36) / (2 * i + 65)));
  return table;
}();
}  // namespace detail

/// ≈ 2^46 / √value for a value in [2^30, 2^32): a table of 96 entries and two Newton steps. The result is in [2^30,
/// 2^31]; its relative error is at most 2^-26 (tested).
[[nodiscard]] constexpr std::uint32_t inverse_root_32(std::uint32_t value) {
  std::uint32_t root = std::uint32_t{detail::inverse_root_seed[(value >> 25) - 32]} << 16;
  for (int step = 0; step < 2; ++step) {
    // The relative error of root² is 1 − value·root²/2^92, here in Q28; that of the root is half of it.
    const std::int32_t error = (1 << 28) - signed_word(multiply_high(multiply_high(root, root), value));
    root += word(static_cast<std::int32_t>((static_cast<std::int64_t>(root) * error) >> 29));
  }
  return root;
}

/// A vector as a direction and a length.
struct DirectedLength {
  Direction direction{};     ///< unit vector, error at most 2^-25 in each component; (0, 0, 0) for the zero vector
  std::uint64_t square = 0;  ///< square of the length, in units of 2^(2·exponent), below 2^62
  int exponent = 0;          ///< binary exponent of the unit of length
};

/// The direction and length of the vector (x, y, z), |component| < 2^62. This takes no division, so it is cheaper and
/// less exact than `normalise`.
[[nodiscard]] constexpr DirectedLength direction_and_length(std::int64_t x, std::int64_t y, std::int64_t z) {
  const auto absolute = [](std::int64_t v) { return static_cast<std::uint64_t>(v < 0 ? -v : v); };
  const std::uint64_t greatest = absolute(x) | absolute(y) | absolute(z);
  if (greatest == 0) return {};
  DirectedLength result;
  result.exponent = 34 - leading_zeros_64(greatest);  // the greatest component gets 30 bits
  const auto scaled = [&](std::int64_t v) {
    return result.exponent >= 0 ? v >> result.exponent : v * (std::int64_t{1} << -result.exponent);
  };
  x = scaled(x);
  y = scaled(y);
  z = scaled(z);
  result.square = static_cast<std::uint64_t>(x * x + y * y + z * z);  // [2^58, 2^62)
  const int shift = result.square >> 60 != 0 ? 30 : 28;
  const auto inverse = static_cast<std::int64_t>(inverse_root_32(static_cast<std::uint32_t>(result.square >> shift)));
  // The root of square / 2^shift is the length / 2^(shift / 2).
  const int places = 46 - 30 + shift / 2;
  const auto component = [&](std::int64_t v) {
    return Q2_30::from_raw(static_cast<std::int32_t>((v * inverse + (std::int64_t{1} << (places - 1))) >> places));
  };
  result.direction = {component(x), component(y), component(z)};
  return result;
}

}  // namespace spanline
