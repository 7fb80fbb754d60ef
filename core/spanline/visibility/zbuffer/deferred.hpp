#pragma once
/// @file
/// Deferred shading, after Deering et al., "The Triangle Processor and Normal Vector Shader" (1988), and lecture 004.
/// The item buffer is that of Weghorst, Hooper and Greenberg, "Improved Computational Methods for Ray Tracing" (1984).
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <new>
#include <span>
#include <string_view>

#include "spanline/raster/link.hpp"
#include "spanline/raster/make_surface.hpp"
#include "spanline/raster/plane_equation.hpp"
#include "spanline/raster/polygon_corners.hpp"
#include "spanline/visibility/zbuffer/depth_buffer.hpp"

namespace spanline {

/// Deferred shading: the z-buffer draws the numbers of a band's polygons into an item buffer, and when the band is
/// finished, each pixel is shaded once, for its visible polygon. The pixels are the same bytes as those of the z-buffer
/// with the same depth format, since surfaces are functions of (x, y) alone.
///
/// Each run of one polygon along a row is shaded in one call. Surfaces are kept from row to row in a direct-mapped
/// cache of `Kept` places, indexed by the polygon's number; of two polygons with the same place, the later replaces the
/// earlier. Deferred shading pays where shading is expensive and polygons hide one another. It cannot draw see-through
/// polygons.
template <class Depth, class Pixel, class Shaders, bool Counting, unsigned Kept>
class DeferredDepthBuffer {
  static_assert(!Shaders::see_through, "an item buffer has one polygon a pixel");
  static_assert(Kept > 0 && (Kept & (Kept - 1)) == 0, "places are found by the low bits of a number");
  using Items = DepthBuffer<Depth, Link, typename Shaders::Items, Counting>;

  /// A cached surface, as functions of the whole screen.
  struct KeptSurface {
    Link polygon;         ///< the polygon that owns the surface, or no_link
    std::uint16_t row;    ///< row for which the surface was last stepped
    std::uint8_t shader;  ///< number of the polygon's shader
    typename Shaders::Surface surface;
  };

 public:
  using Target = BandTarget<Depth, Pixel>;
  static constexpr AlgorithmNeeds needs = AlgorithmNeeds::screen_polygons;
  static constexpr bool takes_outlines = true;
  static constexpr bool keeps_depth = true, tests_depth = true, takes_table_apart = false;
  static constexpr bool clears_ahead = false;                      // there is only one item buffer
  static constexpr std::string_view counter_names[] = {"shaded"};  ///< pixels shaded, background included

  struct Memory {
    typename Items::Memory depth_buffer;
    std::span<Link> items;        ///< number of the visible polygon at each pixel of a band, or no_link
    std::span<KeptSurface> kept;  ///< the cache of surfaces

    constexpr void take(Arena& arena, const Capacity& capacity) {
      depth_buffer.take(arena, capacity);
      items = arena.take<Link>(std::size_t{capacity.width} * capacity.band_lines);
      kept = arena.take<KeptSurface>(Kept);
    }
  };

  [[nodiscard]] static constexpr bool takes(const Capacity& capacity) { return Items::takes(capacity); }
  [[nodiscard]] static constexpr std::uint32_t bucket_lines(const Capacity& capacity) {
    return Items::bucket_lines(capacity);
  }

  DeferredDepthBuffer() = default;
  explicit DeferredDepthBuffer(const Memory& memory) : memory_(memory), items_(memory.depth_buffer) {}

  void begin_frame(const FrameInput& input) {
    items_.begin_frame(input);
    for (KeptSurface& kept : memory_.kept) kept.polygon = no_link;
  }

  template <class Fill>
  void clear(const Target& target, Fill fill) {
    items_.clear(item_target(target), fill);
  }

  template <class ShadingGroup, class Covered>
  [[gnu::noinline]] void draw_band(const PolygonTable& table, std::span<const ShadingGroup> shading, std::int32_t band,
                                   Viewport viewport, const Target& target, Covered&& covered) {
    items_.draw_band(table, shading, band, viewport, item_target(target), covered);
    const Link* item = memory_.items.data();
    Pixel* pixels = target.pixels;
    for (std::int32_t row = target.first_row; row < target.end_row; ++row) {
      for (const Link* const end = item + target.width; item != end;) {
        const Link* const begin = item;
        const Link owner = *item++;
        while (item != end && *item == owner) ++item;
        const auto length = static_cast<std::uint32_t>(item - begin);
        if (owner == no_link)
          Shaders::fill_apart(target.background, length, pixels);
        else
          shade(table, shading, owner, viewport, row - row_bias, target.width - static_cast<std::int32_t>(end - begin),
                length, pixels);
        pixels += length;
        if constexpr (Counting) target.counters->own[0] += length;
      }
    }
  }

  template <class ShadingGroup>
  void skip_band(const PolygonTable& table, std::span<const ShadingGroup> shading, std::int32_t band, Viewport viewport,
                 const Target& target) {
    items_.skip_band(table, shading, band, viewport, item_target(target));
  }

  [[nodiscard]] PoolShortage shortage(const FrameInput& input) const { return items_.shortage(input); }
  void note_peaks(PoolPeaks& peaks) const {
    items_.note_peaks(peaks);
    peaks.active += memory_.kept.size_bytes();
    peaks.depth_band += memory_.items.size_bytes();
  }

 private:
  [[nodiscard]] typename Items::Target item_target(const Target& target) const {
    return {target.depth, memory_.items.data(), target.width, target.first_row, target.end_row,
            no_link,      target.counters};
  }

  template <class ShadingGroup>
  void shade(const PolygonTable& table, std::span<const ShadingGroup> shading, Link polygon, Viewport viewport,
             std::int32_t row, std::int32_t column, std::uint32_t length, Pixel* pixels) {
    KeptSurface& kept = memory_.kept[polygon & (Kept - 1)];
    if (kept.polygon != polygon) make(kept, table, shading, polygon, viewport);
    Shaders::with(kept.shader, [&]<class Shader>() {
      auto& surface = kept.surface.template as<typename Shader::Surface>();
      if constexpr (Shader::interpolates || DividesOutlines<Shader>) {
        if (row != kept.row) surface.skip_rows(row - kept.row);
        kept.row = static_cast<std::uint16_t>(row);
      }
      Shaders::fill(surface, column, length, pixels);
    });
  }

  template <class ShadingGroup>
  [[gnu::noinline]] static void make(KeptSurface& kept, const PolygonTable& table,
                                     std::span<const ShadingGroup> shading, Link polygon, Viewport viewport) {
    const Link number = table.find_group(polygon);
    const PolygonGroup& group = table.groups[number];
    kept.polygon = polygon;
    kept.row = 0;
    kept.shader = shading[number].shader;
    Shaders::with(kept.shader, [&]<class Shader>() {
      auto* surface = new (kept.surface.bytes) typename Shader::Surface;
      make_screen_surface<Shader>(*surface, shading[number], {table, group, polygon}, table.is_outline(polygon),
                                  viewport);
    });
  }

  Memory memory_{};
  Items items_;
};

/// The visibility algorithm of a renderer: a depth buffer with deferred shading. It takes 2 more bytes for each pixel
/// of the band (4 where pointers have 64 bits), and memory for `Kept` surfaces. `Kept` is a power of two, best not
/// below the number of polygons visible on a row.
template <unsigned Kept = 32>
struct Deferred {
  template <class Depth, class Pixel, class Shaders, bool Counting>
  using Algorithm = DeferredDepthBuffer<Depth, Pixel, Shaders, Counting, Kept>;
};

}  // namespace spanline
