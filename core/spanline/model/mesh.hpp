#pragma once
/// @file
/// Meshes. `spanline convert` makes them of model files; small ones are written by hand.
///
/// ```cpp
/// // A square of two world units, seen from +z: steps of 2^-8 units, a polygon of four corners.
/// static constexpr Vertex16 corners[] = {{-256, -256, 0}, {256, -256, 0}, {256, 256, 0}, {-256, 256, 0}};
/// static constexpr std::uint16_t indices[] = {0, 1, 2, 3};
/// static constexpr std::uint8_t corner_counts[] = {4};
/// static constexpr PackedNormal normals[] = {{0, 0, 511}};
/// constexpr Mesh square{.vertices = corners,
///                       .indices = indices,
///                       .corners = corner_counts,
///                       .polygon_normals = normals,
///                       .step_exponent = -8,
///                       .bounds = {{}, 363}};
/// static_assert(square.triangle_count() == 2);
/// ```
#include <cstdint>
#include <span>

#include "spanline/math/vector.hpp"
#include "spanline/model/colour.hpp"
#include "spanline/model/texture.hpp"

namespace spanline {

/// A model vertex in steps of the mesh: the world position is (vertex + offset) · 2^step_exponent.
/// Sixteen bits a coordinate halve the flash, and their products fit the 32-bit multiplier of a Cortex-M0+.
struct Vertex16 {
  std::int16_t x;  ///< steps of the mesh, any value
  std::int16_t y;  ///< steps
  std::int16_t z;  ///< steps
};

/// A vertex with 32-bit coordinates, for scenes that 65,536 steps cannot span; |coordinate| ≤ 2^30.
struct Vertex32 {
  std::int32_t x;  ///< steps of the mesh, [−2^30, 2^30]
  std::int32_t y;  ///< steps
  std::int32_t z;  ///< steps
};

/// A unit normal in 32 bits: x, y and z as signed 10-bit numbers in bits 31…22, 21…12 and 11…2, where 511 stands for 1.
/// One or two shifts extract a component.
class PackedNormal {
 public:
  /// The null normal, on which no light falls.
  constexpr PackedNormal() = default;
  /// Components in [−511, 511], 511 times those of the unit vector.
  constexpr PackedNormal(int x, int y, int z)
      : bits_((static_cast<std::uint32_t>(x & 1023) << 22) | (static_cast<std::uint32_t>(y & 1023) << 12) |
              (static_cast<std::uint32_t>(z & 1023) << 2)) {}
  /// Components, 511 times those of the unit vector: [−511, 511].
  [[nodiscard]] constexpr std::int32_t x() const { return static_cast<std::int32_t>(bits_) >> 22; }
  /// The same of y.
  [[nodiscard]] constexpr std::int32_t y() const { return static_cast<std::int32_t>(bits_ << 10) >> 22; }
  /// The same of z.
  [[nodiscard]] constexpr std::int32_t z() const { return static_cast<std::int32_t>(bits_ << 20) >> 22; }
  /// Whether all components are equal.
  friend constexpr bool operator==(PackedNormal, PackedNormal) = default;

 private:
  std::uint32_t bits_ = 0;
};

/// A sphere that encloses every vertex, in steps of the mesh; like the vertices, it does not include the mesh's offset.
struct BoundingSphere {
  Vec3<std::int32_t> centre{};  ///< steps, [−2^30, 2^30]; the mesh's origin by default
  std::uint32_t radius = 0;     ///< steps, rounded up; at most 2^31 − 1; 0 by default
};

/// A mesh as views over read-only tables, usually in flash. It owns nothing; `validate()` checks it once at load.
///
/// Polygons are triangles, or planar convex polygons of 3 … 8 corners, counter-clockwise when seen from the front.
/// A polygon of n corners stands for the fan of triangles (0,1,2), (0,2,3) …, which are numbered in that order. It is
/// drawn as that fan, or whole where it is marked as planar and fit for it (docs/conventions.md).
struct Mesh {
  static constexpr unsigned max_corners = 8;  ///< of a polygon
  /// Mark of a polygon in `corners` whose corners lie within half a unit of one plane, with texture coordinates,
  /// colours and opacities that are linear over it. `validate()` holds it against the tables (model/planarity.hpp). A
  /// marked polygon of more than three corners is one entry of the polygon table.
  static constexpr std::uint8_t planar = 0x80;
  static constexpr std::size_t max_vertices = 65535;  ///< in the table
  static constexpr std::size_t max_polygons = 32767;  ///< in the table

  std::span<const Vertex16> vertices{};       ///< the vertices, or empty if `wide_vertices` holds them
  std::span<const Vertex32> wide_vertices{};  ///< the vertices with 32-bit coordinates, or empty
  std::span<const std::uint16_t> indices{};   ///< corner indices, polygon after polygon
  /// The corners of each polygon, 3 … 8, plus `planar` for a marked one. Empty: all are triangles.
  std::span<const std::uint8_t> corners{};

  std::span<const PackedNormal> polygon_normals{};           ///< one a polygon, for flat light; empty: fully lit
  std::span<const PackedNormal> vertex_normals{};            ///< one a vertex, for Gouraud light; empty: fully lit
  std::span<const Rgb888> polygon_colours{};                 ///< one a polygon; empty: the material's colour
  std::span<const Rgb888> vertex_colours{};                  ///< one a vertex; empty: the material's colour
  std::span<const TextureCoordinate> texture_coordinates{};  ///< one a vertex; empty: never textured
  std::span<const std::uint8_t> vertex_opacities{};  ///< one a vertex, 255ths of the material's opacity; empty: all 255

  Vec3<std::int32_t> offset{};         ///< steps, added to every vertex; |component| ≤ 2^30
  std::int8_t step_exponent = -13;     ///< a step is 2^step_exponent world units; [−30, 14]
  std::int8_t texture_exponent = -14;  ///< a unit of texture coordinates is 2^texture_exponent textures; [−20, −5]
  BoundingSphere bounds{};             ///< encloses all vertices; it alone decides whether the mesh is out of view

  /// Number of vertices, in whichever table holds them.
  [[nodiscard]] constexpr std::size_t vertex_count() const {
    return vertices.empty() ? wide_vertices.size() : vertices.size();
  }
  /// Vertex `number`, from whichever table holds it.
  [[nodiscard]] constexpr Vertex32 vertex(std::size_t number) const {
    if (vertices.empty()) return wide_vertices[number];
    const Vertex16 v = vertices[number];
    return {v.x, v.y, v.z};
  }
  /// Number of polygons.
  [[nodiscard]] constexpr std::size_t polygon_count() const {
    return corners.empty() ? indices.size() / 3 : corners.size();
  }
  /// Index in `indices` of a polygon's first corner. In a mesh with a table of corner counts it adds up the counts of
  /// all polygons before.
  [[nodiscard]] constexpr std::size_t first_corner(std::size_t polygon) const {
    if (corners.empty()) return polygon * 3;
    std::size_t first = 0;
    for (std::size_t i = 0; i < polygon; ++i) first += corner_count(i);
    return first;
  }
  /// Number of corners of a polygon.
  [[nodiscard]] constexpr unsigned corner_count(std::size_t polygon) const {
    return corners.empty() ? 3u : corners[polygon] & ~unsigned{planar};
  }
  /// Number of triangles of all fans; polygon ids count these.
  [[nodiscard]] constexpr std::size_t triangle_count() const {
    return corners.empty() ? indices.size() / 3 : indices.size() - 2 * corners.size();
  }
};

}  // namespace spanline
