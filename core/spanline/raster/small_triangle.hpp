#pragma once
#include <array>
#include <cstdint>

#include "spanline/math/reciprocal.hpp"
#include "spanline/raster/fixed_edges.hpp"
#include "spanline/raster/linear_function.hpp"
#include "spanline/raster/triangle.hpp"

namespace spanline {

/// Triangles up to 20 × 16 pixels. On a small display most triangles of a model are of this class, so they have their
/// own set-up with 32-bit products, reciprocals from tables and no division.
namespace small_triangle {

inline constexpr std::int32_t reach = 160;       ///< greatest |dx| from the top vertex, sixteenths
inline constexpr std::int32_t max_height = 255;  ///< greatest dy, sixteenths
inline constexpr int fraction_bits = 26;         ///< of the columns of edges
/// Columns between the column of origin and the top vertex's pixel, so that the whole triangle lies to the right of the
/// origin.
inline constexpr std::int32_t margin = 11;

/// Whether the extent is within the limits. The class also requires a doubled area below 2^16.
[[nodiscard]] inline bool fits(const Triangle& t) {
  return word(t.dx1 + reach) <= 2 * reach && word(t.dx2 + reach) <= 2 * reach && word(t.dy1 | t.dy2) <= max_height;
}

/// The screen column where the columns of edges and functions are 0, for a topmost vertex at the biased `top_x`.
[[nodiscard]] inline std::int32_t origin_of(std::int32_t top_x) { return (top_x >> 4) - row_bias - margin; }
[[nodiscard]] inline std::int32_t origin_of(const Triangle& t) { return origin_of(t.ax); }

/// round(2^26 / d), for slopes without division.
inline constexpr std::array<std::uint32_t, max_height + 1> reciprocal_q26 = [] {
  std::array<std::uint32_t, max_height + 1> table{};
  for (std::uint32_t d = 1; d <= max_height; ++d) table[d] = ((1u << 26) + d / 2) / d;
  return table;
}();

/// How exact a linear function must be. For depth, slopes are below 1,024 units a pixel and the error is below 0.5
/// units over the triangle. For shades, slopes are below 16,384 units a pixel and the error is below 52 units of
/// 1/65,536; vertex shades stay 64 units away from the ends of their range.
enum class Precision : std::uint8_t { depth, shade };

/// Gradients of 16-bit quantities over a small triangle, with 16 guard bits, by the 16-bit reciprocal of its area.
///
/// The relative error of the reciprocal is at most 1.8·10^-5, and slopes are rounded to multiples of 2^shift guard
/// units.
class Gradients {
 public:
  /// `area` is the doubled area, in [1, 65535], of the triangle that is passed to `fit`.
  explicit Gradients(std::uint32_t area)
      : shift_(leading_zeros_16(area)), inverse_(signed_word(reciprocal_16(area << shift_))) {}

  /// Computes the linear function through the values at a, b, c, in [0, 65535], with ½ added, on the triangle's first
  /// row; `row_offset` is as for set_edges. The column of origin lies `margin` columns to the left of a's pixel. False
  /// if the triangle is too thin or the slope too steep for this precision; then the wide set-up is needed.
  template <Precision Wanted>
  [[nodiscard, gnu::always_inline]] inline bool fit(const Triangle& t, std::int32_t value_a, std::int32_t value_b,
                                                    std::int32_t value_c, std::int32_t row_offset,
                                                    LinearFunction& function) const {
    // A unit of the products below is 2^shift guard units a pixel. For thin triangles this is exact enough only if they
    // are short as well.
    constexpr int never_too_coarse = Wanted == Precision::depth ? 9 : 16;
    if (shift_ > never_too_coarse) {
      const std::uint32_t extent = word(t.dy1 | t.dy2 | (t.dx1 ^ (t.dx1 >> 31)) | (t.dx2 ^ (t.dx2 >> 31)));
      if (extent << shift_ >= 1u << 17) return false;
    }
    const std::int32_t d1 = value_b - value_a;
    const std::int32_t d2 = value_c - value_a;
    // The slope is 2^20·n/area a pixel in Q16.16 (a pixel has 16 sixteenths). With inverse = 2^31/(area·2^shift), the
    // products are this slope without its factor 2^shift.
    const std::int32_t dx = scaled(d1 * t.dy2, d2 * t.dy1);
    const std::int32_t dy = scaled(t.dx1 * d2, t.dx2 * d1);
    if ((magnitude(dx) + magnitude(dy)) >> ((Wanted == Precision::depth ? 26 : 30) - shift_) != 0) return false;
    function.dx = word(dx) << shift_;
    function.dy = word(dy) << shift_;
    const std::int32_t to_centre_x = 8 - (t.ax & 15);
    // The change of the value from the vertex to the centre of its pixel on the first row. The exact product would
    // overflow for the slopes of shades, which do not need its last bits.
    const std::int32_t way =
        Wanted == Precision::depth
            ? signed_word(function.dx * word(to_centre_x) + function.dy * word(row_offset)) >> 4
            : (signed_word(function.dx) >> 4) * to_centre_x + (signed_word(function.dy) >> 4) * row_offset;
    function.at_origin = (word(value_a) << 16) + 0x8000u - function.dx * margin + word(way);
    return true;
  }

 private:
  /// 32·(p − q)·inverse / 2^16 rounded, |p − q| < 2^25: by the high word of one long product, or by two products of 32
  /// bits on ARMv6-M.
  [[nodiscard]] std::int32_t scaled(std::int32_t p, std::int32_t q) const {
#if defined(__ARM_ARCH_6M__)
    const std::int32_t n = (p - q) * 32;
    return (n >> 16) * inverse_ + signed_word((((word(n) & 0xffffu) * word(inverse_) >> 15) + 1) >> 1);
#else
    // Both factors are negative, since 2^15·inverse may be 2^31.
    return multiply_high_rounded((q - p) * 64, inverse_ * -32768);
#endif
  }

  int shift_;             ///< leading zeros of the area within 16 bits
  std::int32_t inverse_;  ///< 2^31 / (area · 2^shift_), in [32768, 65536]
};

/// The column of a point that lies `from_origin` sixteenths of a pixel to the right of the column of origin.
///
/// On a row, an edge is a multiple of 1/(16·dy) pixel away from a pixel centre, which is 0 or at least 2^-12. Slope and
/// start together are within 2^-13.4 over 16 rows. The start is lowered by 2^-13, so that the integer part is always
/// that of the exact edge (tested).
[[nodiscard, gnu::always_inline]] inline std::uint32_t start_of_edge(std::uint32_t from_origin) {
  return (from_origin << 22) + ((8u << 22) - (1u << 13));
}
/// The edge that goes `dx` to the right over `dy` rows from `start`, on the row whose centre lies `offset` below there;
/// all in sixteenths of a pixel.
[[nodiscard, gnu::always_inline]] inline FixedEdge edge_from(std::uint32_t start, std::int32_t dx, std::int32_t dy,
                                                             std::int32_t offset) {
  const std::uint32_t inverse = reciprocal_q26[word(dy)];
  return {start + word(offset * dx) * (inverse >> 4), word(dx) * inverse};  // offset/16 rows of slope dx·2^26/dy
}

/// Sets up the two edges from the top vertex and the third edge of a triangle that `fits`. `row_offset` is the distance
/// from a down to the centre of the first row, `third_offset` that from the start of the third edge down to the centre
/// of its first row, both in sixteenths of a pixel.
[[gnu::always_inline]] inline void set_edges(const Triangle& t, const ThirdEdge& third, std::int32_t row_offset,
                                             std::int32_t third_offset, FixedEdges& edges) {
  const std::uint32_t start = start_of_edge(word(t.ax & 15)) + (word(16 * margin) << 22);
  const FixedEdge left = edge_from(start, t.dx2, t.dy2, row_offset);
  edges.left_step = left.step;
  edges.left = left.column;
  const FixedEdge right = edge_from(start, t.dx1, t.dy1, row_offset);
  edges.right_step = right.step;
  edges.right = right.column;
  const FixedEdge replacing = edge_from(start + (word(third.x) << 22), third.dx, third.dy, third_offset);
  edges.third_step = replacing.step;
  edges.third = replacing.column;
}

}  // namespace small_triangle
}  // namespace spanline
