#pragma once
#include <cstdint>

#include "spanline/model/light.hpp"
#include "spanline/model/mesh.hpp"
#include "spanline/model/transform.hpp"
#include "spanline/raster/vertex_shade.hpp"
#include "spanline/shade/shading_group.hpp"

namespace spanline {

/// Turns the frame's lights into the axes of an instance's mesh (its rotation, transposed) and sets the group's ambient
/// light.
void set_lights(const Lighting& lighting, const Transform& transform, ShadingGroup& group);

/// Gouraud light: a shade for every vertex of the mesh, of the kind that its colours ask for.
void shade_vertices(const Mesh& mesh, const ShadingGroup& group, std::uint32_t* shades);

/// The kind of shade that a mesh's vertices get: highlights have a colour of their own, and solids get theirs at each
/// pixel.
[[nodiscard]] inline vertex_shade::Kind shade_kind(const Mesh& mesh, const Material& material) {
  if (material.shines() && material.volume.source != SolidSource::none)
    return vertex_shade::Kind::highlight_and_intensity;
  return mesh.vertex_colours.empty() && !material.shines() ? vertex_shade::Kind::intensity : vertex_shade::Kind::colour;
}

}  // namespace spanline
