#pragma once
#include <concepts>
#include <cstdint>
#include <type_traits>

#include "spanline/frame/shader_set.hpp"
#include "spanline/frame/status.hpp"
#include "spanline/model/material.hpp"
#include "spanline/model/mesh.hpp"
#include "spanline/shade/layer/layering.hpp"

namespace spanline {

/// What a frame asks of every shader.
struct FrameNeeds {
  bool point_lights = false;  ///< there are some
  bool fog = false;           ///< colours fade into it
  bool dither = false;        ///< ordered dither
};

/// What an instance asks of a shader: of its mesh, its material and the frame.
struct SurfaceNeeds {
  bool smooth = false;            ///< Gouraud shading
  bool vertex_colours = false;    ///< the mesh has them
  bool mapped = false;            ///< a texture lies on the mesh
  bool relief = false;            ///< bump mapping or embossing (shade/pixelwise/relief.hpp)
  bool volume = false;            ///< a solid (shade/pixelwise/volume.hpp)
  bool textured = false;          ///< its vertices take texture coordinates, for one of these three
  bool local_light = false;       ///< point lights or highlights (shade/light/local_light.hpp)
  bool fog = false;               ///< of the frame
  bool dither = false;            ///< of the frame
  bool effects = false;           ///< one of these two
  bool holes = false;             ///< texels that are not there
  bool opacity_a_vertex = false;  ///< the mesh has opacities of its own
  bool varies = false;            ///< the opacity, over a polygon
  bool see_through = false;       ///< something may be seen behind it, if only in places
};

/// What a mesh in a material asks of a shader.
[[nodiscard]] inline SurfaceNeeds needs_of(const Mesh& mesh, const Material& material, const FrameNeeds& frame) {
  SurfaceNeeds needs;
  needs.smooth = material.shading == ShadingMode::gouraud;
  needs.vertex_colours = !mesh.vertex_colours.empty();
  needs.mapped = material.texturing.lies_on(mesh);
  needs.relief = material.lit && material.relief.heights != nullptr && !mesh.texture_coordinates.empty();
  needs.volume = material.volume.source != SolidSource::none;
  needs.textured = needs.mapped || needs.relief || needs.volume;
  needs.local_light = material.shines() || (material.lit && frame.point_lights);
  needs.fog = frame.fog;
  needs.dither = frame.dither;
  needs.effects = needs.fog || needs.dither;
  const bool texels_have_alpha = needs.mapped && has_alpha(material.texturing);
  needs.holes = texels_have_alpha && material.texturing.alpha == TexelAlpha::cut_out;
  needs.opacity_a_vertex = !mesh.vertex_opacities.empty();
  needs.varies = needs.opacity_a_vertex || (texels_have_alpha && !needs.holes);
  needs.see_through = needs.varies || is_see_through(material);
  return needs;
}

/// Whether a shader says itself which surfaces it draws, as those of programs do: no line here names them.
template <class Shader>
concept SaysWhatItDraws = requires(const Material& material, const SurfaceNeeds& needs) {
  { Shader::draws(material, needs) } -> std::same_as<bool>;
};

/// Whether a shader serves a material, but for its opacity.
template <class Shader, class Format>
[[nodiscard]] constexpr bool serves(const Material& material, const SurfaceNeeds& needs) {
  if constexpr (SaysWhatItDraws<Shader>) return Shader::draws(material, needs);
  if (needs.volume || needs.relief) {
    if (needs.relief && (needs.volume || needs.local_light)) return false;
    if constexpr (DrawsVolumes<Shader>) return needs.volume && Shader::serves(material, needs.vertex_colours);
    if constexpr (std::is_same_v<Shader, ReliefShader<Format>>)
      return needs.relief && Shader::serves(material, needs.vertex_colours);
    return false;
  }
  // Of those that draw textures, the general shader alone has all effects and local light; some are for fog.
  if constexpr (std::is_same_v<Shader, GeneralShader<Format>>)
    return needs.mapped || needs.effects;
  else if constexpr (Fogged<Shader>)
    return needs.mapped && needs.fog && !needs.dither && !needs.local_light &&
           Shader::serves(material, needs.vertex_colours);
  else if constexpr (DrawsTextures<Shader>)
    return needs.mapped && !needs.effects && !needs.local_light && Shader::serves(material, needs.vertex_colours);
  else if (needs.effects || needs.mapped)
    return false;
  else if (!needs.smooth)
    return needs.local_light ? std::is_same_v<Shader, LocalFlatShader<Format>>
                             : std::is_same_v<Shader, FlatShader<Format>>;
  else if (needs.vertex_colours || (needs.local_light && material.shines()))
    return std::is_same_v<Shader, GouraudColourShader<Format>>;
  else
    return std::is_same_v<Shader, GouraudShader<Format>>;
}

/// Whether no shader of the library is for it: relief knows no other light than the group's own and no solid, and
/// neither of both nor local light goes with opacities that vary.
[[nodiscard]] constexpr bool is_mixture(const SurfaceNeeds& needs) {
  if (needs.relief && (needs.volume || needs.local_light)) return true;
  return (needs.varies && (needs.relief || needs.volume)) || (needs.opacity_a_vertex && needs.local_light);
}

/// The place in the list of the shader that serves a surface; the list's `count` if there is none.
template <class Traits>
[[nodiscard]] constexpr std::uint8_t shader_for(const Material& material, const SurfaceNeeds& needs) {
  using Shaders = typename Traits::Shaders;
  using Format = typename Traits::Format;
  // Without the shader for it vertices know no local light either, and opacities of vertices go with the group's own.
  if (needs.local_light && (!ShaderSet<Traits>::has_local_light || needs.opacity_a_vertex)) return Shaders::count;
  return Shaders::first([&]<class Shader>() {
    if constexpr (Translucent<Shader>)
      return needs.see_through && !needs.relief && !needs.volume;
    else if constexpr (SeeThrough<Shader>)
      return needs.see_through && !needs.varies && serves<typename Shader::Inner, Format>(material, needs);
    else
      return !needs.see_through && serves<Shader, Format>(material, needs);
  });
}

/// What a list of shaders without one for a surface lacks: the first that it would have to have.
template <class Traits>
[[nodiscard]] constexpr MissingShader missing_for(const Material& material, const SurfaceNeeds& needs) {
  using Set = ShaderSet<Traits>;
  using enum MissingShader;
  if (is_mixture(needs)) return mixture;
  if (needs.volume && !Set::has_volumes) return volume;
  if (needs.relief && !Set::has_relief) return relief;
  if (needs.local_light && !Set::has_local_light) return local_light;
  if (needs.mapped && !Set::has_textures) return needs.see_through ? translucent_texture : texture;
  if (needs.opacity_a_vertex) return varying_opacity;
  if (needs.varies) return translucent_texture;
  // An opaque one would be served: the list has it, and nothing that is seen through.
  if (needs.see_through) {
    SurfaceNeeds opaque = needs;
    opaque.see_through = false;
    if (shader_for<Traits>(material, opaque) < Traits::Shaders::count)
      return needs.mapped ? translucent_texture : see_through;
  }
  if (needs.effects) return needs.fog ? fog : dither;
  if (needs.textured) return texture;
  if (!needs.smooth) return flat;
  return needs.vertex_colours || material.shines() ? vertex_colours : gouraud;
}

}  // namespace spanline
