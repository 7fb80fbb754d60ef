#pragma once
#include <cstdint>

#include "spanline/cpu/fixed_rows.hpp"
#include "spanline/pixel/pixel_format.hpp"
#include "spanline/raster/depth_format.hpp"
#include "spanline/shade/light/flat.hpp"
#include "spanline/shade/light/gouraud.hpp"
#include "spanline/visibility/band_target.hpp"
#include "twin_case.hpp"

/// Rows of small and medium triangles: two parts of 0 to 16 rows, runs that are empty, short and as long as can be.
namespace twins {

using namespace spanline;

inline constexpr std::int32_t row_width = 264, most_rows = 34;
inline Buffers<std::uint32_t{row_width * most_rows}> row_buffers;

/// Two edges over `rows` rows between which no row is wider than `widest` columns, and all are in [0, `columns`).
struct EdgePair {
  std::int64_t left, right, left_step, right_step;
};
inline EdgePair random_edges(Random& random, std::int32_t rows, std::int32_t columns, std::int32_t widest, int bits) {
  const auto column = [&](std::int32_t low, std::int32_t high) {
    return (static_cast<std::int64_t>(between(random, low, high)) << bits) +
           static_cast<std::int64_t>(random() >> (32 - bits));
  };
  // A fraction of a column is added to each: hence 2 columns less than the widest.
  const std::int32_t limit = widest - 2;
  const std::int64_t left = column(4, columns - limit - 4), left_end = column(4, columns - limit - 4);
  const std::int64_t right = left + column(-3, limit), right_end = left_end + column(-3, limit);
  const std::int32_t steps = rows == 0 ? 1 : rows;
  return {left, right, (left_end - left) / steps, (right_end - right) / steps};
}

template <ActiveTriangle::Size Size>
ActiveTriangle random_triangle(Random& random, std::int32_t rows, std::int32_t rows_after) {
  constexpr bool small = Size == ActiveTriangle::Size::small;
  constexpr int bits = small ? small_triangle::fraction_bits : medium_triangle::fraction_bits;
  constexpr std::int32_t columns = small ? 64 : 256;
  const std::int32_t widest = small ? 21 : between(random, 4, 220);
  ActiveTriangle triangle;
  triangle.depth = {random(), random_step(random), random_step(random)};
  triangle.origin = between(random, 0, row_width - columns);
  triangle.row = between(random, 100, 101);
  triangle.rows_to_knee = rows;
  triangle.rows_after_knee = rows_after;
  const bool third_right = (random() & 1) != 0;
  triangle.flags = {Size, third_right, (random() & 1) != 0};
  if (random.below(4) == 0) triangle.flags.set_past_knee();
  const EdgePair edges = random_edges(random, rows + rows_after, columns, widest, bits);
  const auto word_of = [](std::int64_t value) { return static_cast<std::uint32_t>(value); };
  triangle.fixed.left = word_of(edges.left);
  triangle.fixed.right = word_of(edges.right);
  triangle.fixed.left_step = word_of(edges.left_step);
  triangle.fixed.right_step = word_of(edges.right_step);
  // The third edge begins half a column from the one that it follows, and goes on beside it.
  const std::int64_t half = std::int64_t{1} << (bits - 1);
  if (third_right) {
    triangle.fixed.third = word_of(edges.right + rows * edges.right_step + half);
    triangle.fixed.third_step = triangle.fixed.right_step;
  } else {
    triangle.fixed.third = word_of(edges.left + rows * edges.left_step - half);
    triangle.fixed.third_step = triangle.fixed.left_step;
  }
  return triangle;
}

template <ActiveTriangle::Size Size, class Surface>
bool rows_alike(Random& random, const Surface& surface) {
  const std::int32_t rows = between(random, 0, 16), rows_after = between(random, 0, 16);
  const ActiveTriangle triangle = random_triangle<Size>(random, rows, rows_after);
  using Target = BandTarget<Depth16<>, std::uint16_t>;
  row_buffers.fill(random, row_width * most_rows, triangle.depth.at_origin);
  const auto target = [](auto& buffers) {
    return Target{.depth = buffers.depth,
                  .pixels = buffers.pixels,
                  .width = row_width,
                  .first_row = 100,
                  .end_row = 100 + most_rows,
                  .background = 0};
  };
  FixedRows<Depth16<>, std::uint16_t>::draw(triangle, surface, target(row_buffers.fast), rows, rows_after);
  FixedRows<Depth16<>, std::uint16_t, NoCounts, Form::portable>::draw(triangle, surface, target(row_buffers.portable),
                                                                      rows, rows_after);
  return row_buffers.alike(row_width * most_rows);
}

template <ActiveTriangle::Size Size>
bool flat_rows_alike(Random& random) {
  const FlatShader<Rgb565>::Surface surface{static_cast<std::uint16_t>(random())};
  return rows_alike<Size>(random, surface);
}

inline bool ramp_rows_alike(Random& random) {
  static std::uint16_t ramp[gouraud::ramp_size];
  for (std::uint16_t& entry : ramp) entry = static_cast<std::uint16_t>(random());
  GouraudShader<Rgb565>::Surface surface;
  surface.intensity = {random(), random_step(random), random_step(random)};
  surface.ramp = ramp;
  return rows_alike<ActiveTriangle::Size::small>(random, surface);
}

}  // namespace twins
