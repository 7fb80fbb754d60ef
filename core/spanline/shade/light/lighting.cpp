#include "spanline/shade/light/lighting.hpp"

#include <algorithm>

#include "spanline/math/matrix.hpp"
#include "spanline/shade/light/gouraud.hpp"

namespace spanline {

void set_lights(const Lighting& lighting, const Transform& transform, ShadingGroup& group) {
  group.ambient = static_cast<std::uint16_t>(std::clamp<std::int32_t>(lighting.ambient.raw(), 0, 65535));
  group.light_count = static_cast<std::uint8_t>(std::min(lighting.lights.size(), Lighting::max_lights));
  for (unsigned i = 0; i < group.light_count; ++i) {
    const DirectionalLight& light = lighting.lights[i];
    const Direction towards_model = transform.rotation.transposed() * light.towards;
    // ModelLight::on divides by 2^6 and by the length of a packed normal, 511, is divided out here.
    const auto component = [&](Q2_30 c) {
      return static_cast<std::int32_t>(multiply<Fixed<16>>(c, light.intensity).raw() * std::int64_t{64} / 511);
    };
    group.lights[i] = {component(towards_model.x), component(towards_model.y), component(towards_model.z)};
  }
}

namespace {

/// Shades of vertices without colours under a single light. Most meshes are of this kind, and the loop keeps the light
/// in registers.
void shade_by_one_light(std::span<const PackedNormal> normals, std::int32_t ambient, ModelLight light,
                        std::uint32_t* shades) {
  for (const PackedNormal normal : normals) {
    const std::int32_t sum = ambient + std::max<std::int32_t>(0, light.on(normal));
    *shades++ = gouraud::shade_of(static_cast<Intensity>(sum));
  }
}

}  // namespace

void shade_vertices(const Mesh& mesh, const ShadingGroup& group, std::uint32_t* shades) {
  if (mesh.vertex_colours.empty() && !mesh.vertex_normals.empty() && group.light_count == 1)
    return shade_by_one_light(mesh.vertex_normals, group.ambient, group.lights[0], shades);
  const std::size_t count = mesh.vertex_count();
  const ShadingGroup lit = group;  // a local copy, which stores to `shades` cannot alias
  for (std::size_t i = 0; i < count; ++i) {
    const Intensity intensity = mesh.vertex_normals.empty() ? Intensity{65535} : lit.intensity(mesh.vertex_normals[i]);
    shades[i] = mesh.vertex_colours.empty() ? gouraud::shade_of(intensity)
                                            : gouraud::shade_of(mesh.vertex_colours[i], intensity);
  }
}

}  // namespace spanline
