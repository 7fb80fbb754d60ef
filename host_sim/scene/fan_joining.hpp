#pragma once
#include <cstdint>
#include <span>

#include "scene/core_mesh.hpp"

namespace spanline::sim {

/// Makes polygons of a mesh of triangles, with their tables of one entry a triangle. `fans` says how many triangles
/// each polygon has (Scene::polygon_triangles).
///
/// A fan becomes a polygon with the mark Mesh::planar if neighbours in it share their vertices, all have the same
/// normal and colour, and the corners are convex and planar in the mesh's steps. The others stay triangles. If all do,
/// the mesh stays without a table of corners.
void join_fans(CoreMesh& mesh, std::span<const std::uint8_t> fans);

}  // namespace spanline::sim
