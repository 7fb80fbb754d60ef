#include "spanline/raster/gradients.hpp"

#include <algorithm>

#include "spanline/math/integer.hpp"
#include "spanline/math/reciprocal.hpp"

namespace spanline {
namespace {

constexpr std::int32_t largest_fast_extent = 512 * 16;  // sixteenths
/// Bits that a fast slope has below the guard bits, so that its product with the distance from vertex to anchor is
/// exact enough. With 16 guard bits none are needed.
constexpr int extra_bits_for(int guard_bits) { return guard_bits >= 16 ? 0 : 6; }

constexpr std::int32_t exact = 0;  // value of normalising_shift_ for triangles that need the exact divisions

/// Up to this extent, numerators of 16-bit values and their sums fit 32 bits.
constexpr std::int32_t largest_narrow_extent = 256 * 16;  // sixteenths

/// Floor division of a numerator, |numerator| < 2^31, by an area below 2^16, with further binary digits on request.
class ShortDivision {
 public:
  ShortDivision(std::int32_t numerator, std::uint32_t area) : area_(area) {
    const std::uint32_t size = magnitude(numerator);
    quotient_ = divide_16(size, area);
    remainder_ = size - quotient_ * area;
    if (numerator < 0) {
      quotient_ = 0u - quotient_;
      if (remainder_ != 0) {
        --quotient_;
        remainder_ = area - remainder_;
      }
    }
  }
  [[nodiscard]] std::uint32_t whole() const { return quotient_; }
  [[nodiscard]] std::uint32_t remainder() const { return remainder_; }
  /// The quotient times 2^bits, rounded to nearest, halves upwards; modulo 2^32. bits in [15, 30].
  [[nodiscard]] std::uint32_t scaled(int bits) const {
    const std::uint32_t high = remainder_ << 15, first = divide_16(high, area_);
    const std::uint32_t low = (high - first * area_) << (bits - 15), second = divide_16(low, area_);
    const std::uint32_t rest = low - second * area_;
    return (quotient_ << bits) + (first << (bits - 15)) + second + (rest >= area_ - rest ? 1 : 0);
  }

 private:
  std::uint32_t area_, quotient_, remainder_;
};

/// The middle of the pixels [low, high] after clamping both ends to the viewport's range [0, size).
std::int32_t middle(std::int32_t low, std::int32_t high, std::int32_t size) {
  const std::int32_t first = std::clamp<std::int32_t>(low, 0, size - 1);
  const std::int32_t last = std::clamp<std::int32_t>(high, 0, size - 1);
  return (first + last) >> 1;
}

}  // namespace

Gradients::Gradients(const Triangle& triangle, std::int64_t area, Viewport viewport)
    : triangle_(triangle), area_(area) {
  const std::int32_t low_x =
      triangle.dx1 < triangle.dx2 ? std::min<std::int32_t>(triangle.dx1, 0) : std::min<std::int32_t>(triangle.dx2, 0);
  const std::int32_t high_x =
      triangle.dx1 > triangle.dx2 ? std::max<std::int32_t>(triangle.dx1, 0) : std::max<std::int32_t>(triangle.dx2, 0);
  const std::int32_t high_y = std::max(triangle.dy1, triangle.dy2);
  anchor_x_ = middle(row_at(triangle.ax + low_x) - row_bias, row_at(triangle.ax + high_x) - row_bias, viewport.width);
  anchor_y_ =
      row_bias + middle(row_at(triangle.ay) - row_bias, row_at(triangle.ay + high_y) - row_bias, viewport.height);
  const std::int32_t extent = std::max(high_x - low_x, high_y);
  if (extent > largest_fast_extent) return;
  narrow_ = extent <= largest_narrow_extent;
  const auto narrow = static_cast<std::uint32_t>(area);  // at most 2^13·2^13 square sixteenths
  normalising_shift_ = leading_zeros_32(narrow);
  inverse_ = reciprocal_32(narrow << normalising_shift_);
}

inline bool Gradients::fast_slope(Normalised numerator, int guard_bits, std::int32_t& slope) const {
  // magnitude · inverse / 2^32 is |n|/area · 2^(zeros − 32 + 30 − normalising shift), but the slope is |n|/area · 2^(4
  // + guard bits + extra bits), so it must be shifted.
  const int shift = numerator.zeros - 2 - normalising_shift_ - (4 + guard_bits + extra_bits_for(guard_bits));
  // |slope| < 2^(31 − shift), with a relative error of 2^-28. With 16 guard bits every slope that fits is exact enough.
  // With 8 guard bits and the extra bits below them, the limit is 2^23 guard units a pixel.
  if (shift < (guard_bits >= 16 ? 0 : 2)) return false;
  if (shift > 31) {
    slope = 0;
    return true;
  }
  const std::uint32_t half = (1u << shift) >> 1;
  const std::uint32_t rounded = (multiply_high(numerator.magnitude, inverse_) + half) >> shift;
  slope = numerator.negative ? -signed_word(rounded) : signed_word(rounded);
  return true;
}

bool Gradients::fast_slope(std::int64_t numerator, int guard_bits, std::int32_t& slope) const {
  const auto absolute = static_cast<std::uint64_t>(numerator < 0 ? -numerator : numerator);
  const int zeros = leading_zeros_64(absolute | 1);
  return fast_slope({static_cast<std::uint32_t>((absolute << zeros) >> 32), zeros, numerator < 0}, guard_bits, slope);
}

bool Gradients::fast_slope(std::int32_t numerator, int guard_bits, std::int32_t& slope) const {
  const std::uint32_t absolute = magnitude(numerator);
  const int zeros = leading_zeros_32(absolute | 1);
  return fast_slope({absolute << zeros, zeros + 32, numerator < 0}, guard_bits, slope);
}

LinearFunction Gradients::fit(std::int32_t value_a, std::int32_t value_b, std::int32_t value_c, int bits,
                              std::int32_t row) const {
  const Triangle& t = triangle_;
  const int guard_bits = 32 - bits;
  const std::int32_t d1 = value_b - value_a;
  const std::int32_t d2 = value_c - value_a;
  LinearFunction function;
  const std::uint32_t base = (word(value_a) << guard_bits) + (1u << (guard_bits - 1));
  if ((d1 | d2) == 0) {
    return {base, 0, 0};
  }
  const bool narrow = narrow_ && bits == 16;
  std::int64_t nx, ny;
  std::int32_t fine_dx = 0, fine_dy = 0;
  bool fast;
  if (narrow) {
    const std::int32_t narrow_x = d1 * t.dy2 - d2 * t.dy1, narrow_y = d2 * t.dx1 - d1 * t.dx2;
    fast = fast_slope(narrow_x, guard_bits, fine_dx) && fast_slope(narrow_y, guard_bits, fine_dy);
    nx = narrow_x;
    ny = narrow_y;
  } else {
    nx = static_cast<std::int64_t>(d1) * t.dy2 - static_cast<std::int64_t>(d2) * t.dy1;
    ny = static_cast<std::int64_t>(d2) * t.dx1 - static_cast<std::int64_t>(d1) * t.dx2;
    fast = normalising_shift_ != exact && fast_slope(nx, guard_bits, fine_dx) && fast_slope(ny, guard_bits, fine_dy);
  }
  const std::int32_t to_anchor_x = 16 * (anchor_x_ + row_bias) + 8 - t.ax;
  const std::int32_t to_anchor_y = 16 * anchor_y_ + 8 - t.ay;
  std::uint32_t at_anchor;
  if (fast) {
    const int extra_bits = extra_bits_for(guard_bits);
    const std::int32_t half = (1 << extra_bits) >> 1;
    function.dx = word((fine_dx + half) >> extra_bits);
    function.dy = word((fine_dy + half) >> extra_bits);
    at_anchor = base + sum_of_products(fine_dx, to_anchor_x, fine_dy, to_anchor_y, 4 + extra_bits);
  } else if (narrow && area_ < 65536) {
    const auto area = static_cast<std::uint32_t>(area_);
    const ShortDivision x(static_cast<std::int32_t>(nx), area), y(static_cast<std::int32_t>(ny), area);
    function.dx = x.scaled(4 + guard_bits);
    function.dy = y.scaled(4 + guard_bits);
    const ShortDivision rest(signed_word(x.remainder()) * to_anchor_x + signed_word(y.remainder()) * to_anchor_y, area);
    const std::uint32_t whole = x.whole() * word(to_anchor_x) + y.whole() * word(to_anchor_y);
    at_anchor = base + (whole << guard_bits) + rest.scaled(guard_bits);
  } else {
    const auto slope = [&](std::int64_t n) {
      return static_cast<std::uint32_t>(
          static_cast<std::uint64_t>(divide_rounded(n * (std::int64_t{1} << (4 + guard_bits)), area_)));
    };
    function.dx = slope(nx);
    function.dy = slope(ny);
    const FloorDivision way = floor_divide(nx * to_anchor_x + ny * to_anchor_y, area_);
    const auto whole = static_cast<std::uint32_t>(static_cast<std::uint64_t>(way.quotient)) << guard_bits;
    const std::int64_t rest = divide_rounded(way.remainder * (std::int64_t{1} << guard_bits), area_);
    at_anchor = base + whole + static_cast<std::uint32_t>(rest);
  }
  function.at_origin = at_anchor - function.dx * word(anchor_x_) + function.dy * word(row - anchor_y_);
  return function;
}

}  // namespace spanline
