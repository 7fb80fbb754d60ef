#pragma once
/// @file
/// The z-buffer, after E. Catmull, "A Subdivision Algorithm for Computer Display of Curved Surfaces" (1974), and
/// lecture 002, "Z-buffer: Scanline" and "Incremental Scanline".
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

#include "spanline/raster/active_triangle.hpp"
#include "spanline/raster/attribute_gradients.hpp"
#include "spanline/raster/fan_diagonals.hpp"
#include "spanline/raster/link.hpp"
#include "spanline/raster/make_surface.hpp"
#include "spanline/raster/polygon_corners.hpp"
#include "spanline/raster/polygon_table.hpp"
#include "spanline/raster/row_stepper.hpp"
#include "spanline/raster/surface_blocks.hpp"
#include "spanline/raster/triangle_setup.hpp"
#include "spanline/visibility/algorithm.hpp"
#include "spanline/visibility/covered_triangles.hpp"
#include "spanline/visibility/zbuffer/active_polygons_needed.hpp"
#include "spanline/visibility/zbuffer/fragment_lists.hpp"
#include "spanline/visibility/zbuffer/see_through_rows.hpp"
#include "spanline/visibility/zbuffer/triangle_rows.hpp"

namespace spanline {

/// A polygon that continues below the band in which it was drawn: an entry of the active-edge table between bands.
template <class Surface>
struct ActiveEntry {
  ActiveTriangle triangle;
  Surface surface;
  Link polygon;
  Link next;  ///< the next active polygon in order of submission, or the next free entry
};

/// The z-buffer over a band of lines. It is called `zbuffer` with one band as high as the picture and `scanline-z` with
/// lower bands.
///
/// Polygons are drawn band by band, and inside a band in order of submission: those that continue from the band above
/// are merged with those that start in it. So the depth tests at a pixel have the same order with every band height,
/// which draws the same bytes.
template <class Depth, class Pixel, class Shaders, bool Counting, bool Bounded = false>
class DepthBuffer {
 public:
  using Surface = typename Shaders::Surface;
  using Entry = ActiveEntry<Surface>;
  using Target = BandTarget<Depth, Pixel>;
  using Rows = TriangleRows<Depth, Pixel, Counting, Bounded>;

  using Fragments =
      std::conditional_t<Shaders::see_through, FragmentLists<Depth, Pixel, typename Shaders::Layer>, NoFragmentLists>;
  using Layers = SeeThroughRows<Depth, Pixel, Fragments, Counting>;
  using Bounds = std::conditional_t<Bounded, DepthBounds<Depth>, NoDepthBounds>;

  static constexpr AlgorithmNeeds needs = AlgorithmNeeds::screen_polygons;
  static constexpr bool takes_outlines = true;
  static constexpr bool keeps_depth = true, tests_depth = true, takes_table_apart = false, clears_ahead = !Bounded;
  static constexpr std::span<const std::string_view> counter_names{};

  /// The memory of the algorithm, cut off an arena: entries for polygons that cross a band's lower edge (none are
  /// needed for a single band), depth bounds and fragments.
  struct Memory {
    std::span<Entry> active;
    [[no_unique_address]] Bounds bounds;
    [[no_unique_address]] Fragments fragments;

    constexpr void take(Arena& arena, const Capacity& capacity) {
      active = arena.take<Entry>(capacity.active);
      bounds.take(arena, capacity.width, capacity.band_lines);
      fragments.take(arena, std::size_t{capacity.width} * capacity.band_lines, capacity.fragments);
    }
  };

  /// Whether links can number that many active polygons and fragments.
  [[nodiscard]] static constexpr bool takes(const Capacity& capacity) {
    return capacity.active < no_link && capacity.fragments < no_link;
  }
  /// The polygon table's buckets hold a band each.
  [[nodiscard]] static constexpr std::uint32_t bucket_lines(const Capacity& capacity) { return capacity.band_lines; }

  DepthBuffer() = default;
  explicit DepthBuffer(const Memory& memory)
      : pool_(memory.active), bounds_(memory.bounds), fragments_(memory.fragments) {}

  /// Before the first band of a frame.
  void begin_frame(const FrameInput& /*input*/) {
    free_ = no_link;
    used_ = peak_ = 0;
    active_ = no_link;
    overflowed_ = false;
    fragments_.begin_frame();
  }

  /// Fills a band's pixels with the background and its depths with the clear value, by calls of `fill(value, count,
  /// words)`.
  template <class Fill>
  void clear(const Target& target, Fill fill) {
    const auto pixels = static_cast<std::uint32_t>(target.width * (target.end_row - target.first_row));
    fill(target.background, pixels, target.pixels);
    fill(Depth::clear, pixels, target.depth);
    bounds_.clear();
  }

  /// Draws one band. `shading` is parallel to the table's groups. `covered(id)` is called for each polygon that covers
  /// a pixel centre, only when counting.
  template <class ShadingGroup, class Covered>
  [[gnu::noinline]] void draw_band(const PolygonTable& table, std::span<const ShadingGroup> shading, std::int32_t band,
                                   Viewport viewport, const Target& whole_target, Covered&& covered) {
    const TargetWithBounds target = with_bounds(whole_target);
    walk_band<true>(table, shading, band, viewport, target, covered);
    fragments_.finish_band(target.depth, target.pixels,
                           static_cast<std::size_t>(target.width * (target.end_row - target.first_row)));
  }

  /// Steps over a band that another core draws. Only the rows and the width of `target` are used.
  template <class ShadingGroup>
  [[gnu::noinline]] void skip_band(const PolygonTable& table, std::span<const ShadingGroup> shading, std::int32_t band,
                                   Viewport viewport, const Target& target) {
    const TargetWithBounds bounded = with_bounds(target);
    walk_band<false>(table, shading, band, viewport, bounded, [](std::uint32_t) {});
  }

  /// Tells whether polygons were cut off at a band's edge for lack of an entry, or fragments were blended early for
  /// lack of room.
  [[nodiscard]] PoolShortage shortage(const FrameInput& input) const {
    if (overflowed_) return {Pool::active, active_polygons_needed(input.table, input.viewport, input.band_lines)};
    if (fragments_.overflowed()) return {Pool::fragments, fragments_.wanted()};
    return {};
  }
  void note_peaks(PoolPeaks& peaks) const {
    peaks.active = peak_ * sizeof(Entry);
    peaks.fragments = fragments_.peak_bytes();
  }

 private:
  /// The target with its depth bounds, or the target itself without bounds.
  using RowsTarget = typename Rows::Target;
  using TargetWithBounds = std::conditional_t<Bounded, RowsTarget, const Target&>;
  [[nodiscard]] TargetWithBounds with_bounds(const Target& target) {
    if constexpr (Bounded) {
      return {target, &bounds_};
    } else {
      return target;
    }
  }

  /// Merges the polygons that continue from the band above with those that begin in this band, in order of submission.
  template <bool Drawn, class ShadingGroup, class Covered>
  [[gnu::always_inline]] void walk_band(const PolygonTable& table, std::span<const ShadingGroup> shading,
                                        std::int32_t band, Viewport viewport, const RowsTarget& target,
                                        Covered&& covered) {
    Job<ShadingGroup> job{.triangle = {},
                          .table = table,
                          .shading = shading.data(),
                          .group = table.groups.data(),
                          .viewport = viewport,
                          .target = target,
                          .group_end = 0};
    job.find_group_end();
    BucketCursor starting(table, band);
    Link* link = &active_;
    for (;;) {
      const Link continuing = *link == no_link ? no_link : pool_[*link].polygon;
      // Polygons that start here and were submitted before `continuing`; they are inserted before it in the list.
      for (Link polygon = starting.polygon(); polygon < continuing; polygon = starting.next()) {
        job.find_group(polygon);
        begin<Drawn>(job, polygon, link, covered);
      }
      if (continuing == no_link) break;
      job.find_group(continuing);
      go_on<Drawn>(job, link);
    }
  }

  /// The data that the polygons of a band share, the group of the current polygon, and room to set that polygon up.
  template <class ShadingGroup>
  struct Job {
    ActiveTriangle triangle;  // first, since Thumb-1 reaches near fields with shorter instructions
    const PolygonTable& table;
    const ShadingGroup* shading;
    const PolygonGroup* group;
    Viewport viewport;
    const RowsTarget& target;
    Link group_end;  ///< number of the first polygon after the group

    /// Number of the group's shader.
    [[nodiscard]] std::uint8_t shader() const {
      if constexpr (requires { Shaders::without_holes; }) {
        if (!group->has_holes) return Shaders::without_holes;
      }
      return shading->shader;
    }
    /// Moves to the group of `polygon`. Polygons come in order of submission, so the group never lies before the
    /// current one.
    void find_group(Link polygon) {
      while (polygon >= group_end) {
        ++group;
        ++shading;
        find_group_end();
      }
    }
    void find_group_end() {
      const bool is_last = group == table.groups.data() + table.group_count - 1;
      group_end = is_last ? no_link : group[1].first;
    }
  };

  template <bool Drawn, class ShadingGroup, class Covered>
  [[gnu::always_inline]] inline void begin(Job<ShadingGroup>& job, Link polygon, Link*& link, Covered& covered) {
    const auto entry_of = [&] { return PolygonEntry{job.table, *job.group, polygon}; };
    if constexpr (!Drawn) {
      if (row_range(entry_of()).end + row_bias <= job.target.end_row) return;
    }
    if (job.table.is_outline(polygon)) return begin_outline<Drawn>(job, polygon, link, covered);
    const PolygonCorners corners = job.table.corners(*job.group, polygon);
    Shaders::with(
        job.shader(), [&]<class Shader>() __attribute__((always_inline)) {
          typename Shader::Surface surface;
          const auto [a, b, c] = corners.corner;
          if constexpr (SurfaceInBlocks<typename Shader::Surface>) {
            if (!activate_in_blocks<Shader>(corners, job, surface)) return;
          } else if constexpr (Shader::interpolates) {
            if (!activate<Shader>(a, b, c, job, surface)) return;
          } else {
            if (!activate_plain(a, b, c, job)) return;
            Shader::make(surface, *job.shading, corners);
          }
          if constexpr (requires { surface.item; }) surface.item = polygon;
          if constexpr (Counting && Drawn) {
            if (covers_pixels(job.triangle, entry_of, job.viewport)) covered(job.shading->first_id + corners.triangle);
          }
          if (pass_rows<Drawn, Shader>(job.triangle, surface, job.target, entry_of))
            keep(job.triangle, surface, polygon, link);
        });
  }

  /// As `begin`, for an outline. Not inlined, so that triangles pay nothing for it.
  template <bool Drawn, class ShadingGroup, class Covered>
  [[gnu::noinline]] void begin_outline(Job<ShadingGroup>& job, Link polygon, Link*& link, Covered& covered) {
    const PolygonEntry entry{job.table, *job.group, polygon};
    if (!set_up_outline<Depth>(entry, job.viewport, job.triangle)) return;
    if constexpr (Counting && Drawn)
      tell_covered(entry, job.viewport, job.triangle.row, job.shading->first_id + entry.corners().triangle, covered);
    Shaders::with(job.shader(), [&]<class Shader>() {
      typename Shader::Surface surface;
      make_outline_surface<Shader>(surface, job, entry);
      if constexpr (requires { surface.item; }) surface.item = polygon;
      if (pass_outline<Drawn, Shader>(job.triangle, surface, job.target, entry))
        keep(job.triangle, surface, polygon, link);
    });
  }
  template <class Shader, class ShadingGroup>
  [[gnu::noinline]] static void make_outline_surface(typename Shader::Surface& surface, const Job<ShadingGroup>& job,
                                                     const PolygonEntry& entry) {
    const PolygonCorners corners = entry.corners();
    if constexpr (Shader::interpolates)
      make_surface<Shader>(surface, *job.shading, corners,
                           outline_gradients(corners, job.triangle, entry.group.vertices, job.viewport));
    else
      Shader::make(surface, *job.shading, corners);
    if constexpr (DividesOutlines<Shader>)
      Shader::divide(surface, FanDiagonals(entry.outline()), job.triangle.origin, job.triangle.row - row_bias);
  }

  /// Draws the rows of a polygon that lie in the band, or steps over them. True if the polygon continues below the
  /// band.
  template <bool Drawn, class Shader, class EntryOf>
  [[gnu::always_inline]] bool pass_rows(ActiveTriangle& triangle, typename Shader::Surface& surface,
                                        const RowsTarget& target, EntryOf entry_of) {
    if constexpr (!Drawn) {
      return skip_rows(triangle, surface, target.end_row, entry_of);
    } else if constexpr (SeeThrough<Shader>) {
      if constexpr (Bounded)
        target.bounds->touch(triangle.row - target.first_row,
                             std::min(triangle.end_row(), target.end_row) - triangle.row);
      return Layers::draw(triangle, surface, target, fragments_, entry_of);
    } else {
      return Rows::draw(triangle, surface, target, entry_of);
    }
  }
  /// The same for an outline.
  template <bool Drawn, class Shader>
  [[gnu::noinline]] bool pass_outline(ActiveTriangle& outline, typename Shader::Surface& surface,
                                      const RowsTarget& target, const PolygonEntry& entry) {
    if constexpr (!Drawn) {
      const std::int32_t rows = target.end_row - outline.row;
      if (!skip_outline_rows(outline, target.end_row, entry.outline())) return false;
      surface.skip_rows(rows);
      return true;
    } else if constexpr (SeeThrough<Shader>) {
      return pass_rows<Drawn, Shader>(outline, surface, target, [&] { return entry; });
    } else {
      return Rows::draw_outline(outline, surface, target, entry);
    }
  }

  /// Sets up the edges, the plane and the surface of a polygon. Not inlined, since this set-up needs every register.
  template <class Shader, class ShadingGroup>
  [[gnu::noinline]] static bool activate(const ScreenVertex* a, const ScreenVertex* b, const ScreenVertex* c,
                                         Job<ShadingGroup>& job, typename Shader::Surface& surface) {
    return set_up<Depth>(
        a, b, c, *job.group, job.viewport, job.triangle, [&](const auto& gradients) __attribute__((always_inline)) {
          Shader::make(surface, *job.shading, gradients);
        });
  }
  template <class Shader, class ShadingGroup>
  [[gnu::noinline]] static bool activate_in_blocks(const PolygonCorners& corners, Job<ShadingGroup>& job,
                                                   typename Shader::Surface& surface) {
    const auto [a, b, c] = corners.corner;
    return set_up<Depth>(a, b, c, *job.group, job.viewport, job.triangle, [&](const AttributeGradients& gradients) {
      Shader::make(surface, *job.shading, corners, gradients);
    });
  }
  /// Sets up the edges and the plane of a polygon whose surface does not interpolate.
  template <class ShadingGroup>
  [[gnu::always_inline]] static inline bool activate_plain(const ScreenVertex* a, const ScreenVertex* b,
                                                           const ScreenVertex* c, Job<ShadingGroup>& job) {
    return set_up<Depth>(a, b, c, *job.group, job.viewport, job.triangle, [](const auto&) {});
  }

  /// Draws the active polygon at *link, removes it from the list if it ends, and moves `link` to the next one.
  template <bool Drawn, class ShadingGroup>
  void go_on(Job<ShadingGroup>& job, Link*& link) {
    Entry& entry = pool_[*link];
    const auto entry_of = [&] { return PolygonEntry{job.table, *job.group, entry.polygon}; };
    const bool goes_on = Shaders::with(job.shader(), [&]<class Shader>() {
      auto& surface = entry.surface.template as<typename Shader::Surface>();
      return entry.triangle.flags.outline()
                 ? pass_outline<Drawn, Shader>(entry.triangle, surface, job.target, entry_of())
                 : pass_rows<Drawn, Shader>(entry.triangle, surface, job.target, entry_of);
    });
    if (goes_on) {
      link = &entry.next;
    } else {
      const Link done = *link;
      *link = entry.next;
      entry.next = free_;
      free_ = done;
    }
  }

  /// Inserts a polygon that continues below the band into the list, at its place in the order of submission.
  template <class ShaderSurface>
  void keep(const ActiveTriangle& triangle, const ShaderSurface& surface, Link polygon, Link*& link) {
    Link entry = free_;
    if (entry != no_link) {
      free_ = pool_[entry].next;
    } else if (used_ < pool_.size()) {
      entry = used_++;
      peak_ = used_;
    } else {
      overflowed_ = true;
      return;
    }
    Entry& kept = pool_[entry];
    kept.triangle.assign(triangle);
    new (kept.surface.bytes) ShaderSurface(surface);
    kept.polygon = polygon;
    kept.next = *link;
    *link = entry;
    link = &kept.next;
  }

  /// Whether the triangle covers any pixel centre inside the viewport.
  template <class EntryOf>
  static bool covers_pixels(ActiveTriangle triangle, EntryOf entry_of, Viewport viewport) {
    while (triangle.rows_to_knee + triangle.rows_after_knee > 0) {
      const RowColumns columns = step_row(triangle, entry_of);
      const std::int32_t first = triangle.origin + columns.first, end = triangle.origin + columns.end;
      if (std::min(end, viewport.width) > std::max<std::int32_t>(first, 0)) return true;
    }
    return false;
  }

  std::span<Entry> pool_;
  [[no_unique_address]] Bounds bounds_;
  [[no_unique_address]] Fragments fragments_;
  Link free_ = no_link;  ///< list of entries that are free again
  Link used_ = 0;        ///< entries that were ever used in the frame
  Link peak_ = 0;
  Link active_ = no_link;    ///< list of active polygons, in order of submission
  bool overflowed_ = false;  ///< whether a polygon found no entry in the frame
};

/// The visibility algorithm of a renderer: a depth buffer with bounds for tiles of 32 columns, for scenes of large
/// polygons that hide one another. It draws the same bytes as ZBuffer. Depths take 1/16 more memory, and small polygons
/// a few more instructions each.
struct BoundedZBuffer {
  template <class Depth, class Pixel, class Shaders, bool Counting>
  using Algorithm = DepthBuffer<Depth, Pixel, Shaders, Counting, true>;
};

/// The visibility algorithm of a renderer: a depth buffer over the whole picture or over bands of lines.
struct ZBuffer {
  template <class Depth, class Pixel, class Shaders, bool Counting>
  using Algorithm = DepthBuffer<Depth, Pixel, Shaders, Counting>;
};

}  // namespace spanline
