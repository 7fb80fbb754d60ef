#pragma once
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "spanline/cpu/armv6m/row_kernels.hpp"
#include "spanline/cpu/block_run.hpp"
#include "spanline/cpu/depth_run.hpp"
#include "spanline/cpu/form.hpp"
#include "spanline/cpu/row_address.hpp"
#include "spanline/raster/active_triangle.hpp"
#include "spanline/raster/medium_triangle.hpp"
#include "spanline/raster/small_triangle.hpp"
#include "spanline/raster/surface_blocks.hpp"

namespace spanline {

/// The `Counts` of a program that keeps no statistics.
struct NoCounts {
  static constexpr bool counting = false;
  template <class Target>
  static void run(const Target&, std::uint32_t) {}
  template <class Source, class Target>
  static const Source& source(const Source& source, const Target&) {
    return source;
  }
};

/// Draws rows of small and medium triangles, whose edges are fixed-point columns, against a depth buffer. A target has
/// `depth`, `pixels`, `width` and `first_row`, in this order. `Counts` is told of each run and may wrap a source in one
/// that counts.
template <class Depth, class Pixel, class Counts = NoCounts, Form form = Form::fastest>
class FixedRows {
 public:
  /// Draws `rows` rows before the triangle's knee and `rows_after` after it; triangle and surface are not stepped.
  /// Returns false and draws nothing for large triangles.
  template <class Surface, class Target>
  [[gnu::always_inline]] static inline bool draw(const ActiveTriangle& triangle, const Surface& surface,
                                                 const Target& target, std::int32_t rows, std::int32_t rows_after) {
    const ActiveTriangle::Size size = triangle.flags.size();
#if defined(__ARM_ARCH_6M__)
    if constexpr (fast && armv6m::flat_surface<Surface>) {
      if (size == ActiveTriangle::Size::large) return false;
      armv6m::draw_flat_rows(triangle, surface, target, rows, rows_after);
      return true;
    } else if constexpr (fast && RampSurface<Surface>) {
      if (size == ActiveTriangle::Size::small) {
        armv6m::draw_ramp_rows(triangle, surface, target, rows, rows_after);
        return true;
      }
    }
#endif
    if (size == ActiveTriangle::Size::small)
      walk<small_triangle::fraction_bits, Surface>(triangle, surface, target, rows, rows_after);
    else if (size == ActiveTriangle::Size::medium)
      walk<medium_triangle::fraction_bits, Surface>(triangle, surface, target, rows, rows_after);
    else
      return false;
    return true;
  }

 private:
  using Run = DepthRun<Depth, Pixel, form>;
  static constexpr bool fast =
      form == Form::fastest && !Counts::counting && Depth::bits == 16 && Depth::smaller && sizeof(Pixel) == 2;

  /// How a surface is passed to a function: by value if it fits a register.
  template <class Surface>
  using InFewRegisters = std::conditional_t<sizeof(Surface) <= sizeof(std::uint32_t), Surface, const Surface&>;

  /// A function of its own, so that its loop has every register.
  template <int FractionBits, class Surface, class Target>
  [[gnu::noinline]] static void walk(const ActiveTriangle& triangle, InFewRegisters<Surface> kept_surface,
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
          Counts::run(target, end - first);
          auto* depth = row.depth(first);
          Pixel* pixels = row.pixels(depth, first);
          if constexpr (SurfaceInBlocks<Surface>) {
            BlockRun<Depth, Pixel, form>::run(depth, pixels, end - first, z + dz * first, dz, surface,
                                              static_cast<std::int32_t>(first),
                                              [&](const auto& source) { return Counts::source(source, target); });
          } else if (FractionBits == small_triangle::fraction_bits || end - first <= Run::short_limit) {
            Run::short_run(depth, pixels, end - first, z + dz * (end - 1), dz,
                           Counts::source(surface.source(static_cast<std::int32_t>(end - 1)), target));
          } else {
            Run::long_run(depth, pixels, end - first, z + dz * first, dz,
                          Counts::source(surface.source(static_cast<std::int32_t>(first)), target));
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
      if (!triangle.flags.past_knee()) edges.put_third(triangle.flags.third_on_right());
    }
  }
};

}  // namespace spanline
