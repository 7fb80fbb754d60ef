#pragma once
/// @file
/// Exact edges by an integer DDA with a remainder, after J. Bresenham, "Algorithm for Computer Control of a Digital
/// Plotter" (1965), and C. Hecker, "Perspective Texture Mapping" (1995), who starts it at pixel centres by floor
/// division.
#include <cstdint>

#include "spanline/math/integer.hpp"
#include "spanline/math/reciprocal.hpp"
#include "spanline/raster/screen_vertex.hpp"

namespace spanline {

/// An edge that is stepped down row by row. `x` is the first pixel whose centre lies on or to the right of the edge. A
/// left edge begins a run with that pixel, a right edge ends it before that pixel. This is the top-left rule, exact for
/// every slope.
///
/// At row j, with s = 16j + 8 − y0, the edge is at X = x0 + s·dx/dy sixteenths, and x = ⌈(X − 8) / 16⌉. With the floor
/// division dx = q·dy + r this is ⌊((x0 + 8 + s·q)·dy + s·r − 1) / (16·dy)⌋. A step to the next row adds q to x and r
/// to the running remainder.
struct Edge {
  std::int32_t x;          ///< first pixel of the row; biased if the coordinates of the end points are
  std::int32_t step;       ///< q, the slope in pixels a row, rounded down
  std::int32_t error;      ///< running remainder − dy: [−dy, 0)
  std::int32_t remainder;  ///< r in [0, dy): the rest of the slope, in pixels/dy a row
  std::int32_t height;     ///< dy, sixteenths of a pixel

  /// The edge from (x0, y0) down to (x1, y1), y0 < y1, in sixteenths of a pixel, placed at `row` (any row, above or
  /// below).
  [[nodiscard]] static Edge at_row(std::int32_t x0, std::int32_t y0, std::int32_t x1, std::int32_t y1,
                                   std::int32_t row) {
    const std::int32_t dx = x1 - x0;
    const std::int32_t dy = y1 - y0;
    Edge edge;
    edge.height = dy;
    edge.step = signed_word(divide_16(magnitude(dx), word(dy)));
    edge.remainder = signed_word(magnitude(dx)) - edge.step * dy;
    if (dx < 0) {
      edge.step = -edge.step;
      if (edge.remainder != 0) {
        --edge.step;
        edge.remainder = dy - edge.remainder;
      }
    }
    const std::int32_t s = 16 * row + 8 - y0;
    const std::int32_t whole = x0 + 8 + s * edge.step;
    edge.x = whole >> 4;
    if (s >= 0 && s <= 16) {  // the first row of the edge itself, where 32 bits suffice
      edge.place((whole & 15) * dy + s * edge.remainder - 1);
    } else {
      edge.place_far(static_cast<std::int64_t>(whole & 15) * dy + static_cast<std::int64_t>(s) * edge.remainder - 1);
    }
    return edge;
  }

  /// The edge from `upper` down to `lower`, with `x` a column of the picture. `row` is biased.
  [[nodiscard]] static Edge between(const ScreenVertex& upper, const ScreenVertex& lower, std::int32_t row) {
    Edge edge = at_row(upper.x, upper.y, lower.x, lower.y, row);
    edge.x -= row_bias;
    return edge;
  }

  void next_row() {
    x += step;
    error += remainder;
    if (error >= 0) {
      error -= height;
      ++x;
    }
  }

  /// `x` on the row that lies `rows` below the current one.
  [[nodiscard]] std::int32_t x_below(std::int32_t rows) const {
    return x + step * rows + (error + height + remainder * rows) / height;
  }

 private:
  /// Normalises a position of `rest`/dy sixteenths to the right of pixel `x`; rest in [−1, 32·dy).
  void place(std::int32_t rest) {
    const std::int32_t pixel = 16 * height;
    if (rest < 0) {
      --x;
      rest += pixel;
    }
    while (rest >= pixel) {
      ++x;
      rest -= pixel;
    }
    error = (rest >> 4) - height;
  }
  /// The same for any `rest`.
  void place_far(std::int64_t rest) {
    const FloorDivision division = floor_divide(rest, static_cast<std::int64_t>(16) * height);
    x += static_cast<std::int32_t>(division.quotient);
    error = static_cast<std::int32_t>(division.remainder >> 4) - height;
  }
};

}  // namespace spanline
