#pragma once
/// @file
/// Half-planes by the sign of an edge function, after J. Pineda, "A Parallel Algorithm for Polygon Rasterization"
/// (1988).
#include <cstdint>

#include "spanline/math/bits.hpp"
#include "spanline/raster/row_columns.hpp"

namespace spanline {

/// One side of a line on the screen, given by the sign of a·x + b·y + c at the pixel (x, y). Columns x and rows y are
/// those of the picture, not biased, in [0, 2047]. A line that cuts a polygon gives two fragments. Both use the same a,
/// b, c, so every pixel of the polygon belongs to exactly one of them.
struct HalfPlane {
  std::int32_t a = 0;  ///< increment from column to column; |a| + |b| ≤ 2^19, so that values in the picture fit 32 bits
  std::int32_t b = 0;  ///< increment of the value from row to row
  std::int32_t c = 0;  ///< |c| < 2^30

  /// The half-plane of a line whose coefficients may be too large. All three are shifted to the right until they fit,
  /// which moves a line that crosses the picture by less than a pixel.
  [[nodiscard]] static constexpr HalfPlane fitted(std::int64_t a, std::int64_t b, std::int64_t c) {
    constexpr std::int64_t most_slope = std::int64_t{1} << 19, most_constant = (std::int64_t{1} << 30) - 1;
    const auto size = [](std::int64_t value) { return value < 0 ? -value : value; };
    while (size(a) + size(b) > most_slope || size(c) > most_constant) {
      a >>= 1;
      b >>= 1;
      c >>= 1;
    }
    return {static_cast<std::int32_t>(a), static_cast<std::int32_t>(b), static_cast<std::int32_t>(c)};
  }

  /// The value at a pixel.
  [[nodiscard]] constexpr std::int32_t at(std::int32_t column, std::int32_t row) const {
    return a * column + b * row + c;
  }
  /// Whether a pixel lies on the side where the value is not negative.
  [[nodiscard]] constexpr bool holds(std::int32_t column, std::int32_t row) const { return at(column, row) >= 0; }

  /// The part of `columns` that lies on one side: where the value is not negative, or else where it is negative.
  /// `columns` lie inside the picture. This takes one division if the line crosses the run and none otherwise.
  [[nodiscard]] constexpr RowColumns cut(RowColumns columns, std::int32_t row, bool not_negative) const {
    if (columns.first >= columns.end) return columns;
    const bool first_holds = holds(columns.first, row) == not_negative,
               last_holds = holds(columns.end - 1, row) == not_negative;
    if (first_holds && last_holds) return columns;
    if (!first_holds && !last_holds) return {columns.first, columns.first};
    // The value changes sign once. `change` is the first column on the other side.
    const std::int32_t from = at(columns.first, row);
    const std::int32_t change = columns.first + (from >= 0 ? from / -a + 1 : (-from + a - 1) / a);
    return first_holds ? RowColumns{columns.first, change} : RowColumns{change, columns.end};
  }
};

}  // namespace spanline
