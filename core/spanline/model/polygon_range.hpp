#pragma once
/// @file
/// A part of a mesh's polygons.
///
/// ```cpp
/// constexpr Vertex16 corners[] = {{0, 0, 0}, {256, 0, 0}, {0, 256, 0}, {256, 256, 0}};
/// constexpr std::uint16_t indices[] = {0, 1, 2, 1, 3, 2};
/// const Mesh mesh{.vertices = corners, .indices = indices, .step_exponent = -8, .bounds = {{}, 400}};
/// const PolygonRange second = PolygonRange::of(mesh, 1, 1);  // the second triangle alone
/// ```
#include <cstddef>
#include <cstdint>

#include "spanline/model/mesh.hpp"

namespace spanline {

/// Consecutive polygons of a mesh, and their places in its tables.
struct PolygonRange {
  std::uint32_t first = 0;           ///< number of the first polygon, [0, the mesh's polygons)
  std::uint32_t count = 0;           ///< number of polygons
  std::uint32_t first_index = 0;     ///< index in `Mesh::indices` of the first polygon's first corner
  std::uint32_t first_triangle = 0;  ///< number of the first polygon's first triangle, with polygons divided into fans

  /// All polygons of a mesh.
  [[nodiscard]] static constexpr PolygonRange whole(const Mesh& mesh) {
    return {0, static_cast<std::uint32_t>(mesh.corners.empty() ? mesh.indices.size() / 3 : mesh.corners.size()), 0, 0};
  }
  /// `polygon_count` polygons from number `first_polygon` on. In a mesh with a table of corner counts it adds up the
  /// counts of all polygons before, so ranges should be made once and kept.
  [[nodiscard]] static constexpr PolygonRange of(const Mesh& mesh, std::uint32_t first_polygon,
                                                 std::uint32_t polygon_count) {
    PolygonRange range{first_polygon, polygon_count, 3 * first_polygon, first_polygon};
    if (mesh.corners.empty()) return range;
    range.first_index = range.first_triangle = 0;
    for (std::uint32_t i = 0; i < first_polygon; ++i) {
      range.first_index += mesh.corner_count(i);
      range.first_triangle += mesh.corner_count(i) - 2;
    }
    return range;
  }
  /// Number of triangles in the range, with polygons divided into fans.
  [[nodiscard]] constexpr std::uint32_t triangle_count(const Mesh& mesh) const {
    if (mesh.corners.empty()) return count;
    std::uint32_t triangles = 0;
    for (std::uint32_t i = first; i < first + count; ++i) triangles += mesh.corner_count(i) - 2;
    return triangles;
  }
};

}  // namespace spanline
