#pragma once
/// @file
/// Gradients of attributes over a triangle from its plane equation; compare C. Hecker, "Perspective Texture Mapping"
/// (1995).
#include <cstdint>

#include "spanline/raster/linear_function.hpp"
#include "spanline/raster/triangle.hpp"

namespace spanline {

/// The size of the picture. Linear functions are anchored inside it, so that their rounding errors are small where they
/// are visible.
struct Viewport {
  std::int32_t width = 0;   ///< pixels, 1 … 2047
  std::int32_t height = 0;  ///< pixels, 1 … 2047
};

/// Gradients of quantities over a triangle of any size and shape, as linear functions. They are anchored at the middle
/// of the visible part of the triangle's bounding box. They depend on the triangle and the viewport alone, never on
/// bands, clipping or the algorithm.
///
/// The fast method multiplies by a 32-bit reciprocal of the doubled area, with a relative error of the slope of 2^-27.
/// Where the slope is too steep for it, or the triangle larger than 512 pixels, 64-bit divisions give dx, dy and the
/// value at the anchor exactly rounded.
class Gradients {
 public:
  /// `area` is the doubled area of the triangle in square sixteenths of a pixel, positive.
  Gradients(const Triangle& triangle, std::int64_t area, Viewport viewport);

  /// The linear function through the values at a, b, c, integers of `bits` bits, with 32 − bits guard bits and ½ added.
  /// Its origin is screen column 0 of the biased row `row`.
  [[nodiscard]] LinearFunction fit(std::int32_t value_a, std::int32_t value_b, std::int32_t value_c, int bits,
                                   std::int32_t row) const;

 private:
  /// |numerator| = magnitude · 2^(32 − zeros) with magnitude in [2^31, 2^32), or 0.
  struct Normalised {
    std::uint32_t magnitude;
    int zeros;
    bool negative;
  };
  /// Computes a slope in guard units a pixel, with a few extra bits below at 24-bit depth. False if it is too steep for
  /// the reciprocal.
  [[nodiscard]] bool fast_slope(Normalised numerator, int guard_bits, std::int32_t& slope) const;
  [[nodiscard]] bool fast_slope(std::int64_t numerator, int guard_bits, std::int32_t& slope) const;
  [[nodiscard]] bool fast_slope(std::int32_t numerator, int guard_bits, std::int32_t& slope) const;

  const Triangle& triangle_;
  std::int64_t area_;          ///< twice the area, square sixteenths of a pixel
  std::uint32_t inverse_ = 0;  ///< 2^62 / (area normalised to 32 bits)
  int normalising_shift_ = 0;  ///< area·2^shift is in [2^31, 2^32); 0 where the exact divisions are used
  bool narrow_ = false;        ///< whether numerators of 16-bit values fit 32 bits
  std::int32_t anchor_x_ = 0;  ///< screen column of the anchor
  std::int32_t anchor_y_ = 0;  ///< biased row of the anchor
};

}  // namespace spanline
