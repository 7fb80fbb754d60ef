#pragma once
#include <cstdint>

#include "spanline/raster/half_plane.hpp"
#include "spanline/raster/outline.hpp"
#include "spanline/raster/outline_header.hpp"
#include "spanline/raster/row_columns.hpp"

namespace spanline {

/// The diagonals from corner 0 that divide an outline into the triangles of its fan. Each is a line whose value at the
/// centres of pixels is not negative beyond the diagonal, and on it where the fill rule gives its pixels to the
/// triangle beyond. So every pixel of the outline belongs to the triangle whose number is that of the diagonals that
/// hold it. An outline that clipping has made is divided by the lines of the polygon's own diagonals.
struct FanDiagonals {
  static constexpr unsigned most = Outline::most_corners - 3;

  HalfPlane diagonal[most];
  unsigned count = 0;

  FanDiagonals() = default;
  explicit FanDiagonals(const PlacedOutline& placed) {
    if (placed.lines != 0) {
      for (; count < placed.lines; ++count) diagonal[count] = placed.line(count);
      return;
    }
    const Outline& outline = placed.corners;
    const bool clockwise = placed.header.clockwise();
    const std::int32_t x0 = outline[0].x_sixteenths(), y0 = outline[0].y_sixteenths();
    for (unsigned i = 2; i + 1 < outline.count(); ++i) {
      // The value is that of the edge function from corner 0 to corner i for a clockwise outline, and else of its
      // reverse: dx·(16y + 8 − y0) − dy·(16x + 8 − x0). Its slopes are multiples of 16, so the rest may be rounded
      // down.
      const std::int32_t sign = clockwise ? 1 : -1;
      const std::int32_t dx = sign * (outline[i].x_sixteenths() - x0), dy = sign * (outline[i].y_sixteenths() - y0);
      const bool keeps_its_pixels = dy < 0 || (dy == 0 && dx > 0);
      const std::int64_t rest = std::int64_t{dx} * (8 - y0) - std::int64_t{dy} * (8 - x0) - (keeps_its_pixels ? 0 : 1);
      diagonal[count++] = {-dy, dx, static_cast<std::int32_t>(rest >> 4)};
    }
  }

  /// The number, in the fan, of the triangle that a pixel of the outline belongs to.
  [[nodiscard]] unsigned triangle_at(std::int32_t column, std::int32_t row) const {
    unsigned number = 0;
    for (unsigned i = 0; i < count; ++i) number += diagonal[i].holds(column, row) ? 1U : 0U;
    return number;
  }
  /// Calls use(number, columns) for each triangle of the fan that has some of an outline's columns on a row. The
  /// columns lie in the picture.
  template <class Use>
  void for_each_part(RowColumns columns, std::int32_t row, Use use) const {
    for (unsigned i = 0; i <= count; ++i) {
      RowColumns part = columns;
      if (i > 0) part = diagonal[i - 1].cut(part, row, true);
      if (i < count) part = diagonal[i].cut(part, row, false);
      if (part.first < part.end) use(i, part);
    }
  }
};

}  // namespace spanline
