#pragma once
#include <cstdint>

namespace spanline {

/// What transform_vertices knows of an instance: model space straight to screen, in 32-bit products. Sums of products
/// may wrap; they come back modulo 2^32.
struct VertexConstants {
  static constexpr int distance_bits = 29;           ///< of a distance: [1, 2^29)
  static constexpr int distance_fraction_bits = 14;  ///< of the matrix entries in `z`
  static constexpr int position_bits = 30;           ///< of focal · x
  static constexpr int dropped_bits = 15;            ///< of a position before it meets the reciprocal

  std::int32_t x[3], y[3];  ///< focal · view x and −y, units of 2^-x_shift; wraps modulo 2^32
  std::int32_t x_offset, y_offset;
  std::int32_t z[3];  ///< distance, < 2^29: entries with 14 fraction bits
  std::int32_t z_offset;
  std::int32_t shift;         ///< of (x >> 15)·reciprocal to sixteenths, at full normalisation
  std::uint32_t depth_scale;  ///< n·f/(f − n) · (2^N − 1), normalised to [2^31, 2^32)
  std::int32_t depth_shift;
  std::uint32_t depth_base;         ///< f/(f − n) · (2^N − 1) · 2^(27 − N), with the rounding half
  std::int32_t depth_fraction;      ///< 27 − N
  std::int32_t centre_x, centre_y;  ///< biased sixteenths
  std::int32_t right, bottom;       ///< biased sixteenths
  std::int32_t nearest, farthest;   ///< depths
  int depth_bits;                   ///< N
};

}  // namespace spanline
