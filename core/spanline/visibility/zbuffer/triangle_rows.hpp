#pragma once
#include <algorithm>
#include <cstdint>

#include "spanline/cpu/block_run.hpp"
#include "spanline/cpu/depth_run.hpp"
#include "spanline/cpu/fixed_rows.hpp"
#include "spanline/raster/active_triangle.hpp"
#include "spanline/raster/outline_setup.hpp"
#include "spanline/raster/polygon_table.hpp"
#include "spanline/raster/surface_blocks.hpp"
#include "spanline/raster/triangle_setup.hpp"
#include "spanline/visibility/band_target.hpp"
#include "spanline/visibility/zbuffer/depth_bounds.hpp"
#include "spanline/visibility/zbuffer/run_counts.hpp"

namespace spanline {

/// Draws the rows of an active triangle that lie in a band, with the depth test. Input: the triangle and its surface on
/// their current row. Output: pixels and depths; if the triangle continues, it and its surface are stepped to the row
/// after the band.
template <class Depth, class Pixel, bool Counting, bool Bounded>
class TriangleRows {
 public:
  using Target = std::conditional_t<Bounded, BoundedBandTarget<Depth, Pixel>, BandTarget<Depth, Pixel>>;
  using Run = DepthRun<Depth, Pixel>;

  /// `entry_of` returns the polygon's PolygonEntry; it is called only where a large triangle reaches its knee. True if
  /// the triangle continues below the band.
  template <class Surface, class EntryOf>
  static bool draw(ActiveTriangle& triangle, Surface& surface, const Target& target, EntryOf entry_of) {
    const std::int32_t before = triangle.rows_to_knee, after = triangle.rows_after_knee;
    const std::int32_t available = target.end_row - triangle.row;
    if constexpr (Bounded) {
      if (triangle.flags.size() != ActiveTriangle::Size::large)
        target.bounds->touch(triangle.row - target.first_row, std::min(before + after, available));
    }
    if (before + after <= available) {
      draw_rows(triangle, surface, target, before, after, entry_of);
      return false;
    }
    const std::int32_t before_here = std::min(before, available), after_here = available - before_here;
    draw_rows(triangle, surface, target, before_here, after_here, entry_of);
    if (triangle.flags.size() != ActiveTriangle::Size::large) {
      triangle.skip_rows(before_here, after_here);
      surface.skip_rows(available);
    }
    triangle.row = target.end_row;
    triangle.rows_to_knee = before - before_here;
    triangle.rows_after_knee = after - after_here;
    return true;
  }

  /// As `draw`, for an outline: it is drawn from corner to corner.
  template <class Surface>
  [[gnu::noinline]] static bool draw_outline(ActiveTriangle& outline, Surface& surface, const Target& target,
                                             const PolygonEntry& entry) {
    const bool large = outline.flags.size() == ActiveTriangle::Size::large;
    if constexpr (Bounded) {
      if (!large)
        target.bounds->touch(outline.row - target.first_row, std::min(outline.end_row(), target.end_row) - outline.row);
    }
    for (;;) {
      const std::int32_t rows = std::min(outline.rows_to_knee, target.end_row - outline.row);
      draw_rows(outline, surface, target, rows, 0, [&] { return entry; });
      outline.rows_to_knee -= rows;
      const bool ended = outline.rows_to_knee == 0;
      if (ended && outline.rows_after_knee == 0) return false;
      if (!large) {
        outline.skip_rows(rows, 0);
        surface.skip_rows(rows);
        outline.row += rows;
      }
      if (ended) place_outline_edges(entry.outline(), outline);
      if (outline.row == target.end_row) return true;
    }
  }

 private:
  using Counts = RunCounts<Counting>;

  template <SurfaceInBlocks Surface>
  static void block_run(typename Depth::Word* depth, Pixel* pixels, std::uint32_t pixel_count, std::uint32_t z,
                        std::uint32_t dz, const Surface& surface, std::int32_t column, const Target& target) {
    BlockRun<Depth, Pixel>::run(depth, pixels, pixel_count, z, dz, surface, column,
                                [&](const auto& source) { return Counts::source(source, target); });
  }

  template <class Surface, class EntryOf>
  static void draw_rows(ActiveTriangle& triangle, Surface& surface, const Target& target, std::int32_t before,
                        std::int32_t after, const EntryOf& entry_of) {
    if (FixedRows<Depth, Pixel, Counts>::draw(triangle, surface, target, before, after)) return;
    if (before > 0) large_rows(triangle, surface, target, before);
    if (after > 0) {
      if (!triangle.flags.past_knee()) {
        put_third_large_edge(entry_of().corners(), triangle);
        triangle.flags.set_past_knee();
      }
      large_rows(triangle, surface, target, after);
    }
  }

  /// Draws a run with the depth test; `z` is the plane word at its first pixel.
  template <class Surface>
  [[gnu::always_inline]] static inline void test_piece(const Surface& surface, std::int32_t column,
                                                       typename Depth::Word* depth, Pixel* pixels,
                                                       std::uint32_t pixel_count, std::uint32_t z, std::uint32_t dz,
                                                       const Target& target) {
    if constexpr (SurfaceInBlocks<Surface>)
      block_run(depth, pixels, pixel_count, z, dz, surface, column, target);
    else
      Run::run(depth, pixels, pixel_count, z, dz, Counts::source(surface.source(column), target));
  }

  /// Draws a piece of a run that the bounds have not rejected. If they have accepted it, no depth is compared.
  template <class Surface>
  static void draw_piece(const Surface& surface, std::int32_t column, typename Depth::Word* depth, Pixel* pixels,
                         std::uint32_t pixel_count, std::uint32_t z, std::uint32_t dz, const Target& target,
                         bool accepted) {
    if constexpr (!SurfaceInBlocks<Surface>) {
      if (accepted) {
        Run::accepted_run(depth, pixels, pixel_count, z, dz, Counts::source(surface.source(column), target));
        return;
      }
    }
    if constexpr (Counting) target.counters->depth_tests += pixel_count;
    test_piece(surface, column, depth, pixels, pixel_count, z, dz, target);
  }

  template <class Surface>
  static void large_rows(ActiveTriangle& triangle, Surface& surface, const Target& target, std::int32_t rows) {
    Edge left = triangle.large.left, right = triangle.large.right;
    std::uint32_t z = triangle.depth.at_origin;
    const std::uint32_t dz = triangle.depth.dx, dz_row = triangle.depth.dy;
    const bool clipped = triangle.flags.clipped();
    const std::int32_t offset = (triangle.row - target.first_row) * target.width;
    auto* depth = target.depth + offset;
    auto* pixels = target.pixels + offset;
    [[maybe_unused]] std::int32_t line = triangle.row - target.first_row;
    triangle.row += rows;
    for (; rows > 0; --rows, ++line) {
      std::int32_t first = left.x, end = right.x;
      if (clipped) {
        first = std::max<std::int32_t>(first, 0);
        end = std::min(end, target.width);
      }
      if (end > first) {
        if constexpr (Bounded) {
          if constexpr (Counting) ++target.counters->spans;
          target.bounds->draw(line, word(first), word(end), word(target.width), z + dz * word(first), dz,
                              !SurfaceInBlocks<Surface>,
                              [&](std::uint32_t column, std::uint32_t pixel_count, std::uint32_t at, bool accepted) {
                                draw_piece(surface, signed_word(column), depth + column, pixels + column, pixel_count,
                                           at, dz, target, accepted);
                              });
        } else {
          const std::uint32_t pixel_count = word(end - first);
          Counts::run(target, pixel_count);
          test_piece(surface, first, depth + first, pixels + first, pixel_count, z + dz * word(first), dz, target);
        }
      }
      left.next_row();
      right.next_row();
      z += dz_row;
      surface.next_row();
      depth += target.width;
      pixels += target.width;
    }
    triangle.large.left = left;
    triangle.large.right = right;
    triangle.depth.at_origin = z;
  }
};

}  // namespace spanline
