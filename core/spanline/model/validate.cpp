#include "spanline/model/validate.hpp"

#include "spanline/model/planarity.hpp"

namespace spanline {
namespace {

constexpr std::int32_t coordinate_limit = std::int32_t{1} << 30;

constexpr bool in_range(std::int32_t value) { return value >= -coordinate_limit && value <= coordinate_limit; }

MeshReport fault(MeshFault what, std::size_t at = 0) { return {what, static_cast<std::uint32_t>(at)}; }

MeshReport check_sizes(const Mesh& mesh) {
  const std::size_t vertices = mesh.vertex_count();
  if (vertices == 0) return fault(MeshFault::no_vertices);
  if (!mesh.vertices.empty() && !mesh.wide_vertices.empty()) return fault(MeshFault::two_vertex_tables);
  if (vertices > Mesh::max_vertices) return fault(MeshFault::too_many_vertices, Mesh::max_vertices);
  if (mesh.indices.empty()) return fault(MeshFault::no_polygons);
  const std::size_t polygons = mesh.polygon_count();
  if (polygons > Mesh::max_polygons) return fault(MeshFault::too_many_polygons, Mesh::max_polygons);
  const auto none_or = [](std::size_t size, std::size_t wanted) { return size == 0 || size == wanted; };
  if (!none_or(mesh.polygon_normals.size(), polygons)) return fault(MeshFault::polygon_normals_count);
  if (!none_or(mesh.vertex_normals.size(), vertices)) return fault(MeshFault::vertex_normals_count);
  if (!none_or(mesh.polygon_colours.size(), polygons)) return fault(MeshFault::polygon_colours_count);
  if (!none_or(mesh.vertex_colours.size(), vertices)) return fault(MeshFault::vertex_colours_count);
  if (!none_or(mesh.texture_coordinates.size(), vertices)) return fault(MeshFault::texture_coordinates_count);
  if (!none_or(mesh.vertex_opacities.size(), vertices)) return fault(MeshFault::vertex_opacities_count);
  if (mesh.texture_exponent < -20 || mesh.texture_exponent > -5) return fault(MeshFault::texture_exponent_range);
  if (mesh.step_exponent < -30 || mesh.step_exponent > 14) return fault(MeshFault::step_exponent_range);
  if (!in_range(mesh.offset.x) || !in_range(mesh.offset.y) || !in_range(mesh.offset.z))
    return fault(MeshFault::vertex_out_of_range);
  return {};
}

MeshReport check_polygons(const Mesh& mesh) {
  if (mesh.corners.empty()) {
    if (mesh.indices.size() % 3 != 0) return fault(MeshFault::ragged_indices, mesh.indices.size());
  } else {
    std::size_t used = 0;
    for (std::size_t i = 0; i < mesh.corners.size(); ++i) {
      const unsigned corners = mesh.corner_count(i);
      if (corners < 3 || corners > Mesh::max_corners) return fault(MeshFault::corner_count, i);
      used += corners;
    }
    if (used != mesh.indices.size()) return fault(MeshFault::ragged_indices, used);
  }
  for (std::size_t i = 0; i < mesh.indices.size(); ++i)
    if (mesh.indices[i] >= mesh.vertex_count()) return fault(MeshFault::index_out_of_range, i);
  return {};
}

/// Holds the marks of planar polygons against their corners.
MeshReport check_marks(const Mesh& mesh) {
  std::size_t first_index = 0;
  for (std::size_t i = 0; i < mesh.corners.size(); first_index += mesh.corner_count(i), ++i) {
    if ((mesh.corners[i] & Mesh::planar) == 0) continue;
    const Planarity planarity = planarity_of(mesh, i, first_index);
    if (planarity != Planarity::planar)
      return fault(planarity == Planarity::bent ? MeshFault::not_planar : MeshFault::not_linear, i);
  }
  return {};
}

template <class Vertex>
MeshReport check_vertices(std::span<const Vertex> vertices, const BoundingSphere& bounds) {
  const auto radius = static_cast<std::uint64_t>(bounds.radius);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vertex& v = vertices[i];
    if (!in_range(v.x) || !in_range(v.y) || !in_range(v.z)) return fault(MeshFault::vertex_out_of_range, i);
    // Differences are below 2^32. A component beyond the radius is outside without squaring, so that squares fit 64
    // bits.
    std::uint64_t rest = radius * radius;
    for (const std::int64_t d :
         {static_cast<std::int64_t>(v.x) - bounds.centre.x, static_cast<std::int64_t>(v.y) - bounds.centre.y,
          static_cast<std::int64_t>(v.z) - bounds.centre.z}) {
      const auto distance = static_cast<std::uint64_t>(d < 0 ? -d : d);
      if (distance > radius || distance * distance > rest) return fault(MeshFault::bounds_too_small, i);
      rest -= distance * distance;
    }
  }
  return {};
}

}  // namespace

MeshReport validate(const Mesh& mesh) {
  if (const MeshReport report = check_sizes(mesh); !report.ok()) return report;
  if (const MeshReport report = check_polygons(mesh); !report.ok()) return report;
  const MeshReport vertices = mesh.vertices.empty() ? check_vertices(mesh.wide_vertices, mesh.bounds)
                                                    : check_vertices(mesh.vertices, mesh.bounds);
  return vertices.ok() ? check_marks(mesh) : vertices;
}

const char* to_string(MeshFault fault) {
  switch (fault) {
    case MeshFault::none:
      return "no fault";
    case MeshFault::no_vertices:
      return "no vertices";
    case MeshFault::two_vertex_tables:
      return "two vertex tables";
    case MeshFault::too_many_vertices:
      return "more than 65535 vertices";
    case MeshFault::no_polygons:
      return "no polygons";
    case MeshFault::too_many_polygons:
      return "more than 32767 polygons";
    case MeshFault::ragged_indices:
      return "index count and corner counts disagree";
    case MeshFault::corner_count:
      return "polygon with fewer than 3 or more than 8 corners";
    case MeshFault::index_out_of_range:
      return "vertex index out of range";
    case MeshFault::vertex_out_of_range:
      return "coordinate out of range";
    case MeshFault::polygon_normals_count:
      return "polygon normals do not match the polygons";
    case MeshFault::vertex_normals_count:
      return "vertex normals do not match the vertices";
    case MeshFault::polygon_colours_count:
      return "polygon colours do not match the polygons";
    case MeshFault::vertex_colours_count:
      return "vertex colours do not match the vertices";
    case MeshFault::texture_coordinates_count:
      return "texture coordinates do not match the vertices";
    case MeshFault::vertex_opacities_count:
      return "vertex opacities do not match the vertices";
    case MeshFault::texture_exponent_range:
      return "texture exponent out of range";
    case MeshFault::step_exponent_range:
      return "step exponent out of range";
    case MeshFault::bounds_too_small:
      return "vertex outside the bounding sphere";
    case MeshFault::not_planar:
      return "polygon marked as planar that is not";
    case MeshFault::not_linear:
      return "polygon marked as planar whose attributes are not linear over it";
  }
  return "unknown fault";
}

}  // namespace spanline
