#pragma once
/// @file
/// Checks of meshes, once at load; everything behind trusts what has passed.
///
/// ```cpp
/// void check(const Mesh& mesh, void (*complain)(const char* fault, std::uint32_t at)) {
///   if (const MeshReport report = validate(mesh); !report.ok()) complain(to_string(report.fault), report.at);
/// }
/// ```
#include <cstdint>

#include "spanline/model/mesh.hpp"

namespace spanline {

/// What is wrong with a mesh.
enum class MeshFault : std::uint8_t {
  none,                       ///< nothing
  no_vertices,                ///< neither vertex table holds anything
  two_vertex_tables,          ///< both vertex tables hold something
  too_many_vertices,          ///< more than Mesh::max_vertices
  no_polygons,                ///< there are no indices
  too_many_polygons,          ///< more than Mesh::max_polygons
  ragged_indices,             ///< index count and corner counts do not fit together
  corner_count,               ///< a polygon with fewer than 3 or more than 8 corners
  index_out_of_range,         ///< an index beyond the vertex table
  vertex_out_of_range,        ///< a wide coordinate or the offset beyond 2^30
  polygon_normals_count,      ///< there are some, but not one for each polygon
  vertex_normals_count,       ///< there are some, but not one for each vertex
  polygon_colours_count,      ///< there are some, but not one for each polygon
  vertex_colours_count,       ///< there are some, but not one for each vertex
  texture_coordinates_count,  ///< there are some, but not one for each vertex
  vertex_opacities_count,     ///< there are some, but not one for each vertex
  step_exponent_range,        ///< outside [−30, 14]
  texture_exponent_range,     ///< outside [−20, −5]
  bounds_too_small,           ///< a vertex outside the bounding sphere
  not_planar,                 ///< a polygon marked with Mesh::planar whose corners do not lie in a plane
  not_linear,  ///< a polygon so marked with texture coordinates, colours or opacities that are not linear
};

/// The first fault of a mesh and its place: `at` is an index into the table that the fault names.
struct [[nodiscard]] MeshReport {
  MeshFault fault = MeshFault::none;  ///< the first that was found
  std::uint32_t at = 0;               ///< where in the table that it names; 0 for faults of whole tables
  /// Whether nothing is wrong.
  [[nodiscard]] constexpr bool ok() const { return fault == MeshFault::none; }
};

/// Checks a mesh once, at load. Later code relies on it. It takes time linear in the size of the tables and allocates
/// nothing.
MeshReport validate(const Mesh& mesh);

/// A short English name of the fault, for messages.
[[nodiscard]] const char* to_string(MeshFault fault);

}  // namespace spanline
