#pragma once
#include <cstdint>

#include "spanline/raster/active_triangle.hpp"
#include "spanline/raster/attribute_gradients.hpp"
#include "spanline/raster/depth_format.hpp"
#include "spanline/raster/edge.hpp"
#include "spanline/raster/gradients.hpp"
#include "spanline/raster/linear_function.hpp"
#include "spanline/raster/medium_triangle.hpp"
#include "spanline/raster/outline_setup.hpp"
#include "spanline/raster/plane_equation.hpp"
#include "spanline/raster/polygon_corners.hpp"
#include "spanline/raster/polygon_table.hpp"
#include "spanline/raster/small_triangle.hpp"
#include "spanline/raster/triangle.hpp"

namespace spanline {

/// Sets up a triangle of any size and position as a medium or large one. Output: `active`, and `area`, twice the area
/// in square sixteenths of a pixel. False if the triangle has no rows in the viewport or no area.
[[nodiscard]] bool set_up_large(Triangle& t, bool scissored, Viewport viewport, int depth_bits, ActiveTriangle& active,
                                std::int64_t& area);

/// Computes the depth function by the wide set-up, for a small triangle that is too thin or too steep for the small
/// one.
void fit_wide_depth(const Triangle& t, std::int64_t area, Viewport viewport, int depth_bits, ActiveTriangle& active);

/// The same for the reference triangle of an outline.
void fit_wide_outline_depth(Triangle t, Viewport viewport, int depth_bits, ActiveTriangle& active);

/// Replaces the edge of a large triangle that ends at its knee by the third edge, on the current row.
void put_third_large_edge(const PolygonCorners& polygon, ActiveTriangle& active);

/// Activates a polygon: sets up its edges and its plane on its first row inside the viewport. `make_surface` is called
/// with the attribute gradients, after the triangle was found to have rows. False if there is nothing to draw.
template <class Depth, class MakeSurface>
[[nodiscard, gnu::always_inline]] inline bool set_up(const ScreenVertex* p, const ScreenVertex* q,
                                                     const ScreenVertex* r, const PolygonGroup& group,
                                                     const Viewport& viewport, ActiveTriangle& active,
                                                     MakeSurface make_surface) {
  Triangle t = Triangle::from(p, q, r);
  const bool scissored = group.scissored && leaves_viewport(t);
  std::int32_t area = 0;
  if (!scissored && is_small(t, area)) {
    if (area < 0) {
      t.flip();
      area = -area;
    }
    const ThirdEdge third = ThirdEdge::of(t);
    const std::int32_t first = row_at(t.ay), knee_row = row_at(t.ay + third.y);
    const std::int32_t end = row_at(t.ay + third.y + third.dy);
    if (first >= end || area == 0) return false;
    const std::int32_t row_offset = 16 * first + 8 - t.ay;
    active.flags = {ActiveTriangle::Size::small, third.on_right, false};
    active.origin = small_triangle::origin_of(t);
    active.row = first;
    active.rows_to_knee = knee_row - first;
    active.rows_after_knee = end - knee_row;
    small_triangle::set_edges(t, third, row_offset, 16 * knee_row + 8 - t.ay - third.y, active.fixed);
    if (!fit_small_depth<Depth>(t, area, row_offset, active.depth)) {
      // A copy, so that `t` itself stays in registers in the usual case.
      const Triangle kept = t;
      fit_wide_depth(kept, area, viewport, Depth::bits, active);
    }
    make_surface(SmallAttributeGradients(t, area, row_offset, active, group.vertices, viewport));
  } else {
    Triangle kept = t;
    std::int64_t wide_area;
    if (!set_up_large(kept, scissored, viewport, Depth::bits, active, wide_area)) return false;
    make_surface(AttributeGradients(kept, wide_area, active, group.vertices, viewport));
  }
  if constexpr (!Depth::smaller) active.depth = active.depth.complemented();
  return true;
}

/// The attribute gradients of an outline that has been set up, by its reference triangle, whose corners are `corners`.
[[nodiscard]] AttributeGradients outline_gradients(const PolygonCorners& corners, const ActiveTriangle& active,
                                                   const ScreenVertex* first_vertex, const Viewport& viewport);

/// Activates an outline on its first row inside the viewport, as `set_up` does a triangle: its edges, and the plane of
/// its reference triangle with the words of PlaneEquation. False if there is nothing to draw. One function for all
/// shaders, which make their surfaces from `outline_gradients`.
template <class Depth>
[[nodiscard, gnu::noinline]] bool set_up_outline(const PolygonEntry& entry, const Viewport& viewport,
                                                 ActiveTriangle& active) {
  if (!set_up_outline(entry.outline(), viewport, active)) return false;
  const PolygonCorners corners = entry.corners();
  const Triangle t = Triangle::from(corners.corner[0], corners.corner[1], corners.corner[2]);
  std::int32_t area = 0;
  if (active.flags.size() == ActiveTriangle::Size::small && is_small(t, area)) {
    Triangle clockwise = t;
    if (area < 0) {
      clockwise.flip();
      area = -area;
    }
    const std::int32_t first = row_at(t.ay);
    LinearFunction depth;
    if (fit_small_depth<Depth>(clockwise, area, 16 * first + 8 - t.ay, depth)) {
      depth.at_origin +=
          depth.dx * word(active.origin - small_triangle::origin_of(t)) + depth.dy * word(active.row - first);
      active.depth = Depth::smaller ? depth : depth.complemented();
      return true;
    }
  }
  fit_wide_outline_depth(t, viewport, Depth::bits, active);
  if constexpr (!Depth::smaller) active.depth = active.depth.complemented();
  return true;
}

}  // namespace spanline
