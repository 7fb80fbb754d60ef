#pragma once
#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>

#include "spanline/raster/fan_records.hpp"
#include "spanline/raster/half_plane.hpp"
#include "spanline/raster/link.hpp"
#include "spanline/raster/outline.hpp"
#include "spanline/raster/outline_header.hpp"
#include "spanline/raster/polygon_corners.hpp"
#include "spanline/raster/row_columns.hpp"
#include "spanline/raster/screen_vertex.hpp"
#include "spanline/raster/span.hpp"

namespace spanline {

/// Set in PolygonReference::source if the low bits are the number of a record in the pool of fans.
inline constexpr Link fan_flag = static_cast<Link>(Link{1} << (std::numeric_limits<Link>::digits - 1));

/// One polygon of the polygon table, in order of submission.
struct PolygonReference {
  Link next;    ///< next polygon of the same bucket, in order of submission; the last links to the first
  Link source;  ///< triangle number within its group, or fan_flag | number of its first record
};

/// Polygons that share a vertex array: an instance of a mesh, or triangles given in screen coordinates.
struct PolygonGroup {
  const ScreenVertex* vertices = nullptr;
  const std::uint16_t* indices = nullptr;  ///< three a triangle; if null, triangle i has vertices 3i to 3i + 2
  Link first = 0;                          ///< number of its first polygon
  std::uint32_t first_id = 0;              ///< id of its triangle 0
  bool scissored = false;                  ///< whether a polygon may leave the viewport
  bool see_through = false;                ///< whether pixels behind a polygon may be visible through it
  bool has_holes = false;                  ///< whether a texture cuts holes into its polygons
};

/// The cuts of a fragment of a polygon. Its pixels are those inside the polygon's edges that lie on the given side of
/// every cut.
struct PolygonCuts {
  Link first = 0;  ///< index in PolygonTable::cuts
  Link count = 0;  ///< 0 for the whole polygon
};

/// The polygon table PT with the starts of the edge table ET (lecture 002): the polygons of a frame in order of
/// submission, and a bucket for each band of lines with the polygons that start there. All memory is the caller's.
class PolygonTable {
 public:
  std::span<PolygonReference> references;
  FanRecords fans;
  std::span<PolygonGroup> groups;
  std::span<Link> buckets;  ///< for each band the last polygon that starts there; its `next` is the first
  /// Fragments, for algorithms that draw polygons in parts. All three are empty for other algorithms, which do not read
  /// them.
  std::span<PolygonCuts> fragments;  ///< parallel to `references`
  std::span<const Link> cuts;        ///< index in `half_planes` · 2, plus 1 for the side where the value is negative
  std::span<const HalfPlane> half_planes;  ///< lines that several fragments share
  Link polygon_count = 0;                  ///< entries of `references` in use
  Link group_count = 0;                    ///< entries of `groups` in use

  void clear() {
    polygon_count = group_count = 0;
    fans.clear();
    for (Link& bucket : buckets) bucket = no_link;
  }

  /// Appends a polygon that starts in `band`. The caller has checked that there is room.
  void append(std::int32_t band, Link source) {
    const std::uint32_t number = polygon_count;
    polygon_count = static_cast<Link>(number + 1);
    PolygonReference* const first = references.data();
    PolygonReference& reference = first[number];
    Link& bucket = buckets[static_cast<std::size_t>(band)];
    const Link tail = bucket;
    bucket = static_cast<Link>(number);
    reference.source = source;
    if (tail == no_link) {
      reference.next = static_cast<Link>(number);
    } else {
      reference.next = first[tail].next;
      first[tail].next = static_cast<Link>(number);
    }
  }

  /// The group of a polygon, by a linear search from `group` on.
  [[nodiscard]] Link group_of(Link polygon, Link group = 0) const {
    while (group + 1 < group_count && groups[group + 1u].first <= polygon) ++group;
    return group;
  }

  /// The group of a polygon, by binary search.
  [[nodiscard]] Link find_group(Link polygon) const {
    if (group_count == 1) return 0;
    Link low = 0, high = group_count;
    while (high - low > 1) {
      const Link middle = static_cast<Link>((low + high) / 2);
      (groups[middle].first <= polygon ? low : high) = middle;
    }
    return low;
  }

  /// Puts a polygon into the bucket of a later row, for tables with buckets of one line. The order in the bucket is
  /// lost.
  void defer(std::int32_t row, Link polygon) {
    Link& tail = buckets[static_cast<std::size_t>(row)];
    if (tail == no_link) {
      references[polygon].next = polygon;
      tail = polygon;
    } else {
      references[polygon].next = references[tail].next;
      references[tail].next = polygon;
    }
  }

  /// The part of a row's columns that belongs to a fragment. `columns` are those inside its polygon's edges and the
  /// viewport; `row` is not biased.
  [[nodiscard]] RowColumns cut(Link polygon, std::int32_t row, RowColumns columns) const {
    const PolygonCuts own = fragments[polygon];
    for (const Link cut : cuts.subspan(own.first, own.count))
      columns = half_planes[cut >> 1].cut(columns, row, (cut & 1) == 0);
    return columns;
  }

  [[nodiscard]] PolygonCorners corners(const PolygonGroup& group, Link polygon) const {
    const Link source = references[polygon].source;
    const ScreenVertex* v = group.vertices;
    if (source & fan_flag) {
      const FanTriangle fan = fans.triangle(source & static_cast<Link>(~fan_flag));
      return {{v + fan.corner[0], v + fan.corner[1], v + fan.corner[2]}, fan.triangle, fan.polygon};
    }
    if (group.indices == nullptr) {
      v += std::size_t{3} * source;
      return {{v, v + 1, v + 2}, source, source};
    }
    const std::uint16_t* index = group.indices + std::size_t{3} * source;
    return {{v + index[0], v + index[2], v + index[1]}, source, source};
  }

  /// Whether an entry is an outline; else it is a triangle.
  [[nodiscard]] bool is_outline(Link polygon) const {
    const Link source = references[polygon].source;
    return (source & fan_flag) != 0 && fans.is_outline(source & static_cast<Link>(~fan_flag));
  }
  /// An entry that is an outline.
  [[nodiscard]] PlacedOutline outline(const PolygonGroup& group, Link polygon) const {
    return fans.outline(group.vertices, references[polygon].source & static_cast<Link>(~fan_flag));
  }
};

/// An entry of the polygon table whose corners are looked up when they are needed.
struct PolygonEntry {
  const PolygonTable& table;
  const PolygonGroup& group;
  Link polygon;

  /// The corners of a triangle, or of an outline's reference triangle.
  [[nodiscard]] PolygonCorners corners() const { return table.corners(group, polygon); }
  [[nodiscard]] bool is_outline() const { return table.is_outline(polygon); }
  [[nodiscard]] PlacedOutline outline() const { return table.outline(group, polygon); }
};

/// The rows [first, end), not biased, whose centres lie between a polygon's highest and lowest corner. They may lie
/// outside the viewport.
struct RowRange {
  std::int32_t first, end;
};
[[nodiscard]] inline RowRange row_range(const PolygonEntry& entry) {
  if (entry.is_outline()) {
    const PlacedOutline outline = entry.outline();
    return {row_at(outline.corners[outline.header.top()].y) - row_bias, outline.end_row - row_bias};
  }
  const PolygonCorners polygon = entry.corners();
  const auto y = [&](unsigned i) { return polygon.corner[i]->y; };
  const auto [low, high] = std::minmax({y(0), y(1), y(2)});
  return {row_at(low) - row_bias, row_at(high) - row_bias};
}

/// Walks a band's bucket in order of submission.
class BucketCursor {
 public:
  BucketCursor(const PolygonTable& table, std::int32_t band)
      : references_(table.references.data()),
        last_(table.buckets[static_cast<std::size_t>(band)]),
        polygon_(last_ == no_link ? no_link : references_[last_].next) {}
  /// The current polygon, or no_link at the end.
  [[nodiscard]] Link polygon() const { return polygon_; }
  /// Moves to the next polygon and returns it; no_link at the end.
  Link next() { return polygon_ = polygon_ == last_ ? no_link : references_[polygon_].next; }

 private:
  const PolygonReference* references_;
  Link last_;
  Link polygon_;
};

}  // namespace spanline
