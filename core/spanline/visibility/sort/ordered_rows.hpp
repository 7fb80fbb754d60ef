#pragma once
#include <cstdint>
#include <new>
#include <span>

#include "spanline/raster/link.hpp"
#include "spanline/raster/make_surface.hpp"
#include "spanline/raster/polygon_table.hpp"
#include "spanline/raster/row_columns.hpp"
#include "spanline/visibility/counted_runs.hpp"
#include "spanline/visibility/covered_triangles.hpp"
#include "spanline/visibility/screen_surface.hpp"
#include "spanline/visibility/span/awake_polygon.hpp"

/// For functions that hand a run to every shader of a list. They are inlined into loops over rows, except in builds
/// that do not optimise: there each copy would take room of its own on the stack.
#ifdef __OPTIMIZE__
#define SPANLINE_INLINE_IF_OPTIMISED [[gnu::always_inline]] inline
#else
#define SPANLINE_INLINE_IF_OPTIMISED [[gnu::noinline]]
#endif

namespace spanline {

/// Does nothing from row to row.
struct NoStep {
  void operator()() const {}
};

/// Walks a polygon with fixed edges, which is placed on `row`, down to `end`, which is at most its end row: use(row,
/// columns) gets the columns of each row that has any, counted from a column that lies `from_column` to the left of the
/// polygon's origin, in the fixed point of the edges. `step()` is called after every row.
template <class Use, class Step = NoStep>
[[gnu::always_inline]] inline void for_each_fixed_row(AwakePolygon& polygon, const PolygonSource& source,
                                                      std::int32_t row, std::int32_t end, std::uint32_t from_column,
                                                      Use use, Step step = {}) {
  const int fraction_bits = polygon.fraction_bits;
  while (row < end) {
    const std::int32_t stop = polygon.turn_row < end ? polygon.turn_row : end;
    std::uint32_t left = polygon.fixed.left + from_column, right = polygon.fixed.right + from_column;
    const std::uint32_t left_step = polygon.fixed.left_step, right_step = polygon.fixed.right_step;
    for (;;) {
      const RowColumns columns{signed_word(left >> fraction_bits), signed_word(right >> fraction_bits)};
      if (columns.first < columns.end) use(row, columns);
      step();
      if (++row == stop) break;
      left += left_step;
      right += right_step;
    }
    if (row == end) return;
    polygon.fixed.left = left - from_column;
    polygon.fixed.right = right - from_column;
    static_cast<void>(turn(polygon, source, row));
  }
}

/// Walks a polygon that is placed on `row` down to `end`: use(row, columns) gets the columns of each row that has any,
/// cut to the viewport. `step()` is called after every row.
template <class Use, class Step = NoStep>
[[gnu::always_inline]] inline void for_each_row(AwakePolygon& polygon, const PolygonSource& source, std::int32_t row,
                                                std::int32_t end, Use use, Step step = {}) {
  if (end > polygon.end_row) end = polygon.end_row;
  if (polygon.fraction_bits != 0) {
    const std::int32_t origin = polygon.origin;
    for_each_fixed_row(
        polygon, source, row, end, 0,
        [&](std::int32_t at, RowColumns columns) __attribute__((always_inline)) {
          use(at, RowColumns{origin + columns.first, origin + columns.end});
        },
        step);
    return;
  }
  const std::int32_t width = source.viewport.width;
  while (row < end) {
    const std::int32_t stop = polygon.turn_row < end ? polygon.turn_row : end;
    Edge left = polygon.large.left, right = polygon.large.right;
    for (;;) {
      const RowColumns columns{left.x < 0 ? 0 : left.x, right.x > width ? width : right.x};
      if (columns.first < columns.end) use(row, columns);
      step();
      if (++row == stop) break;
      left.next_row();
      right.next_row();
    }
    polygon.large = {left, right};
    if (row < end) static_cast<void>(turn(polygon, source, row));
  }
}

/// A polygon that is being drawn, with its surface.
template <class Shaders>
struct DrawnPolygon : AwakePolygon {
  typename Shaders::Surface surface;
};

/// Hands runs of polygons to their shaders, for algorithms that draw polygons one after another. A surface is made when
/// a polygon's first run comes, or at once if that costs next to nothing. The runs of a polygon come from top to
/// bottom.
template <class Depth, class Shaders, class Target, class ShadingGroup, bool Counting>
struct OrderedRuns : PolygonSource {
  using Entry = DrawnPolygon<Shaders>;
  using DepthFormat = Depth;
  static constexpr bool counting = Counting;

  const ShadingGroup* shading;
  const Target& target;

  /// Draws a run of visible pixels. See-through surfaces are laid over what is there.
  SPANLINE_INLINE_IF_OPTIMISED void fill(Entry& entry, std::int32_t row, RowColumns columns) const {
    fill(entry, row, columns, line(row));
  }
  /// The same where the row's pixels are known.
  template <class Pixel>
  SPANLINE_INLINE_IF_OPTIMISED void fill(Entry& entry, std::int32_t row, RowColumns columns, Pixel* pixels) const {
    const ShadingGroup& group = shading[entry.group];
    Shaders::with(
        group.shader, [&]<class Shader>() __attribute__((always_inline)) {
          if (!entry.has_surface) make_surface<Shader>(entry, group);
          fill_by<Shader>(entry, row, columns, pixels);
        });
  }
  /// Has to be called for a polygon that was just placed before `fill`.
  void begin(Entry& entry) const {
    if constexpr (!Shaders::interpolates) prepare(entry);
  }
  /// Makes the surface of a polygon that was just placed, if it is certain to be visible.
  void prepare(Entry& entry) const {
    const ShadingGroup& group = shading[entry.group];
    Shaders::with(group.shader, [&]<class Shader>() { make_surface<Shader>(entry, group); });
  }
  /// As `fill`, after `prepare`.
  template <class Pixel>
  SPANLINE_INLINE_IF_OPTIMISED void fill_prepared(Entry& entry, std::int32_t row, RowColumns columns,
                                                  Pixel* pixels) const {
    Shaders::with(
        shading[entry.group].shader, [&]<class Shader>() __attribute__((always_inline)) {
          fill_by<Shader>(entry, row, columns, pixels);
        });
  }

  /// The row's pixels.
  [[nodiscard]] auto* line(std::int32_t row) const {
    return target.pixels + (row + row_bias - target.first_row) * target.width;
  }

 private:
  template <class Shader, class Pixel>
  SPANLINE_INLINE_IF_OPTIMISED void fill_by(Entry& entry, std::int32_t row, RowColumns columns, Pixel* pixels) const {
    auto& surface = entry.surface.template as<typename Shader::Surface>();
    if constexpr (Shader::interpolates || DividesOutlines<Shader>) {
      surface.skip_rows(row - entry.surface_row);
      entry.surface_row = static_cast<std::uint16_t>(row);
    }
    Shaders::fill(surface, columns.first, word(columns.end - columns.first), pixels + columns.first);
    if constexpr (Counting) count<Shader>(entry, surface, row, columns);
  }
  template <class Shader>
  [[gnu::noinline]] void make_surface(Entry& entry, const ShadingGroup& group) const {
    auto* surface = new (entry.surface.bytes) typename Shader::Surface;
    entry.has_surface = true;
    entry.surface_row = 0;
    make_screen_surface<Shader>(*surface, group, this->entry(entry), entry.is_outline(), this->viewport);
  }
  template <class Shader>
  void count(Entry& entry, const typename Shader::Surface& surface, std::int32_t row, RowColumns columns) const {
    if (!entry.has_plane) make_plane<Depth>(entry, *this);
    const CountedRuns<Depth, Target> counted(target, row);
    if (this->table.groups[entry.group].see_through)
      counted.template see_through<Shader>(entry, surface, columns);
    else
      counted.opaque(entry, columns);
  }
};

/// Calls covered(id) for each triangle of a polygon that covers a pixel centre of the rows from `first_row` (not
/// biased) on, for statistics. `placed` is the polygon, placed anywhere.
template <class ShadingGroup, class Covered>
void tell_covered_from(const AwakePolygon& placed, const PolygonSource& source, const ShadingGroup& group,
                       std::int32_t first_row, Covered& covered) {
  const PolygonEntry entry = source.entry(placed);
  const std::uint32_t first_id = group.first_id + entry.corners().triangle;
  if (placed.is_outline()) return tell_covered(entry, source.viewport, first_row + row_bias, first_id, covered);
  AwakePolygon polygon = placed;
  bool covers = false;
  const std::int32_t row = place(polygon, source, placed.number, first_row, source.viewport.height);
  for_each_row(polygon, source, row, source.viewport.height, [&](std::int32_t, RowColumns) { covers = true; });
  if (covers) covered(first_id);
}

}  // namespace spanline
