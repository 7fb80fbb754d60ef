#pragma once
#include <cstdint>

#include "spanline/raster/active_triangle.hpp"
#include "spanline/visibility/depth_run.hpp"

namespace spanline {

/// Counters of what a visibility algorithm did (--stats).
struct VisibilityCounters {
  std::uint64_t spans = 0;        ///< runs of pixels handed to shading or to the depth test
  std::uint64_t pixels = 0;       ///< pixels written
  std::uint64_t depth_tests = 0;  ///< depth comparisons
};

/// The part of the picture that is being drawn: rows [first_row, end_row), biased, of a line-major buffer.
template <class Depth, class Pixel>
struct BandTarget {
  typename Depth::Word* depth;
  Pixel* pixels;
  std::int32_t width;
  std::int32_t first_row;
  std::int32_t end_row;
  VisibilityCounters* counters = nullptr;  ///< for Counting only
};

/// A pixel source that counts what is written.
template <class Source>
struct CountedSource : Source {
  static constexpr bool constant = false;
  std::uint64_t* written;
  [[nodiscard]] auto get() const {
    ++*written;
    return Source::get();
  }
};

/// Draws the rows of an active triangle that lie in a band, testing depth. Input: the triangle and surface on
/// their current row. Output: pixels and depths; the triangle and surface on the row after the band if they go on.
template <class Depth, class Pixel, bool Counting>
class TriangleRows {
 public:
  using Target = BandTarget<Depth, Pixel>;
  using Run = DepthRun<Depth, Pixel>;

  /// `polygon` gives the corners, asked for only where a large triangle meets its bend. True if the triangle goes on
  /// below the band.
  template <class Surface, class CornersOf>
  static bool draw(ActiveTriangle& triangle, Surface& surface, const Target& target, CornersOf corners_of) {
    const std::int32_t available = target.end_row - triangle.row;
    const std::int32_t before = std::min<std::int32_t>(triangle.rows_to_bend, available);
    const std::int32_t after = std::min<std::int32_t>(triangle.rows_after_bend, available - before);
    if (triangle.is_small) {
      draw_small(triangle, surface, target, before, after);
    } else {
      if (before > 0) large_rows(triangle, surface, target, before);
      if (after > 0) {
        if (!triangle.bent) {
          bend_large(corners_of(), triangle);
          triangle.bent = true;
        }
        large_rows(triangle, surface, target, after);
      }
    }
    triangle.rows_to_bend = static_cast<std::uint16_t>(triangle.rows_to_bend - before);
    triangle.rows_after_bend = static_cast<std::uint16_t>(triangle.rows_after_bend - after);
    return (triangle.rows_to_bend | triangle.rows_after_bend) != 0;
  }

 private:
  template <class Source>
  static auto counted(const Source& source, const Target& target) {
    if constexpr (Counting)
      return CountedSource<Source>{source, &target.counters->pixels};
    else
      return source;
  }
  static void count(const Target& target, std::uint32_t pixels) {
    if constexpr (Counting) {
      ++target.counters->spans;
      target.counters->depth_tests += pixels;
    }
  }

  template <class Surface>
  static inline void draw_small(ActiveTriangle& triangle, Surface& surface, const Target& target, std::int32_t rows,
                                std::int32_t rows_after) {
    std::uint32_t left = triangle.small.left, right = triangle.small.right;
    std::uint32_t left_step = triangle.small.left_step, right_step = triangle.small.right_step;
    std::uint32_t z = triangle.depth.at_origin;
    const std::uint32_t dz = triangle.depth.dx, dz_row = triangle.depth.dy;
    const std::int32_t offset = (triangle.row - target.first_row) * target.width + triangle.origin;
    auto* depth = target.depth + offset;
    auto* pixels = target.pixels + offset;
    triangle.row = static_cast<std::uint16_t>(triangle.row + rows + rows_after);
    for (;;) {
      for (; rows > 0; --rows) {
        const std::uint32_t first = small_triangle::column(left), end = small_triangle::column(right);
        if (end > first) {
          count(target, end - first);
          Run::short_run(depth + first, pixels + first, end - first, z + dz * (end - 1), dz,
                         counted(surface.source(static_cast<std::int32_t>(end - 1)), target));
        }
        left += left_step;
        right += right_step;
        z += dz_row;
        surface.next_row();
        depth += target.width;
        pixels += target.width;
      }
      if (rows_after == 0) break;
      rows = rows_after;
      rows_after = 0;
      if (!triangle.bent) {
        triangle.bent = true;
        if (triangle.right_bends) {
          right = triangle.small.bend;
          right_step = triangle.small.right_step = triangle.small.bend_step;
        } else {
          left = triangle.small.bend;
          left_step = triangle.small.left_step = triangle.small.bend_step;
        }
      }
    }
    triangle.small.left = left;
    triangle.small.right = right;
    triangle.depth.at_origin = z;
  }

  template <class Surface>
  static void large_rows(ActiveTriangle& triangle, Surface& surface, const Target& target, std::int32_t rows) {
    Edge left = triangle.large.left, right = triangle.large.right;
    std::uint32_t z = triangle.depth.at_origin;
    const std::uint32_t dz = triangle.depth.dx, dz_row = triangle.depth.dy;
    const std::int32_t offset = (triangle.row - target.first_row) * target.width;
    auto* depth = target.depth + offset;
    auto* pixels = target.pixels + offset;
    triangle.row = static_cast<std::uint16_t>(triangle.row + rows);
    for (; rows > 0; --rows) {
      std::int32_t first = left.x, end = right.x;
      if (triangle.clipped) {
        first = std::max<std::int32_t>(first, 0);
        end = std::min(end, target.width);
      }
      if (end > first) {
        const std::uint32_t pixel_count = word(end - first);
        count(target, pixel_count);
        const auto source = counted(surface.source(first), target);
        if constexpr (decltype(source)::constant) {
          if (dz == 0) {
            Run::constant_run(depth + first, pixels + first, pixel_count, z, source.get());
          } else {
            Run::run(depth + first, pixels + first, pixel_count, z + dz * word(first), dz, source);
          }
        } else {
          Run::run(depth + first, pixels + first, pixel_count, z + dz * word(first), dz, source);
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
