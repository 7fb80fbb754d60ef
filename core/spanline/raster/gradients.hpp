#pragma once
#include <cstdint>

#include "spanline/raster/linear_function.hpp"
#include "spanline/raster/triangle.hpp"

namespace spanline {

/// The size of the picture: polygons of any size take their anchor inside it, so that rounding stays small where it
/// shows.
struct Viewport {
  std::int32_t width = 0;   ///< pixels, 1 … 2047
  std::int32_t height = 0;  ///< pixels, 1 … 2047
};

/// Gradients of quantities over a triangle of any size and shape, as linear functions anchored at the middle of what
/// the viewport shows of it. They depend on the triangle and the viewport alone, never on bands, scissors or
/// algorithms.
///
/// Two ways lead to them. The fast one divides by a 32-bit reciprocal of the doubled area and is good to 2^-27 of the
/// slope. Where the slope is too steep for that, or the triangle larger than 512 pixels, 64-bit divisions round dx, dy
/// and the value at the anchor exactly.
class Gradients {
 public:
  /// A triangle with positive doubled area.
  Gradients(const Triangle& triangle, std::int64_t area, Viewport viewport);

  /// The linear function through the values at a, b, c (`bits`-bit integers), with 32 − bits guard bits and ½ added,
  /// for column 0 of biased row `row`; columns are screen columns.
  [[nodiscard]] LinearFunction fit(std::int32_t value_a, std::int32_t value_b, std::int32_t value_c, int bits,
                                   std::int32_t row) const;

 private:
  /// |numerator| = magnitude · 2^(32 − zeros) with magnitude in [2^31, 2^32), or 0.
  struct Normalised {
    std::uint32_t magnitude;
    int zeros;
    bool negative;
  };
  /// A slope in guard units a pixel, with a few more bits at 24-bit depth; false if it is too steep for the reciprocal.
  [[nodiscard]] bool fast_slope(Normalised numerator, int guard_bits, std::int32_t& slope) const;
  [[nodiscard]] bool fast_slope(std::int64_t numerator, int guard_bits, std::int32_t& slope) const;
  [[nodiscard]] bool fast_slope(std::int32_t numerator, int guard_bits, std::int32_t& slope) const;

  const Triangle& triangle_;
  std::int64_t area_;
  std::uint32_t inverse_ = 0;  ///< 2^62 / (area normalised to 32 bits)
  int normalising_shift_ = 0;  ///< area·2^shift is in [2^31, 2^32)
  bool narrow_ = false;        ///< small enough for 32-bit numerators of 16-bit values
  std::int32_t anchor_x_ = 0;  ///< column of the anchor (screen)
  std::int32_t anchor_y_ = 0;  ///< row of the anchor (biased)
};

}  // namespace spanline
