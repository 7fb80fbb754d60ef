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

/// What a frame requires of every shader.
struct FrameNeeds {
  bool point_lights = false;  ///< there are point lights
  bool fog = false;           ///< the frame has fog
  bool dither = false;        ///< ordered dither
};

/// What an instance requires of a shader, because of its mesh, its material and the frame.
struct SurfaceNeeds {
  bool smooth = false;            ///< Gouraud shading
  bool vertex_colours = false;    ///< the mesh has vertex colours
  bool mapped = false;            ///< the mesh is textured
  bool relief = false;            ///< bump mapping or embossing (shade/pixelwise/relief.hpp)
  bool volume = false;            ///< a solid (shade/pixelwise/volume.hpp)
  bool textured = false;          ///< vertices need texture coordinates for one of the three above
  bool local_light = false;       ///< point lights or highlights (shade/light/local_light.hpp)
  bool fog = false;               ///< the frame has fog
  bool dither = false;            ///< the frame has dither
  bool effects = false;           ///< fog or dither
  bool holes = false;             ///< some texels may be absent
  bool opacity_a_vertex = false;  ///< the mesh has vertex opacities
  bool varies = false;            ///< the opacity varies over a polygon
  bool see_through = false;       ///< some points may be seen through
};

/// What a mesh with a material requires of a shader.
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

/// Whether a shader decides itself which surfaces it draws. Shaders that programs add do so, because this file does not
/// know them.
template <class Shader>
concept SaysWhatItDraws = requires(const Material& material, const SurfaceNeeds& needs) {
  { Shader::draws(material, needs) } -> std::same_as<bool>;
};

/// Whether a shader can draw a material, apart from its opacity.
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
  // Of the shaders that draw textures, only the general shader has all effects and local light; some others draw only
  // in fog.
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

/// Whether no shader of the library can draw a surface. Relief works only with the group's own lights and without a
/// solid, an opacity that varies works neither with relief nor with solids, and vertex opacities do not work with local
/// light.
[[nodiscard]] constexpr bool is_mixture(const SurfaceNeeds& needs) {
  if (needs.relief && (needs.volume || needs.local_light)) return true;
  return (needs.varies && (needs.relief || needs.volume)) || (needs.opacity_a_vertex && needs.local_light);
}

/// The index of the shader that draws a surface; the list's `count` if there is none.
template <class Traits>
[[nodiscard]] constexpr std::uint8_t shader_for(const Material& material, const SurfaceNeeds& needs) {
  using Shaders = typename Traits::Shaders;
  using Format = typename Traits::Format;
  // Without LocalFlatShader in the list vertices are not lit locally either, and vertex opacities allow only the
  // group's own lights.
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

/// The first shader that a list lacks to draw a surface.
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
  // The list could draw the surface if it were opaque; only the see-through shader is missing.
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
