#pragma once
#include <array>
#include <cstdint>

#include "spanline/math/fixed.hpp"
#include "spanline/math/integer.hpp"

namespace spanline {

/// An angle in units of 2^-32 turn, so that sums wrap at 360°.
class Angle {
 public:
  constexpr Angle() = default;
  [[nodiscard]] static constexpr Angle from_raw(std::uint32_t raw) { return Angle(raw); }
  /// numerator / denominator of a full turn; |numerator| < 2^30, denominator > 0.
  [[nodiscard]] static constexpr Angle from_turns(std::int64_t numerator, std::int64_t denominator) {
    return Angle(static_cast<std::uint32_t>(divide_rounded(numerator * (std::int64_t{1} << 32), denominator)));
  }
  [[nodiscard]] static constexpr Angle from_degrees(std::int64_t degrees) { return from_turns(degrees, 360); }
  [[nodiscard]] constexpr std::uint32_t raw() const { return raw_; }
  friend constexpr Angle operator+(Angle a, Angle b) { return Angle(a.raw_ + b.raw_); }
  friend constexpr Angle operator-(Angle a, Angle b) { return Angle(a.raw_ - b.raw_); }
  friend constexpr bool operator==(Angle, Angle) = default;

 private:
  constexpr explicit Angle(std::uint32_t raw) : raw_(raw) {}
  std::uint32_t raw_ = 0;
};

namespace detail {
/// sin(x) for x in [0, π/2], both Q30, by the Taylor series up to x^15 in integers; error below 2^-29.
constexpr std::int64_t sine_by_series(std::int64_t x) {
  std::int64_t term = x;
  std::int64_t sum = x;
  const std::int64_t square = (x * x + (std::int64_t{1} << 29)) >> 30;
  for (std::int64_t n = 2; n <= 14; n += 2) {
    term = -divide_rounded((term * square) >> 30, n * (n + 1));
    sum += term;
  }
  return sum;
}

inline constexpr std::int64_t half_pi_q30 = 1686629713;  // round(π/2 · 2^30)

/// Sines of the first quadrant in 256 steps, Q30, computed at compile time in integers.
inline constexpr std::array<std::int32_t, 257> sine_table = [] {
  std::array<std::int32_t, 257> table{};
  for (int i = 0; i <= 256; ++i) {
    // Above 45° the cosine series of the complement would converge faster, but the sine series up to x^15 is exact
    // enough.
    const std::int64_t value = sine_by_series((half_pi_q30 * i + 128) / 256);
    table[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(value > (1 << 30) ? (1 << 30) : value);
  }
  return table;
}();
}  // namespace detail

/// sin(angle), error at most 2^-27 (tested). A table gives sin a and cos a at the next lower 1/256 of a quadrant, and
/// the angle-sum formula adds the rest d: sin(a + d) ≈ sin a + d·cos a − d²/2·sin a − d³/6·cos a.
[[nodiscard]] constexpr Q2_30 sine(Angle angle) {
  std::uint32_t phase = angle.raw() & 0x7fffffffu;       // within half a turn
  if (phase > 0x40000000u) phase = 0x80000000u - phase;  // mirrored into the first quadrant
  const std::uint32_t index = phase >> 22;               // 256 steps a quadrant
  const auto rest = static_cast<std::int64_t>(phase & 0x3fffffu);
  const std::int64_t sin_a = detail::sine_table[index];
  const std::int64_t cos_a = detail::sine_table[256 - index];
  const std::int64_t d = (rest * detail::half_pi_q30) >> 30;  // radians, Q30: at most 2^22.7
  const std::int64_t d_squared = (d * d) >> 30;
  std::int64_t value =
      sin_a + ((d * cos_a) >> 30) - ((d_squared * sin_a) >> 31) - ((((d_squared * d) >> 30) * cos_a / 6) >> 30);
  if (value > (std::int64_t{1} << 30)) value = std::int64_t{1} << 30;
  return Q2_30::from_raw(static_cast<std::int32_t>(angle.raw() & 0x80000000u ? -value : value));
}

/// cos(angle), error at most 2^-27.
[[nodiscard]] constexpr Q2_30 cosine(Angle angle) { return sine(angle + Angle::from_raw(0x40000000u)); }

}  // namespace spanline
