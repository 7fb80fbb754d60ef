#pragma once
#include <algorithm>
#include <cstdint>

#include "spanline/raster/gradients.hpp"
#include "spanline/raster/polygon_table.hpp"
#include "spanline/raster/screen_vertex.hpp"

namespace spanline {

/// Calls visit(vertex) for each corner of an entry of the polygon table.
template <class Visit>
[[gnu::always_inline]] inline void for_each_corner(const PolygonEntry& entry, Visit visit) {
  if (entry.is_outline()) [[unlikely]] {
    const PlacedOutline outline = entry.outline();
    for (unsigned i = 0; i < outline.corners.count(); ++i) visit(outline.corners[i]);
    return;
  }
  const PolygonCorners corners = entry.corners();
  for (unsigned i = 0; i < 3; ++i) visit(*corners.corner[i]);
}

/// How far a polygon may extend: the pixels between its outermost corners, cut to the viewport, and the depth words of
/// its nearest and farthest corner. Columns [first_column, end_column), rows [first_row, end_row), not biased.
struct ScreenExtent {
  std::int32_t first_column, end_column, first_row, end_row;
  std::uint32_t nearest, farthest;  ///< without outcodes

  [[nodiscard]] bool empty() const { return first_column >= end_column || first_row >= end_row; }

  [[nodiscard, gnu::always_inline]] static inline ScreenExtent of(const PolygonEntry& entry, Viewport viewport) {
    std::int32_t left = ScreenVertex::bias * 2, top = left, right = 0, bottom = 0;
    std::uint32_t nearest = ~std::uint32_t{0}, farthest = 0;
    for_each_corner(
        entry, [&](const ScreenVertex& corner) __attribute__((always_inline)) {
          const std::int32_t x = corner.x, y = corner.y;
          const std::uint32_t depth = corner.depth_word;
          left = x < left ? x : left;
          right = x > right ? x : right;
          top = y < top ? y : top;
          bottom = y > bottom ? y : bottom;
          nearest = depth < nearest ? depth : nearest;
          farthest = depth > farthest ? depth : farthest;
        });
    const auto cut = [](std::int32_t biased, std::int32_t size) {
      const std::int32_t pixel = row_at(biased) - row_bias;
      return pixel < 0 ? 0 : pixel > size ? size : pixel;
    };
    constexpr std::uint32_t outcodes = 0xff;
    return {cut(left, viewport.width),    cut(right, viewport.width), cut(top, viewport.height),
            cut(bottom, viewport.height), nearest & ~outcodes,        farthest & ~outcodes};
  }
};

}  // namespace spanline
