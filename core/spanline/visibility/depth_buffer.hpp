#pragma once
#include <cstdint>
#include <span>

#include "spanline/raster/active_triangle.hpp"
#include "spanline/raster/polygon_table.hpp"
#include "spanline/visibility/triangle_rows.hpp"

namespace spanline {

/// A polygon that goes on below the band in which it was drawn: an entry of the active-edge table between bands.
template <class Surface>
struct ActiveEntry {
  ActiveTriangle triangle;
  Surface surface;
  Link polygon;
  Link next;  ///< the next active polygon in order of submission, or the next free entry
};

/// The z-buffer over one band of lines: `zbuffer` is one band as high as the picture, `scanline-z` any other height
/// (lecture 002, "Z-buffer: Scanline" and "Incremental Scanline").
///
/// Polygons are drawn band by band, and inside a band in order of submission: those that came in from the band above
/// merge with those that start here. So every band height does the same depth tests in the same order, and draws the
/// same bytes.
template <class Depth, class Pixel, class Shaders, bool Counting>
class DepthBuffer {
 public:
  using Surface = typename Shaders::Surface;
  using Entry = ActiveEntry<Surface>;
  using Target = BandTarget<Depth, Pixel>;
  using Rows = TriangleRows<Depth, Pixel, Counting>;

  /// `pool` holds the polygons that cross a band's lower edge; none is needed where there is one band.
  explicit DepthBuffer(std::span<Entry> pool) : pool_(pool) {}

  /// Before the first band of a frame.
  void begin_frame() {
    free_ = no_link;
    used_ = peak_ = 0;
    active_ = no_link;
    overflowed_ = false;
  }

  /// Draws one band. `shading` is parallel to the table's groups; `covered(id)` is told of each polygon that
  /// is activated (for Counting only).
  template <class ShadingGroup, class Covered>
  void draw_band(const PolygonTable& table, std::span<const ShadingGroup> shading, std::int32_t band, Viewport viewport,
                 const Target& target, Covered&& covered) {
    BucketCursor starting(table, band);
    Link group = 0;
    Link* link = &active_;
    for (;;) {
      const Link continuing = *link == no_link ? no_link : pool_[*link].polygon;
      const Link beginning = starting.polygon();
      if (continuing == no_link && beginning == no_link) break;
      if (beginning < continuing) {
        starting.advance();
        group = table.group_of(beginning, group);
        begin(table, shading[group], group, beginning, viewport, target, link, covered);
      } else {
        group = table.group_of(continuing, group);
        if (go_on(table, shading[group], group, pool_[*link], target)) {
          link = &pool_[*link].next;
        } else {
          const Link done = *link;
          *link = pool_[done].next;
          pool_[done].next = free_;
          free_ = done;
        }
      }
    }
  }

  /// Whether polygons had to be cut off at a band's edge because the pool was full.
  [[nodiscard]] bool overflowed() const { return overflowed_; }
  /// Entries in use at most.
  [[nodiscard]] Link peak() const { return peak_; }

 private:
  template <class ShadingGroup, class Covered>
  void begin(const PolygonTable& table, const ShadingGroup& shading, Link group, Link polygon, Viewport viewport,
             const Target& target, Link*& link, Covered& covered) {
    const PolygonGroup& polygon_group = table.groups[group];
    const PolygonCorners corners = table.corners(polygon_group, polygon);
    Shaders::with(shading.shader, [&]<class Shader>() {
      ActiveTriangle triangle;
      typename Shader::Surface surface;
      if (!set_up<Depth>(corners, polygon_group, viewport, triangle, [&](const AttributeGradients& gradients) {
            Shader::make(surface, shading, corners, gradients);
          }))
        return;
      if constexpr (Counting) {
        if (covers_pixels(triangle, corners, viewport)) covered(shading.first_id + corners.triangle);
      }
      if (Rows::draw(triangle, surface, target, [&] { return corners; })) keep(triangle, surface, polygon, link);
    });
  }

  template <class ShadingGroup>
  bool go_on(const PolygonTable& table, const ShadingGroup& shading, Link group, Entry& entry, const Target& target) {
    return Shaders::with(shading.shader, [&]<class Shader>() {
      return Rows::draw(entry.triangle, entry.surface.template as<typename Shader::Surface>(), target,
                        [&] { return table.corners(table.groups[group], entry.polygon); });
    });
  }

  /// Puts a polygon that goes on below the band into the list, at its place in the order of submission.
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
    kept.triangle = triangle;
    new (kept.surface.bytes) ShaderSurface(surface);
    kept.polygon = polygon;
    kept.next = *link;
    *link = entry;
    link = &kept.next;
  }

  /// Whether any pixel centre lies inside, on the viewport's rows and columns.
  static bool covers_pixels(ActiveTriangle triangle, const PolygonCorners& corners, Viewport viewport) {
    while (triangle.rows_to_bend + triangle.rows_after_bend > 0) {
      std::int32_t first, end;
      if (!step_row(triangle, corners, first, end)) continue;
      if (std::min(end, viewport.width) > std::max<std::int32_t>(first, 0)) return true;
    }
    return false;
  }

  /// The columns [first, end) of the current row, and a step down; false where only the bend was made.
  static bool step_row(ActiveTriangle& triangle, const PolygonCorners& corners, std::int32_t& first,
                       std::int32_t& end) {
    if (triangle.rows_to_bend == 0 && !triangle.bent) {
      triangle.bent = true;
      if (!triangle.is_small) {
        bend_large(corners, triangle);
      } else if (triangle.right_bends) {
        triangle.small.right = triangle.small.bend;
        triangle.small.right_step = triangle.small.bend_step;
      } else {
        triangle.small.left = triangle.small.bend;
        triangle.small.left_step = triangle.small.bend_step;
      }
      return false;
    }
    if (triangle.is_small) {
      first = triangle.origin + signed_word(small_triangle::column(triangle.small.left));
      end = triangle.origin + signed_word(small_triangle::column(triangle.small.right));
      triangle.small.left += triangle.small.left_step;
      triangle.small.right += triangle.small.right_step;
    } else {
      first = triangle.large.left.x;
      end = triangle.large.right.x;
      triangle.large.left.next_row();
      triangle.large.right.next_row();
    }
    ++triangle.row;
    --(triangle.rows_to_bend != 0 ? triangle.rows_to_bend : triangle.rows_after_bend);
    return true;
  }

  std::span<Entry> pool_;
  Link free_ = no_link;
  Link used_ = 0;
  Link peak_ = 0;
  Link active_ = no_link;
  bool overflowed_ = false;
};

}  // namespace spanline
