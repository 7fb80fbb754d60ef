#pragma once
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "spanline/cpu/armv6m/flat_rows.hpp"
#include "spanline/cpu/armv6m/ramp_rows.hpp"
#include "spanline/raster/active_triangle.hpp"
#include "spanline/raster/surface_blocks.hpp"
#include "spanline/raster/triangle_setup.hpp"
#include "spanline/visibility/band_target.hpp"
#include "spanline/visibility/zbuffer/block_run.hpp"
#include "spanline/visibility/zbuffer/depth_run.hpp"
#include "spanline/visibility/zbuffer/row_address.hpp"

namespace spanline {

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
template <class Depth, class Pixel, bool Counting, bool Bounded>
class TriangleRows {
 public:
  using Target = BandTarget<Depth, Pixel>;
  using Run = DepthRun<Depth, Pixel>;

  /// `corners_of` gives the polygon's corners, asked for only where a large triangle meets its bend. True if the
  /// triangle goes on below the band.
  template <class Surface, class CornersOf>
  static bool draw(ActiveTriangle& triangle, Surface& surface, const Target& target, CornersOf corners_of) {
    const std::int32_t before = triangle.rows_to_bend, after = triangle.rows_after_bend;
    const std::int32_t available = target.end_row - triangle.row;
    if constexpr (Bounded) {
      if (triangle.flags.size() != ActiveTriangle::Size::large)
        target.bounds->touch(triangle.row - target.first_row, std::min(before + after, available));
    }
    if (before + after <= available) {
      draw_rows(triangle, surface, target, before, after, corners_of);
      return false;
    }
    const std::int32_t before_here = std::min(before, available), after_here = available - before_here;
    draw_rows(triangle, surface, target, before_here, after_here, corners_of);
    if (triangle.flags.size() != ActiveTriangle::Size::large) {
      triangle.skip_rows(before_here, after_here);
      surface.skip_rows(available);
    }
    triangle.row = target.end_row;
    triangle.rows_to_bend = before - before_here;
    triangle.rows_after_bend = after - after_here;
    return true;
  }

 private:
  template <class Source>
  static auto counted(const Source& source, const Target& target) {
    if constexpr (Counting)
      return CountedSource<Source>{source, &target.counters->pixels};
    else
      return source;
  }
  template <SurfaceInBlocks Surface>
  static void block_run(typename Depth::Word* depth, Pixel* pixels, std::uint32_t pixel_count, std::uint32_t z,
                        std::uint32_t dz, const Surface& surface, std::int32_t column, const Target& target) {
    BlockRun<Depth, Pixel>::run(depth, pixels, pixel_count, z, dz, surface, column,
                                [&](const auto& source) { return counted(source, target); });
  }
  static void count(const Target& target, std::uint32_t pixels) {
    if constexpr (Counting) {
      ++target.counters->spans;
      target.counters->depth_tests += pixels;
    }
  }

  template <class Surface, class CornersOf>
  static void draw_rows(ActiveTriangle& triangle, Surface& surface, const Target& target, std::int32_t before,
                        std::int32_t after, CornersOf& corners_of) {
    if constexpr (flat_in_assembly<Surface>) {
      if (triangle.flags.size() != ActiveTriangle::Size::large)
        return flat_rows(triangle, surface, target, before, after);
    } else if (triangle.flags.size() == ActiveTriangle::Size::small) {
      if constexpr (ramp_in_assembly<Surface>)
        ramp_rows(triangle, surface, target, before, after);
      else
        fixed_rows<small_triangle::fraction_bits, Surface>(triangle, surface, target, before, after);
      return;
    } else if (triangle.flags.size() == ActiveTriangle::Size::medium) {
      fixed_rows<medium_triangle::fraction_bits, Surface>(triangle, surface, target, before, after);
      return;
    }
    if (before > 0) large_rows(triangle, surface, target, before);
    if (after > 0) {
      if (!triangle.flags.bent()) {
        bend_large(corners_of(), triangle);
        triangle.flags.set_bent();
      }
      large_rows(triangle, surface, target, after);
    }
  }

  /// How a surface travels to a function: as a value where that takes a register.
  template <class Surface>
  using InFewRegisters = std::conditional_t<sizeof(Surface) <= sizeof(std::uint32_t), Surface, const Surface&>;

  /// Draws rows of a small or medium triangle, and leaves it and its surface where they stand. A function of its own:
  /// its loop wants every register.
  template <int FractionBits, class Surface>
  [[gnu::noinline]] static void fixed_rows(const ActiveTriangle& triangle, InFewRegisters<Surface> kept_surface,
                                           const Target& target, std::int32_t rows, std::int32_t rows_after) {
    Surface surface = kept_surface;
    FixedEdges edges = triangle.fixed;
    std::uint32_t z = triangle.depth.at_origin;
    const std::uint32_t dz = triangle.depth.dx, dz_row = triangle.depth.dy;
    const std::int32_t offset = (triangle.row - target.first_row) * target.width + triangle.origin;
    RowAddress<typename Depth::Word, Pixel> row(target.depth, target.pixels, offset);
    for (;;) {
      for (; rows > 0; --rows) {
        const std::uint32_t first = edges.left >> FractionBits, end = edges.right >> FractionBits;
        if (end > first) {
          count(target, end - first);
          auto* depth = row.depth(first);
          Pixel* pixels = row.pixels(depth, first);
          if constexpr (SurfaceInBlocks<Surface>) {
            block_run(depth, pixels, end - first, z + dz * first, dz, surface, static_cast<std::int32_t>(first),
                      target);
          } else if (FractionBits == small_triangle::fraction_bits || end - first <= Run::short_limit) {
            Run::short_run(depth, pixels, end - first, z + dz * (end - 1), dz,
                           counted(surface.source(static_cast<std::int32_t>(end - 1)), target));
          } else {
            Run::long_run(depth, pixels, end - first, z + dz * first, dz,
                          counted(surface.source(static_cast<std::int32_t>(first)), target));
          }
        }
        edges.next_row();
        z += dz_row;
        surface.next_row();
        row.next_row(target.width);
      }
      if (rows_after == 0) break;
      rows = rows_after;
      rows_after = 0;
      if (!triangle.flags.bent()) edges.bend(triangle.flags.right_bends());
    }
  }

  /// A run against the depth buffer; `z` is the plane word at its first pixel.
  template <class Surface>
  [[gnu::always_inline]] static inline void test_piece(const Surface& surface, std::int32_t column,
                                                       typename Depth::Word* depth, Pixel* pixels,
                                                       std::uint32_t pixel_count, std::uint32_t z, std::uint32_t dz,
                                                       const Target& target) {
    if constexpr (SurfaceInBlocks<Surface>)
      block_run(depth, pixels, pixel_count, z, dz, surface, column, target);
    else
      Run::run(depth, pixels, pixel_count, z, dz, counted(surface.source(column), target));
  }

  /// A piece of a run that bounds have not rejected; where they accept it, nothing need be compared.
  template <class Surface>
  static void draw_piece(const Surface& surface, std::int32_t column, typename Depth::Word* depth, Pixel* pixels,
                         std::uint32_t pixel_count, std::uint32_t z, std::uint32_t dz, const Target& target,
                         bool accepted) {
    if constexpr (!SurfaceInBlocks<Surface>) {
      if (accepted) {
        Run::accepted_run(depth, pixels, pixel_count, z, dz, counted(surface.source(column), target));
        return;
      }
    }
    if constexpr (Counting) target.counters->depth_tests += pixel_count;
    test_piece(surface, column, depth, pixels, pixel_count, z, dz, target);
  }

#if defined(__ARM_ARCH_6M__)
  static constexpr bool formats_in_assembly = !Counting && Depth::bits == 16 && Depth::smaller && sizeof(Pixel) == 2;
  /// Whether triangles of a surface take the rows in assembly: one pixel value, or a ramp's in short rows.
  template <class Surface>
  static constexpr bool flat_in_assembly = [] {
    if constexpr (requires(const Surface& surface) { surface.source(0); })
      return formats_in_assembly && decltype(std::declval<Surface>().source(0))::constant;
    return false;
  }();
  template <class Surface>
  static constexpr bool ramp_in_assembly = formats_in_assembly&& RampSurface<Surface>;

  static const armv6m::BandTargetWords* words(const Target& target) {
    static_assert(offsetof(Target, depth) == 0 && offsetof(Target, pixels) == 4 && offsetof(Target, width) == 8 &&
                  offsetof(Target, first_row) == 12);
    return reinterpret_cast<const armv6m::BandTargetWords*>(&target);
  }

  /// Rows of a small or medium triangle of one pixel value.
  template <class Surface>
  static void flat_rows(const ActiveTriangle& triangle, const Surface& surface, const Target& target, std::int32_t rows,
                        std::int32_t rows_after) {
    const std::uint32_t pixel = surface.source(0).get();
    if (triangle.flags.size() == ActiveTriangle::Size::small)
      armv6m::flat_rows_short(&triangle, pixel, words(target), rows, rows_after);
    else
      armv6m::flat_rows_long(&triangle, pixel, words(target), rows, rows_after);
  }

  /// Rows of a small triangle with a ramp.
  template <class Surface>
  static void ramp_rows(const ActiveTriangle& triangle, const Surface& surface, const Target& target, std::int32_t rows,
                        std::int32_t rows_after) {
    static_assert(offsetof(Surface, intensity) == 0 && offsetof(Surface, ramp) == 12);
    armv6m::ramp_rows(&triangle, reinterpret_cast<const armv6m::RampSurfaceWords*>(&surface), words(target), rows,
                      rows_after);
  }
#else
  template <class Surface>
  static constexpr bool flat_in_assembly = false;
  template <class Surface>
  static constexpr bool ramp_in_assembly = false;
#endif

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
          count(target, pixel_count);
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
