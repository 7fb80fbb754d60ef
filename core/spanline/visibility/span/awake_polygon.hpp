#pragma once
#include <cstdint>

#include "spanline/raster/active_triangle.hpp"
#include "spanline/raster/link.hpp"
#include "spanline/raster/plane_equation.hpp"
#include "spanline/raster/polygon_corners.hpp"
#include "spanline/raster/polygon_table.hpp"

namespace spanline {

/// A polygon that the current row may show: an entry of the active-edge table AET, both edges together, and of the
/// in-polygon list IPL (lecture 002, "Spanning Scan Line Algorithm").
///
/// Small and medium triangles step fixed-point columns, large ones exact edges with remainders; each gives the integers
/// that the z-buffers use. The plane equation is made when a comparison first asks for it: bounds decide most.
///
/// Members are ordered for Thumb-1, whose loads reach 31 bytes, 31 half-words and 31 words.
struct AwakePolygon {
  std::uint8_t fraction_bits;  ///< of `fixed` columns; 0: the edges are in `large`
  bool third_on_right;         ///< the third edge is on the right
  bool has_plane;
  bool has_surface;
  std::int16_t origin;        ///< screen column that fixed columns count from
  std::uint16_t right;        ///< end of the columns on the current row, cut to the viewport
  std::uint16_t turn_row;     ///< row where an edge gives way to the third, or the polygon ends
  std::uint16_t end_row;      ///< the first row below it, or the viewport's height
  std::uint16_t retry_row;    ///< no attempt to sleep before this row
  std::uint16_t surface_row;  ///< row that the surface stands on
  Link number;                ///< in the polygon table: settles ties, the earlier wins
  Link group;
  union {
    FixedEdges fixed;
    LargeEdges large;
  };
  std::uint32_t nearest, farthest;  ///< bounds of the plane word over the polygon's pixels, its rounding included
  AwakePolygon* next;               ///< in the in-polygon list, or in the list of free records
  LinearFunction plane;             ///< depth, smaller is nearer, at column 0 of row 0

  [[nodiscard]] std::uint32_t depth_at(std::int32_t column, std::int32_t row) const {
    return plane.at_origin + plane.dx * word(column) + plane.dy * word(row);
  }

  /// Columns of the row that lies `rows` below the current one, uncut; only above the next turn.
  struct Columns {
    std::int32_t left, right;
  };
  [[nodiscard]] Columns columns_below(std::int32_t rows) const {
    if (fraction_bits == 0) return {large.left.x_below(rows), large.right.x_below(rows)};
    return {origin + signed_word((fixed.left + fixed.left_step * word(rows)) >> fraction_bits),
            origin + signed_word((fixed.right + fixed.right_step * word(rows)) >> fraction_bits)};
  }
};

/// Where polygons are found: what waking and turning them takes.
struct PolygonSource {
  PolygonTable& table;  ///< buckets of one row, which waking and sleeping take apart
  Viewport viewport;

  [[nodiscard]] PolygonCorners corners(const AwakePolygon& polygon) const {
    return table.corners(table.groups[polygon.group], polygon.number);
  }
  [[nodiscard]] PlaneEquation plane_equation(const AwakePolygon& polygon) const {
    const auto [a, b, c] = corners(polygon).corner;
    return {a, b, c, table.groups[polygon.group].vertices, viewport};
  }
};

/// Makes the plane equation of a polygon, smaller is nearer whatever the format's sense.
template <class Depth>
[[gnu::noinline]] void make_plane(AwakePolygon& polygon, const PolygonSource& source) {
  using Smaller = DepthFormat<Depth::bits, typename Depth::Word, DepthSense::smaller_is_nearer>;
  polygon.plane = source.plane_equation(polygon).template depth<Smaller>();
  polygon.has_plane = true;
}

/// How far a plane word may lie outside the depths of its corners: below the nearest and above the farthest, in plane
/// words.
struct BoundMargin {
  std::uint32_t below, above;
};

/// Places polygon `number` of the table on `row`, one of its rows in the viewport: edges, rows and bounds. Plane and
/// surface are left for later. Output: the first column, cut to the viewport.
[[nodiscard]] std::int32_t wake(AwakePolygon& polygon, const PolygonSource& source, Link number, std::int32_t row,
                                BoundMargin margin);

/// Steps to `row`, its `turn_row`: puts the third edge in place. False where the polygon ends there.
[[nodiscard]] bool turn(AwakePolygon& polygon, const PolygonSource& source, std::int32_t row);

/// Cuts a large polygon's columns to the viewport. Output: the first column.
[[nodiscard]] inline std::int32_t cut_columns(AwakePolygon& polygon, std::int32_t width) {
  const auto cut = [width](std::int32_t column) { return column < 0 ? 0 : column > width ? width : column; };
  polygon.right = static_cast<std::uint16_t>(cut(polygon.large.right.x));
  return cut(polygon.large.left.x);
}

/// The same for fixed columns, which never leave the viewport.
[[nodiscard]] inline std::int32_t place_columns(AwakePolygon& polygon) {
  const int fraction_bits = polygon.fraction_bits;
  const std::int32_t origin = polygon.origin;
  polygon.right = static_cast<std::uint16_t>(origin + signed_word(polygon.fixed.right >> fraction_bits));
  return origin + signed_word(polygon.fixed.left >> fraction_bits);
}

}  // namespace spanline
