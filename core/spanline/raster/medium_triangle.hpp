#pragma once
#include <algorithm>
#include <cstdint>

#include "spanline/math/reciprocal.hpp"
#include "spanline/raster/fixed_edges.hpp"
#include "spanline/raster/triangle.hpp"

namespace spanline {

/// Triangles up to 200 × 128 pixels whose edges are not too flat: the same fixed-point rows as small ones, with slopes
/// of 24 fraction bits.
namespace medium_triangle {

inline constexpr std::int32_t max_width = 200 * 16;   ///< sixteenths
inline constexpr std::int32_t max_height = 128 * 16;  ///< sixteenths
inline constexpr std::int32_t flattest = 127;         ///< pixels a row: a slope must fit Q8.24
inline constexpr int fraction_bits = 24;

/// dx·2^24/dy by a 16-bit reciprocal and one residual digit: at most 5 units below the true slope over dy/16 rows
/// together. |dx| ≤ max_width, dy in [1, max_height], |dx| < flattest·dy.
[[nodiscard]] inline std::int32_t slope(std::int32_t dx, std::int32_t dy) {
  const int shift = leading_zeros_16(word(dy));
  const std::int32_t inverse = signed_word(reciprocal_16(word(dy) << shift));  // 2^(31 − shift) / dy
  const std::int32_t product = dx * inverse;
  const std::int32_t first = shift <= 7 ? product >> (7 - shift) : product * (1 << (shift - 7));
  const std::int32_t rest = signed_word((word(dx) << 24) - word(first) * word(dy));
  return first + (((rest >> 6) * inverse) >> (25 - shift));
}

/// Whether the class takes the triangle: its extent, and every edge's slope.
[[nodiscard]] inline bool fits(const Triangle& t) {
  const std::int32_t low = std::min<std::int32_t>(0, std::min(t.dx1, t.dx2)),
                     high = std::max<std::int32_t>(0, std::max(t.dx1, t.dx2));
  if (high - low > max_width || std::max(t.dy1, t.dy2) > max_height) return false;
  const auto steep = [](std::int32_t dx, std::int32_t dy) {
    return dy == 0 || signed_word(magnitude(dx)) < flattest * signed_word(magnitude(dy));
  };
  return steep(t.dx1, t.dy1) && steep(t.dx2, t.dy2) && steep(t.dx2 - t.dx1, t.dy2 - t.dy1);
}

/// The column that a medium triangle's columns count from (biased): one left of its leftmost pixel.
[[nodiscard]] inline std::int32_t origin_of(const Triangle& t) {
  return row_at(t.ax + std::min<std::int32_t>(0, std::min(t.dx1, t.dx2))) - 1;
}

/// The edges of a triangle that fits, whose columns count from `origin`. `row_offset` and `third_offset` as for small
/// triangles.
///
/// An edge crosses a pixel centre at multiples of 1/(16·dy) pixel, at least 512 units; slope and start are at most 140
/// units low over 128 rows; the start is lowered by 256, so that the integer part is that of the exact edge (tested).
inline void set_edges(const Triangle& t, const ThirdEdge& third, std::int32_t origin, std::int32_t row_offset,
                      std::int32_t third_offset, FixedEdges& edges) {
  const std::uint32_t start = (word(t.ax - 16 * origin + 8) << 20) - 256;
  const auto moved_down = [](std::int32_t offset, std::int32_t step) {
    return word(offset * (step >> 4) + ((offset * (step & 15)) >> 4));
  };
  if (t.dy2 != 0) {
    const std::int32_t step = slope(t.dx2, t.dy2);
    edges.left = start + moved_down(row_offset, step);
    edges.left_step = word(step);
  }
  if (t.dy1 != 0) {
    const std::int32_t step = slope(t.dx1, t.dy1);
    edges.right = start + moved_down(row_offset, step);
    edges.right_step = word(step);
  }
  if (third.dy == 0) return;
  const std::int32_t step = slope(third.dx, third.dy);
  edges.third = start + (word(third.x) << 20) + moved_down(third_offset, step);
  edges.third_step = word(step);
}

}  // namespace medium_triangle
}  // namespace spanline
