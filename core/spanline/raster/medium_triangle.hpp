#pragma once
#include <algorithm>
#include <cstdint>

#include "spanline/math/reciprocal.hpp"
#include "spanline/raster/fixed_edges.hpp"
#include "spanline/raster/triangle.hpp"

namespace spanline {

/// Triangles up to 200 × 128 pixels whose edges are not too flat. Their rows are drawn in fixed point like those of
/// small triangles, with 24 fraction bits.
namespace medium_triangle {

inline constexpr std::int32_t max_width = 200 * 16;   ///< sixteenths
inline constexpr std::int32_t max_height = 128 * 16;  ///< sixteenths
inline constexpr std::int32_t flattest = 127;         ///< pixels a row; a slope must fit Q8.24
inline constexpr int fraction_bits = 24;

/// dx·2^24/dy by a 16-bit reciprocal and one correction by the residual. The result is below the true value, by at most
/// 5 units after dy/16 rows. |dx| ≤ max_width, dy in [1, max_height], |dx| < flattest·dy.
[[nodiscard]] inline std::int32_t slope(std::int32_t dx, std::int32_t dy) {
  const int shift = leading_zeros_16(word(dy));
  const std::int32_t inverse = signed_word(reciprocal_16(word(dy) << shift));  // 2^(31 − shift) / dy
  const std::int32_t product = dx * inverse;
  const std::int32_t first = shift <= 7 ? product >> (7 - shift) : product * (1 << (shift - 7));
  const std::int32_t rest = signed_word((word(dx) << 24) - word(first) * word(dy));
  return first + (((rest >> 6) * inverse) >> (25 - shift));
}

/// Whether an edge is steep enough for this class.
[[nodiscard]] inline bool steep(std::int32_t dx, std::int32_t dy) {
  return dy == 0 || signed_word(magnitude(dx)) < flattest * signed_word(magnitude(dy));
}
/// Whether the triangle is in this class, by its extent and the slopes of its edges.
[[nodiscard]] inline bool fits(const Triangle& t) {
  const std::int32_t low = std::min<std::int32_t>(0, std::min(t.dx1, t.dx2)),
                     high = std::max<std::int32_t>(0, std::max(t.dx1, t.dx2));
  if (high - low > max_width || std::max(t.dy1, t.dy2) > max_height) return false;
  return steep(t.dx1, t.dy1) && steep(t.dx2, t.dy2) && steep(t.dx2 - t.dx1, t.dy2 - t.dy1);
}

/// The column of origin of a medium triangle, biased: one column to the left of its leftmost pixel.
[[nodiscard]] inline std::int32_t origin_of(std::int32_t leftmost_x) { return row_at(leftmost_x) - 1; }
[[nodiscard]] inline std::int32_t origin_of(const Triangle& t) {
  return origin_of(t.ax + std::min<std::int32_t>(0, std::min(t.dx1, t.dx2)));
}

/// The column of a point that lies `from_origin` sixteenths of a pixel to the right of the column of origin.
///
/// On a row, an edge is a multiple of 1/(16·dy) pixel away from a pixel centre, which is 0 or at least 512 units. Slope
/// and start are at most 140 units too low over 128 rows. The start is lowered by 256 units, so that the integer part
/// is always that of the exact edge (tested).
[[nodiscard, gnu::always_inline]] inline std::uint32_t start_of_edge(std::int32_t from_origin) {
  return (word(from_origin + 8) << 20) - 256;
}
/// The edge that goes `dx` to the right over `dy` rows from `start`, on the row whose centre lies `offset` below there;
/// all in sixteenths of a pixel, dy > 0.
[[nodiscard, gnu::always_inline]] inline FixedEdge edge_from(std::uint32_t start, std::int32_t dx, std::int32_t dy,
                                                             std::int32_t offset) {
  const std::int32_t step = slope(dx, dy);
  return {start + word(offset * (step >> 4) + ((offset * (step & 15)) >> 4)), word(step)};
}

/// Sets up the edges of a triangle that fits, with the column of origin `origin`. `row_offset` and `third_offset` are
/// as for small triangles.
inline void set_edges(const Triangle& t, const ThirdEdge& third, std::int32_t origin, std::int32_t row_offset,
                      std::int32_t third_offset, FixedEdges& edges) {
  const std::uint32_t start = start_of_edge(t.ax - 16 * origin);
  if (t.dy2 != 0) {
    const FixedEdge left = edge_from(start, t.dx2, t.dy2, row_offset);
    edges.left = left.column;
    edges.left_step = left.step;
  }
  if (t.dy1 != 0) {
    const FixedEdge right = edge_from(start, t.dx1, t.dy1, row_offset);
    edges.right = right.column;
    edges.right_step = right.step;
  }
  if (third.dy == 0) return;
  const FixedEdge replacing = edge_from(start + (word(third.x) << 20), third.dx, third.dy, third_offset);
  edges.third = replacing.column;
  edges.third_step = replacing.step;
}

}  // namespace medium_triangle
}  // namespace spanline
