#pragma once
#include <cstdint>

namespace spanline {

/// The constants by which transform_vertices takes an instance's vertices from model space to the screen with 32-bit
/// products. Sums of products may overflow on the way; the result is exact modulo 2^32.
struct VertexConstants {
  static constexpr int distance_bits = 29;           ///< bits of a distance, [1, 2^29)
  static constexpr int distance_fraction_bits = 14;  ///< fraction bits of the matrix entries in `z`
  static constexpr int position_bits = 30;           ///< bits of focal · x
  static constexpr int dropped_bits = 15;  ///< low bits that a position loses before it is multiplied by the reciprocal

  std::int32_t x[3], y[3];  ///< matrix rows for focal · view x and −y, units of 2^-x_shift; sums modulo 2^32
  std::int32_t x_offset, y_offset;
  std::int32_t z[3];  ///< matrix row for the distance, 14 fraction bits; the distance is below 2^29
  std::int32_t z_offset;
  std::int32_t shift;         ///< right shift from (x >> 15)·reciprocal to sixteenths, for a normalised distance
  std::uint32_t depth_scale;  ///< n·f/(f − n) · (2^N − 1), normalised to [2^31, 2^32)
  std::int32_t depth_shift;
  std::uint32_t depth_base;         ///< f/(f − n) · (2^N − 1) · 2^(27 − N), plus ½ for rounding
  std::int32_t depth_fraction;      ///< 27 − N
  std::int32_t centre_x, centre_y;  ///< biased sixteenths
  std::int32_t right, bottom;       ///< biased sixteenths
  std::int32_t nearest, farthest;   ///< depths
  int depth_bits;                   ///< N
};

}  // namespace spanline
