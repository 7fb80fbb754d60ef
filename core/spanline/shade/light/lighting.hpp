#pragma once
#include <cstdint>

#include "spanline/model/light.hpp"
#include "spanline/model/mesh.hpp"
#include "spanline/model/transform.hpp"
#include "spanline/raster/vertex_shade.hpp"
#include "spanline/shade/shading_group.hpp"

namespace spanline {

/// Rotates the frame's lights into the axes of an instance's mesh and sets the group's ambient light.
void set_lights(const Lighting& lighting, const Transform& transform, ShadingGroup& group);

/// Gouraud shading: computes the shade of every vertex of the mesh; whether the mesh has colours decides the kind.
void shade_vertices(const Mesh& mesh, const ShadingGroup& group, std::uint32_t* shades);

/// The kind of shade that a mesh's vertices get. Highlights need a coloured shade, because they have their own colour;
/// solids need intensities, because their colour is found at each pixel.
[[nodiscard]] inline vertex_shade::Kind shade_kind(const Mesh& mesh, const Material& material) {
  if (material.shines() && material.volume.source != SolidSource::none)
    return vertex_shade::Kind::highlight_and_intensity;
  return mesh.vertex_colours.empty() && !material.shines() ? vertex_shade::Kind::intensity : vertex_shade::Kind::colour;
}

}  // namespace spanline
