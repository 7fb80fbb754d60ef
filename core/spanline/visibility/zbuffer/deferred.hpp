#pragma once
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

/// Deferred shading (lecture 004): the z-buffer draws a band's polygon numbers into an item buffer, and each pixel is
/// shaded once, when the band is finished, whatever was drawn over it before. The same bytes as the z-buffer at the
/// same depth: surfaces are functions of (x, y), whoever makes them.
///
/// Runs of one polygon along a row are shaded at once. Their surfaces are made anew for each band, and kept from row to
/// row in `Kept` places, a polygon's by its number; where two polygons share a place, one drives the other out and is
/// made again. It pays where shading is dear and polygons hide one another; nothing is seen through.
template <class Depth, class Pixel, class Shaders, bool Counting, unsigned Kept>
class DeferredDepthBuffer {
  static_assert(!Shaders::see_through, "an item buffer has one polygon a pixel");
  static_assert(Kept > 0 && (Kept & (Kept - 1)) == 0, "places are found by the low bits of a number");
  using Items = DepthBuffer<Depth, Link, typename Shaders::Items, Counting>;

  /// A surface as functions of the whole screen.
  struct KeptSurface {
    Link polygon;
    std::uint16_t row;  ///< on which the surface stands
    std::uint8_t shader;
    typename Shaders::Surface surface;
  };

 public:
  using Target = BandTarget<Depth, Pixel>;
  static constexpr AlgorithmNeeds needs = AlgorithmNeeds::screen_polygons;
  static constexpr bool keeps_depth = true, tests_depth = true, takes_table_apart = false;
  static constexpr bool clears_ahead = false;                      // there is one item buffer
  static constexpr std::string_view counter_names[] = {"shaded"};  ///< pixels that were shaded, the background's too

  struct Memory {
    typename Items::Memory depth_buffer;
    std::span<Link> items;  ///< of a band
    std::span<KeptSurface> kept;

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
      if constexpr (Shader::interpolates) {
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
    const PolygonCorners corners = table.corners(group, polygon);
    kept.polygon = polygon;
    kept.row = 0;
    kept.shader = shading[number].shader;
    Shaders::with(kept.shader, [&]<class Shader>() {
      auto* surface = new (kept.surface.bytes) typename Shader::Surface;
      if constexpr (Shader::interpolates) {
        const auto [a, b, c] = corners.corner;
        make_surface<Shader>(*surface, shading[number], corners, PlaneEquation(a, b, c, group.vertices, viewport));
      } else {
        Shader::make(*surface, shading[number], corners);
      }
    });
  }

  Memory memory_{};
  Items items_;
};

/// Visibility of a renderer: a depth buffer whose pixels are shaded once, when it is known whose they are. 2 bytes a
/// pixel of the band more (4 where pointers have 64 bits), and `Kept` surfaces, a power of two: as many as there are
/// polygons in a row is best.
template <unsigned Kept = 32>
struct Deferred {
  template <class Depth, class Pixel, class Shaders, bool Counting>
  using Algorithm = DeferredDepthBuffer<Depth, Pixel, Shaders, Counting, Kept>;
};

}  // namespace spanline
