#pragma once
#include <cstdint>

#include "spanline/math/bits.hpp"
#include "spanline/raster/row_columns.hpp"

namespace spanline {

/// One side of a line on the screen, by the sign of a·x + b·y + c at pixel (x, y): columns and rows of the picture, not
/// biased, [0, 2047]. A cut through a polygon gives two fragments, on either side of the same three words, so that
/// every pixel of the polygon belongs to one of them and none to both.
struct HalfPlane {
  std::int32_t a = 0;  ///< |a| + |b| ≤ 2^19, so that no value inside the picture leaves 32 bits
  std::int32_t b = 0;
  std::int32_t c = 0;  ///< |c| < 2^30

  /// The half-plane of a line whose words may be larger: all three are shifted to the right until they fit, which moves
  /// the line by less than a pixel where a line crosses the picture at all.
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

  [[nodiscard]] constexpr std::int32_t at(std::int32_t column, std::int32_t row) const {
    return a * column + b * row + c;
  }
  /// Whether a pixel lies on the side where the value is not negative.
  [[nodiscard]] constexpr bool holds(std::int32_t column, std::int32_t row) const { return at(column, row) >= 0; }

  /// The part of `columns`, which lie inside the picture, that is on one side: where the value is not negative, or the
  /// other. One division where the line crosses the run, none elsewhere.
  [[nodiscard]] constexpr RowColumns cut(RowColumns columns, std::int32_t row, bool not_negative) const {
    if (columns.first >= columns.end) return columns;
    const bool first_holds = holds(columns.first, row) == not_negative,
               last_holds = holds(columns.end - 1, row) == not_negative;
    if (first_holds && last_holds) return columns;
    if (!first_holds && !last_holds) return {columns.first, columns.first};
    // The value changes sign once: the last column on the side of the first one is where it has not yet.
    const std::int32_t from = at(columns.first, row);
    const std::int32_t change = columns.first + (from >= 0 ? from / -a + 1 : (-from + a - 1) / a);
    return first_holds ? RowColumns{columns.first, change} : RowColumns{change, columns.end};
  }
};

}  // namespace spanline
