#include "spanline/shade/layer/translucent.hpp"

namespace spanline {

void shade_translucent_vertices(const Mesh& mesh, Rgb888 colour, const ShadingGroup& group, std::uint32_t* shades) {
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
    const Rgb888 own = mesh.vertex_colours.empty() ? colour : mesh.vertex_colours[i];
    const Intensity light = mesh.vertex_normals.empty() ? Intensity{65535} : group.intensity(mesh.vertex_normals[i]);
    const auto lit = [light](std::uint32_t channel) { return (channel * light + 32768) >> 16; };
    shades[i] = vertex_shade::pack(lit(own.red), lit(own.green), lit(own.blue), mesh.vertex_opacities[i]);
  }
}

}  // namespace spanline
