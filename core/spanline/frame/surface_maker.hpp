#pragma once
#include <cstdint>
#include <new>
#include <type_traits>

#include "spanline/frame/frame_pools.hpp"
#include "spanline/frame/frame_settings.hpp"
#include "spanline/frame/shader_choice.hpp"
#include "spanline/geometry/vertex_store.hpp"
#include "spanline/model/transform.hpp"
#include "spanline/raster/link.hpp"
#include "spanline/shade/light/lighting.hpp"

namespace spanline {

/// Tells shaders what they need to know of a frame and its groups: lights, effects, and what a material asks for.
template <class Traits>
class SurfaceMaker {
  using Set = ShaderSet<Traits>;
  using Format = typename Traits::Format;

 public:
  /// Keeps of a frame's settings what surfaces want.
  void begin(const FrameSettings& settings) {
    lighting_ = settings.lighting;
    stipple_seed_ = settings.stipple_seed;
    fog_wanted_ = settings.fog.curve != FogCurve::none;
    dither_wanted_ = settings.dither;
    if constexpr (Set::has_effects) {
      effects_.fogged = fog_wanted_;
      effects_.fog_colour = settings.fog.colour;
      effects_.dither = settings.dither;
      if (effects_.fogged) effects_.fog.fill(settings.fog, settings.camera);
    }
  }

  /// What a mesh of a material asks of a shader in this frame.
  [[nodiscard]] SurfaceNeeds needs_of(const Mesh& mesh, const Material& material) const {
    SurfaceNeeds needs = Set::needs_of(mesh, material, !lighting_.point_lights.empty());
    needs.effects = fog_wanted_ || dither_wanted_;
    needs.dither = dither_wanted_;
    return needs;
  }

  /// Describes group `number`, and lights its vertices where they are shaded.
  void make(const Mesh& mesh, const Transform& transform, const Material& material, const SurfaceNeeds& needs,
            const Camera& camera, Link number, const VertexStore& store, FramePools<Traits>& pools) {
    ShadingGroup& shading = pools.shading[number];
    shading.vertex_shades = store.shades.data();
    shading.colour = LitColour::from(material.colour);
    describe(mesh, transform, material, needs, camera, number, store, pools);
    set_layering(material, number, shading);
    if (material.lit) set_lights(lighting_, transform, shading);  // others have full ambient light
    if (!store.shades.empty()) shade(mesh, material, needs, number, pools, store.shades.data());
  }
  /// Says how a group shows what lies behind it, where the list has shaders that do.
  void set_layering([[maybe_unused]] const Material& material, [[maybe_unused]] Link number,
                    [[maybe_unused]] ShadingGroup& shading) const {
    if constexpr (Traits::Shaders::see_through) shading.layering = layering_of(material, number, stipple_seed_);
  }

 private:
  struct NoEffects {};

  /// What shaders other than flat and Gouraud need to know.
  void describe([[maybe_unused]] const Mesh& mesh, [[maybe_unused]] const Transform& transform,
                [[maybe_unused]] const Material& material, [[maybe_unused]] const SurfaceNeeds& needs,
                [[maybe_unused]] const Camera& camera, [[maybe_unused]] Link number,
                [[maybe_unused]] const VertexStore& store, [[maybe_unused]] FramePools<Traits>& pools) {
    if constexpr (Set::has_textures || Set::has_local_light) {
      ShadingGroup& shading = pools.shading[number];
      const bool local_light = Set::has_local_light && needs.local_light;
      if (!needs.textured && !Set::is_general(shading.shader) && !local_light) return;
      TexturedGroup& more = pools.textured[number];
      more = {needs.textured ? store.textures.data() : nullptr, material.texturing, material.colour,
              !store.shades.empty() && material.shading == ShadingMode::gouraud, Set::kind_of_shades(mesh, material)};
      if constexpr (Set::has_effects) more.effects = &effects_;
      if constexpr (Set::has_pixelwise) {
        pools.pixelwise[number] = {material.relief, material.volume, store.thirds.data()};
        more.pixelwise = &pools.pixelwise[number];
      }
      if constexpr (Set::has_local_light) {
        // In place: it is too large for a temporary on small stacks.
        if (local_light)
          more.local = new (&pools.local_lights[number]) LocalLighting(lighting_, camera, mesh, transform, material);
      }
      shading.textured = &more;
    }
  }

  void shade(const Mesh& mesh, const Material& material, const SurfaceNeeds& needs, Link number,
             FramePools<Traits>& pools, std::uint32_t* shades) const {
    ShadingGroup& shading = pools.shading[number];
    if constexpr (Set::has_translucent) {
      if (Set::varying_opacity(mesh)) return shade_translucent_vertices(mesh, material.colour, shading, shades);
    }
    light(mesh, material, needs, shading, shades);
    if constexpr (Set::has_ramps) {
      if (!mesh.vertex_colours.empty()) return;
      std::uint16_t* ramp = pools.ramps.data() + number * gouraud::ramp_size;
      fill_ramp<Format>(LitColour::from(material.colour), ramp);
      shading.ramp = ramp;
    }
  }
  static void light(const Mesh& mesh, [[maybe_unused]] const Material& material,
                    [[maybe_unused]] const SurfaceNeeds& needs, const ShadingGroup& shading, std::uint32_t* shades) {
    if constexpr (Set::has_relief) {
      if (needs.relief) return shade_vertices_for_relief(mesh, shading, shades);
    }
    if constexpr (Set::has_local_light) {
      if (Set::has_volumes && shade_kind(mesh, material) == vertex_shade::Kind::highlight_and_intensity)
        return shade_solid_vertices_locally(mesh, *shading.textured->local, shades);
      if (needs.local_light) return shade_vertices_locally(mesh, material.colour, *shading.textured->local, shades);
    }
    shade_vertices(mesh, shading, shades);
  }

  Lighting lighting_{};
  std::uint8_t stipple_seed_ = 0;
  bool fog_wanted_ = false, dither_wanted_ = false;
  [[no_unique_address]] std::conditional_t<Set::has_effects, FrameEffects, NoEffects> effects_;
};

}  // namespace spanline
