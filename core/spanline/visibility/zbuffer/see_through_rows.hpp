#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "spanline/raster/active_triangle.hpp"
#include "spanline/raster/row_stepper.hpp"
#include "spanline/raster/surface_blocks.hpp"
#include "spanline/visibility/band_target.hpp"

namespace spanline {

/// Draws the rows of a see-through triangle that lie in a band. One function serves all sizes of triangles, which is
/// simpler and slower than TriangleRows. Pixels that pass the depth test become fragments if the surface blends; a
/// surface that is opaque but has holes writes them at once.
template <class Depth, class Pixel, class Fragments, bool Counting>
struct SeeThroughRows {
  using Target = BandTarget<Depth, Pixel>;

  /// As TriangleRows::draw, including the meaning of the result.
  template <class Surface, class EntryOf>
  [[gnu::noinline]] static bool draw(ActiveTriangle& triangle, Surface& surface, const Target& target,
                                     Fragments& fragments, EntryOf entry_of) {
    while (triangle.rows_to_knee + triangle.rows_after_knee > 0) {
      if (triangle.row == target.end_row) return true;
      const std::int32_t row = triangle.row - target.first_row;
      RowColumns columns = step_row(triangle, entry_of);
      if (triangle.flags.clipped()) {
        columns.first = std::max<std::int32_t>(columns.first, 0);
        columns.end = std::min(columns.end, target.width);
      }
      if (columns.end > columns.first)
        run(triangle.depth.at(columns.first), triangle.depth.dx, surface, columns,
            static_cast<std::size_t>(row * target.width + triangle.origin + columns.first), target, fragments);
      triangle.depth.next_row();
      surface.next_row();
    }
    return false;
  }

 private:
  /// Draws a run that begins at pixel `at` of the band, where the plane word is `z`; `dz` is its step a column.
  template <class Surface>
  static void run(std::uint32_t z, std::uint32_t dz, const Surface& surface, RowColumns columns, std::size_t at,
                  const Target& target, Fragments& fragments) {
    const bool blends = surface.blends();
    const std::uint32_t count = word(columns.end - columns.first);
    if constexpr (Counting) {
      ++target.counters->spans;
      target.counters->depth_tests += count;
    }
    for_each_pixel(surface.blocks(columns.first), count, [&](const auto& source) {
      const std::uint32_t candidate = Depth::stored(z);
      const std::size_t pixel = at++;
      z += dz;
      if (!Depth::hides(candidate, target.depth[pixel]) || !source.present()) return;
      if constexpr (Counting) ++target.counters->pixels;
      const auto depth = static_cast<typename Depth::Word>(candidate);
      if (blends) {
        fragments.add(pixel, depth, source.layer(), target.depth[pixel], target.pixels[pixel]);
      } else {
        target.depth[pixel] = depth;
        target.pixels[pixel] = source.get();
      }
    });
  }
};

}  // namespace spanline
