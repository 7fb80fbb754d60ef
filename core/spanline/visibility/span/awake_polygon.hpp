#pragma once
#include <cstdint>

#include "spanline/raster/active_triangle.hpp"
#include "spanline/raster/link.hpp"
#include "spanline/raster/plane_equation.hpp"
#include "spanline/raster/polygon_corners.hpp"
#include "spanline/raster/polygon_table.hpp"
#include "spanline/visibility/screen_surface.hpp"

namespace spanline {

/// A polygon that may be visible on the current row: an entry, with both edges, of the active-edge table AET, and of
/// the in-polygon list IPL (lecture 002, "Spanning Scan Line Algorithm").
///
/// Small and medium triangles step fixed-point columns, large ones exact edges with remainders. Both give the same
/// integer columns as in the z-buffers. The plane equation is computed when a comparison first needs it, since bounds
/// decide most comparisons.
///
/// Members are ordered for Thumb-1, whose load instructions reach offsets of 31 bytes, half-words or words.
struct AwakePolygon {
  std::uint8_t fraction_bits;  ///< of the columns in `fixed`; 0 if the edges are in `large`
  /// Which edge the third one replaces; an outline has none, and finds its next edges in the polygon table.
  enum class Third : std::uint8_t { on_left = 0, on_right = 1, outline = 2 } third;
  bool has_plane;             ///< whether `plane` has been computed
  bool has_surface;           ///< whether the surface that follows the record has been made
  std::int16_t origin;        ///< screen column where the columns of `fixed` are 0
  std::uint16_t right;        ///< column after the polygon's last on the current row, cut to the viewport
  std::uint16_t turn_row;     ///< row where the next edge replaces another, or where the polygon ends
  std::uint16_t end_row;      ///< the first row below the polygon, or the viewport's height
  std::uint16_t retry_row;    ///< the polygon does not try to sleep before this row
  std::uint16_t surface_row;  ///< row for which the surface was last stepped
  Link number;                ///< in the polygon table; of equally near polygons the lower number is in front
  Link group;                 ///< number of the polygon's group in the table
  union {
    FixedEdges fixed;
    LargeEdges large;
  };
  std::uint32_t nearest, farthest;  ///< bounds of the plane word over the polygon's pixels, rounding included
  AwakePolygon* next;               ///< the next in the in-polygon list or in the list of free records
  LinearFunction plane;             ///< plane word of depth, smaller is nearer, from column 0 of row 0

  [[nodiscard]] bool is_outline() const { return third == Third::outline; }
  [[nodiscard]] std::uint32_t depth_at(std::int32_t column, std::int32_t row) const {
    return plane.at_origin + plane.dx * word(column) + plane.dy * word(row);
  }

  /// Columns [left, right) of the row that lies `rows` below the current one, not cut to the viewport. That row must
  /// lie above `turn_row`.
  struct Columns {
    std::int32_t left, right;
  };
  [[nodiscard]] Columns columns_below(std::int32_t rows) const {
    if (fraction_bits == 0) return {large.left.x_below(rows), large.right.x_below(rows)};
    return {origin + signed_word((fixed.left + fixed.left_step * word(rows)) >> fraction_bits),
            origin + signed_word((fixed.right + fixed.right_step * word(rows)) >> fraction_bits)};
  }
};

/// The input from which polygons are woken and turned.
struct PolygonSource {
  PolygonTable& table;  ///< with buckets of one row each, which waking and sleeping change
  Viewport viewport;

  [[nodiscard]] PolygonCorners corners(const AwakePolygon& polygon) const { return entry(polygon).corners(); }
  [[nodiscard]] PolygonEntry entry(const AwakePolygon& polygon) const {
    return {table, table.groups[polygon.group], polygon.number};
  }
};

/// Computes the plane equation of a polygon. Smaller is nearer, whichever sense the depth format has.
template <class Depth>
[[gnu::noinline]] void make_plane(AwakePolygon& polygon, const PolygonSource& source) {
  using Smaller = DepthFormat<Depth::bits, typename Depth::Word, DepthSense::smaller_is_nearer>;
  const PolygonEntry entry = source.entry(polygon);
  polygon.plane =
      plane_equation_of(entry, entry.corners(), polygon.is_outline(), source.viewport).template depth<Smaller>();
  polygon.has_plane = true;
}

/// How far plane words may lie outside the range of the corners' depths: below the nearest and above the farthest
/// corner, in units of the plane word.
struct BoundMargin {
  std::uint32_t below, above;
};
/// The margins that hold for planes of this depth format. They allow for rounding of the plane: at most half a guard
/// unit for each pixel between it and the anchor, which is 1,024 in the largest picture, and 2 units of 24-bit depth or
/// 1 of 16-bit depth for the fast set-ups.
template <class Depth>
inline constexpr BoundMargin depth_margin{(1u << Depth::guard_bits) + 2048, 2 * (1u << Depth::guard_bits) + 2048};

/// Sets up edges, rows and bounds of polygon `number` of the table on `row`, which is one of the polygon's rows in the
/// viewport. Plane and surface are made later, when they are needed. Output: the first column, cut to the viewport.
[[nodiscard]] std::int32_t wake(AwakePolygon& polygon, const PolygonSource& source, Link number, std::int32_t row,
                                BoundMargin margin);

/// The same on the polygon's first row in the rows [first, end) of the picture, without bounds. Output: that row; `end`
/// if the polygon has none there.
[[nodiscard]] std::int32_t place(AwakePolygon& polygon, const PolygonSource& source, Link number, std::int32_t first,
                                 std::int32_t end);

/// Steps a polygon to `row`, which is its `turn_row`: the third edge replaces the one that ended. False if the polygon
/// ends there.
[[nodiscard]] bool turn(AwakePolygon& polygon, const PolygonSource& source, std::int32_t row);

/// Cuts a large polygon's columns to the viewport. Output: the first column.
[[nodiscard]] inline std::int32_t cut_columns(AwakePolygon& polygon, std::int32_t width) {
  const auto cut = [width](std::int32_t column) { return column < 0 ? 0 : column > width ? width : column; };
  polygon.right = static_cast<std::uint16_t>(cut(polygon.large.right.x));
  return cut(polygon.large.left.x);
}

/// As `cut_columns`, for fixed columns, which never leave the viewport.
[[nodiscard]] inline std::int32_t place_columns(AwakePolygon& polygon) {
  const int fraction_bits = polygon.fraction_bits;
  const std::int32_t origin = polygon.origin;
  polygon.right = static_cast<std::uint16_t>(origin + signed_word(polygon.fixed.right >> fraction_bits));
  return origin + signed_word(polygon.fixed.left >> fraction_bits);
}

}  // namespace spanline
