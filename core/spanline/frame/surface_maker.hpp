#pragma once
#include <cstdint>
#include <new>
#include <type_traits>

#include "spanline/frame/frame_pools.hpp"
#include "spanline/frame/frame_settings.hpp"
#include "spanline/frame/instance_plan.hpp"
#include "spanline/frame/shader_set.hpp"
#include "spanline/geometry/vertex_store.hpp"
#include "spanline/model/transform.hpp"
#include "spanline/raster/link.hpp"
#include "spanline/shade/light/lighting.hpp"

namespace spanline {

/// Supplies shaders with the data of a frame and its groups: lights, effects, and what the materials require.
template <class Traits>
class SurfaceMaker {
  using Set = ShaderSet<Traits>;
  using Format = typename Traits::Format;

 public:
  /// Keeps the frame's settings that shaders need.
  void begin(const FrameSettings& settings) {
    lighting_ = settings.lighting;
    stipple_seed_ = settings.stipple_seed;
    if constexpr (Set::has_effects) {
      effects_.fogged = settings.fog.curve != FogCurve::none;
      effects_.fog_colour = settings.fog.colour;
      effects_.dither = settings.dither;
      if (effects_.fogged) effects_.fog.fill(settings.fog, settings.camera);
    }
  }

  /// Fills in the data of group `number` as planned, and lights its vertices. It is not inlined, so that
  /// its frame is gone from the stack before polygons are clipped.
  [[gnu::noinline]] void make(const Mesh& mesh, const Transform& transform, const Material& material,
                              const InstancePlan& plan, const Camera& camera, Link number, const VertexStore& store,
                              FramePools<Traits>& pools) {
    ShadingGroup& shading = pools.shading[number];
    shading.mesh = &mesh;
    shading.vertex_shades = store.shades.data();
    shading.colour = LitColour::from(material.colour);
    describe(mesh, transform, material, plan, camera, number, store, pools);
    if (material.lit) set_lights(lighting_, transform, shading);  // unlit materials have full ambient light
    if constexpr (Set::has_shades) light(mesh, material, plan, shading, store.shades.data());
    if constexpr (Set::has_ramps) {
      if (!plan.ramp) return;
      std::uint16_t* ramp = pools.ramps.data() + number * gouraud::ramp_size;
      fill_ramp<Format>(LitColour::from(material.colour), ramp);
      shading.ramp = ramp;
    }
  }
  /// Sets how a group shows what lies behind it, if the list has see-through shaders.
  void set_layering([[maybe_unused]] const Material& material, [[maybe_unused]] Link number,
                    [[maybe_unused]] ShadingGroup& shading) const {
    if constexpr (Traits::Shaders::see_through) shading.layering = layering_of(material, number, stipple_seed_);
  }

 private:
  struct NoEffects {};

  /// Fills in the data that shaders other than flat and Gouraud need.
  void describe([[maybe_unused]] const Mesh& mesh, [[maybe_unused]] const Transform& transform,
                [[maybe_unused]] const Material& material, [[maybe_unused]] const InstancePlan& plan,
                [[maybe_unused]] const Camera& camera, [[maybe_unused]] Link number,
                [[maybe_unused]] const VertexStore& store, [[maybe_unused]] FramePools<Traits>& pools) {
    if constexpr (Set::has_textures || Set::has_local_light) {
      if (!plan.described) return;
      TexturedGroup& more = pools.textured[number];
      more = {store.textures.data(), material.texturing, material.colour, plan.smooth, plan.shades};
      if constexpr (Set::has_effects) more.effects = &effects_;
      if constexpr (Set::has_pixelwise) {
        pools.pixelwise[number] = {material.relief, material.volume, store.thirds.data()};
        more.pixelwise = &pools.pixelwise[number];
      }
      if constexpr (Set::has_local_light) {
        // It is built in place, because it is too large for a temporary on small stacks.
        if (plan.local_light)
          more.local = new (&pools.local_lights[number]) LocalLighting(lighting_, camera, mesh, transform, material);
      }
      pools.shading[number].textured = &more;
    }
  }

  static void light(const Mesh& mesh, [[maybe_unused]] const Material& material, const InstancePlan& plan,
                    const ShadingGroup& shading, std::uint32_t* shades) {
    if constexpr (Set::has_translucent) {
      if (plan.lighting == VertexLighting::with_opacity)
        return shade_translucent_vertices(mesh, material.colour, shading, shades);
    }
    if constexpr (Set::has_relief) {
      if (plan.lighting == VertexLighting::on_relief) return shade_vertices_for_relief(mesh, shading, shades);
    }
    if constexpr (Set::has_local_light) {
      if (Set::has_volumes && plan.lighting == VertexLighting::local_on_solid)
        return shade_solid_vertices_locally(mesh, *shading.textured->local, shades);
      if (plan.lighting == VertexLighting::local)
        return shade_vertices_locally(mesh, material.colour, *shading.textured->local, shades);
    }
    if (plan.lighting == VertexLighting::plain) shade_vertices(mesh, shading, shades);
  }

  Lighting lighting_{};
  std::uint8_t stipple_seed_ = 0;
  [[no_unique_address]] std::conditional_t<Set::has_effects, FrameEffects, NoEffects> effects_;
};

}  // namespace spanline
