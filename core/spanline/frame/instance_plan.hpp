#pragma once
#include <cstdint>

#include "spanline/frame/shader_choice.hpp"
#include "spanline/frame/shader_set.hpp"
#include "spanline/frame/status.hpp"
#include "spanline/model/material.hpp"
#include "spanline/model/mesh.hpp"
#include "spanline/raster/vertex_shade.hpp"
#include "spanline/shade/layer/layering.hpp"
#include "spanline/shade/light/lighting.hpp"

namespace spanline {

/// How the shades of an instance's vertices are computed.
enum class VertexLighting : std::uint8_t {
  none,            ///< vertices have no shades: whole polygons are lit
  plain,           ///< the group's own lights
  local,           ///< as plain, and with point lights and highlights
  local_on_solid,  ///< as local, for solids, whose colour is known only at each pixel
  on_relief,       ///< the group's own lights, signed as relief needs them
  with_opacity,    ///< the group's own lights, with the opacities of vertices
};

/// The source of an instance's texture coordinates.
enum class CoordinateSource : std::uint8_t {
  none,        ///< there are none
  mesh,        ///< the mesh's own
  sphere_map,  ///< reflection of the surroundings, from the mesh's normals
  solid,       ///< positions of the vertices in a solid: three coordinates
};

/// All decisions about an instance, made once from its mesh, its material and the frame, before any of its data is
/// made. Code after `plan_instance` follows the plan and does not consult mesh or material for them again.
struct InstancePlan {
  MissingShader missing = MissingShader::none;            ///< shader for want of which the instance is left out
  std::uint8_t shader = 0;                                ///< index in the renderer's list of shaders
  VertexLighting lighting = VertexLighting::none;         ///< how vertices get their shades
  vertex_shade::Kind shades{};                            ///< what each shade of a vertex holds
  CoordinateSource coordinates = CoordinateSource::none;  ///< source of texture coordinates
  bool ramp = false;                                      ///< the group has a ramp of its colour
  bool smooth = false;                                    ///< light and colour are interpolated between the vertices
  bool described = false;                                 ///< the group has a TexturedGroup
  bool local_light = false;                               ///< the group has a LocalLighting
  bool holes = false;                                     ///< some of its texels are absent
  bool see_through = false;                               ///< what lies behind it may be seen through it

  /// Whether vertices have shades.
  [[nodiscard]] constexpr bool shaded() const { return lighting != VertexLighting::none; }
  /// Whether vertices have texture coordinates.
  [[nodiscard]] constexpr bool textured() const { return coordinates != CoordinateSource::none; }
  /// Whether vertices have a third texture coordinate.
  [[nodiscard]] constexpr bool has_third_coordinates() const { return coordinates == CoordinateSource::solid; }
};

namespace plan_detail {

template <class Traits>
[[nodiscard]] VertexLighting lighting_for(const SurfaceNeeds& needs, vertex_shade::Kind shades) {
  using Set = ShaderSet<Traits>;
  using enum VertexLighting;
  if (Set::has_translucent && needs.opacity_a_vertex) return with_opacity;
  if (!Set::has_shades || !needs.smooth) return none;
  if (Set::has_relief && needs.relief) return on_relief;
  if (Set::has_local_light && Set::has_volumes && shades == vertex_shade::Kind::highlight_and_intensity)
    return local_on_solid;
  return Set::has_local_light && needs.local_light ? local : plain;
}

template <class Traits>
[[nodiscard]] CoordinateSource coordinates_for(const SurfaceNeeds& needs, const Material& material) {
  using Set = ShaderSet<Traits>;
  using enum CoordinateSource;
  if (!Set::has_textures || !needs.textured) return none;
  if (Set::has_volumes && needs.volume) return solid;
  return material.texturing.coordinates == TextureCoordinates::sphere_map ? sphere_map : mesh;
}

}  // namespace plan_detail

/// The plan for a mesh with a material. `decides_spans`: the algorithm draws whole spans without depths, so that only
/// layers let it show what is behind holes.
template <class Traits>
[[nodiscard]] InstancePlan plan_instance(const Mesh& mesh, const Material& material, const FrameNeeds& frame,
                                         bool decides_spans) {
  using Set = ShaderSet<Traits>;
  InstancePlan plan;
  plan.shades = shade_kind(mesh, material);
  if constexpr (Set::has_ids) {
    plan.shader = Traits::Shaders::template index_of<IdShader>;
  } else {
    const SurfaceNeeds needs = needs_of(mesh, material, frame);
    plan.shader = shader_for<Traits>(material, needs);
    if (plan.shader == Traits::Shaders::count)
      plan.missing = missing_for<Traits>(material, needs);
    else if (decides_spans && !Traits::Shaders::see_through && needs.holes)
      plan.missing = MissingShader::cut_out_texture;
    if (Set::has_translucent && needs.opacity_a_vertex) plan.shades = vertex_shade::Kind::colour_and_opacity;
    plan.lighting = plan_detail::lighting_for<Traits>(needs, plan.shades);
    plan.coordinates = plan_detail::coordinates_for<Traits>(needs, material);
    plan.ramp =
        Set::has_ramps && plan.shaded() && plan.lighting != VertexLighting::with_opacity && !needs.vertex_colours;
    plan.smooth = plan.shaded() && needs.smooth;
    plan.local_light = Set::has_local_light && needs.local_light;
    plan.described = plan.textured() || Set::is_general(plan.shader) || plan.local_light;
    plan.holes = needs.holes;
    plan.see_through = Traits::Shaders::see_through && (needs.holes || needs.see_through);
  }
  return plan;
}

/// The plan for triangles in screen coordinates. They are flat and take neither light nor effects of the frame; of the
/// material only opacity and transparency are used.
template <class Traits>
[[nodiscard]] InstancePlan plan_screen_triangles(const Material& material) {
  using Set = ShaderSet<Traits>;
  InstancePlan plan;
  if constexpr (Set::has_ids) {
    plan.shader = Traits::Shaders::template index_of<IdShader>;
  } else {
    SurfaceNeeds needs;
    needs.see_through = is_see_through(material);
    plan.shader = shader_for<Traits>(material, needs);
    if (plan.shader == Traits::Shaders::count) plan.missing = missing_for<Traits>(material, needs);
    plan.see_through = Traits::Shaders::see_through && needs.see_through;
  }
  return plan;
}

}  // namespace spanline
