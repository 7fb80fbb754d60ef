#pragma once
#include <concepts>
#include <cstdint>
#include <type_traits>

#include "spanline/frame/traits.hpp"
#include "spanline/model/material.hpp"
#include "spanline/shade/general/general_shader.hpp"
#include "spanline/shade/item_shaders.hpp"
#include "spanline/shade/layer/see_through.hpp"
#include "spanline/shade/layer/translucent.hpp"
#include "spanline/shade/light/flat.hpp"
#include "spanline/shade/light/gouraud.hpp"
#include "spanline/shade/light/lighting.hpp"
#include "spanline/shade/light/local_flat.hpp"
#include "spanline/shade/pixelwise/relief.hpp"
#include "spanline/shade/pixelwise/volume.hpp"
#include "spanline/shade/polygon_id.hpp"
#include "spanline/shade/shader_list.hpp"
#include "spanline/shade/texture/fogged_texel_light.hpp"
#include "spanline/shade/texture/texture_shader.hpp"

namespace spanline {

/// The shader that makes the colours of one that is seen through; others themselves.
template <class Shader>
struct ColourShaderOf {
  using type = Shader;  ///< itself
};
/// Of those that are seen through.
template <SeeThrough Shader>
struct ColourShaderOf<Shader> {
  using type = typename Shader::Inner;  ///< the one within
};
/// The same as a type.
template <class Shader>
using ColourShader = typename ColourShaderOf<Shader>::type;

/// Whether a shader draws textures: it says which materials it serves.
template <class Shader>
concept DrawsTextures = requires(const Material& material) {
  Shader::serves(material, true);
};

/// Whether a shader is for frames with fog alone.
template <class Shader>
concept Fogged = DrawsTextures<Shader> && requires {
  requires Shader::fogged;
};

/// Whether a see-through shader's opacity may vary over a polygon.
template <class Shader>
concept Translucent = SeeThrough<Shader> && requires {
  requires Shader::Inner::translucent;
};

/// What of a mesh, its material and the frame decides which shader serves.
struct SurfaceNeeds {
  bool vertex_colours = false;  ///< the mesh has colours of its own
  bool textured = false;        ///< by coordinates of its vertices
  bool effects = false;         ///< fog or dither
  bool varies = false;          ///< the opacity, over a polygon
  bool local_light = false;     ///< point lights or highlights (shade/local_light.hpp)
  bool relief = false;          ///< bump mapping or embossing (shade/relief.hpp)
  bool volume = false;          ///< a solid (shade/volume.hpp)
  bool dither = false;          ///< of the effects
  bool holes = false;           ///< texels that are not there
};

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
    return needs.textured || needs.effects;
  else if constexpr (Fogged<Shader>)
    return needs.textured && needs.effects && !needs.dither && !needs.local_light &&
           Shader::serves(material, needs.vertex_colours);
  else if constexpr (DrawsTextures<Shader>)
    return needs.textured && !needs.effects && !needs.local_light && Shader::serves(material, needs.vertex_colours);
  else if (needs.effects || needs.textured)
    return false;
  else if (material.shading == ShadingMode::flat)
    return needs.local_light ? std::is_same_v<Shader, LocalFlatShader<Format>>
                             : std::is_same_v<Shader, FlatShader<Format>>;
  else if (needs.vertex_colours || (needs.local_light && material.shines()))
    return std::is_same_v<Shader, GouraudColourShader<Format>>;
  else
    return std::is_same_v<Shader, GouraudShader<Format>>;
}

/// The place in the list of the shader that serves a material on a mesh; the list's `count` if there is none.
template <class Traits>
[[nodiscard]] constexpr std::uint8_t shader_for(const Material& material, const SurfaceNeeds& needs) {
  using Shaders = typename Traits::Shaders;
  using Format = typename Traits::Format;
  if constexpr (Shaders::template index_of<IdShader> < Shaders::count) {
    return Shaders::template index_of<IdShader>;
  } else {
    // Without this shader vertices know no local light either.
    if (needs.local_light && Shaders::template index_of<LocalFlatShader<Format>> == Shaders::count)
      return Shaders::count;
    const bool see_through = needs.varies || is_see_through(material);
    return Shaders::first([&]<class Shader>() {
      if constexpr (Translucent<Shader>)
        return see_through && !needs.relief && !needs.volume;
      else if constexpr (SeeThrough<Shader>)
        return see_through && !needs.varies && serves<typename Shader::Inner, Format>(material, needs);
      else
        return !see_through && serves<Shader, Format>(material, needs);
    });
  }
}

/// What a renderer's list of shaders has, and so what its frames need.
template <class Traits>
struct ShaderSet {
  using Shaders = typename Traits::Shaders;  ///< the list
  using Format = typename Traits::Format;    ///< the pixel format that they are for

  /// The places of shaders with all effects; the list's `count` where there is none.
  static constexpr std::uint8_t general = Shaders::template index_of<GeneralShader<Format>>,
                                translucent = Shaders::first([]<class Shader>() { return Translucent<Shader>; });
  /// Whether ids are drawn instead of colours.
  static constexpr bool has_ids = Shaders::template index_of<IdShader> < Shaders::count;
  /// Whether opacities may vary over a polygon.
  static constexpr bool has_translucent = translucent < Shaders::count;
  /// Whether groups have ramps of pixels.
  static constexpr bool has_ramps = Shaders::template index_of<GouraudShader<Format>> < Shaders::count;
  /// Whether vertices have shades.
  static constexpr bool has_shades =
      has_ramps || has_translucent || Shaders::template index_of<GouraudColourShader<Format>> < Shaders::count;
  /// Whether textures are drawn.
  static constexpr bool has_textures =
      Shaders::first([]<class Shader>() { return DrawsTextures<ColourShader<Shader>>; }) < Shaders::count;
  /// Whether reliefs are drawn.
  static constexpr bool has_relief = Shaders::first([]<class Shader>() {
                                       return std::is_same_v<ColourShader<Shader>, ReliefShader<Format>>;
                                     }) < Shaders::count;
  /// Whether solids are drawn.
  static constexpr bool has_volumes =
      Shaders::first([]<class Shader>() { return DrawsVolumes<ColourShader<Shader>>; }) < Shaders::count;
  /// Whether any shader works out its pixels one by one.
  static constexpr bool has_pixelwise = has_relief || has_volumes;
  /// Whether fog or dither is drawn.
  static constexpr bool has_effects =
      general < Shaders::count || has_translucent || has_pixelwise ||
      Shaders::first([]<class Shader>() { return Fogged<ColourShader<Shader>>; }) < Shaders::count;
  /// Whether a place in the list is that of a shader with all effects.
  [[nodiscard]] static constexpr bool is_general(std::uint8_t shader) {
    if constexpr (has_translucent) {
      if (shader == translucent) return true;
    }
    return has_effects && shader == general;
  }
  /// Whether a material has a relief, and the mesh the coordinates for it.
  [[nodiscard]] static bool under_relief(const Mesh& mesh, const Material& material) {
    return material.lit && material.relief.heights != nullptr && !mesh.texture_coordinates.empty();
  }
  /// Whether vertices have opacities of their own, and there is a shader for them: others say so, or draw ids.
  [[nodiscard]] static bool varying_opacity(const Mesh& mesh) {
    if constexpr (has_ids) return false;
    return !mesh.vertex_opacities.empty();
  }
  /// What the shades of a mesh's vertices are.
  [[nodiscard]] static vertex_shade::Kind kind_of_shades(const Mesh& mesh, const Material& material) {
    if (has_translucent && varying_opacity(mesh)) return vertex_shade::Kind::colour_and_opacity;
    return shade_kind(mesh, material);
  }
  /// Whether point lights and highlights are drawn.
  static constexpr bool has_local_light = Shaders::template index_of<LocalFlatShader<Format>> < Shaders::count;
  /// Whether a mesh's vertices want shades.
  [[nodiscard]] static bool needs_shades(const Mesh& mesh, const Material& material) {
    if (has_translucent && varying_opacity(mesh)) return true;
    return has_shades && material.shading == ShadingMode::gouraud;
  }

  /// What decides which shader serves a mesh and a material, but for the frame's effects.
  [[nodiscard]] static SurfaceNeeds needs_of(const Mesh& mesh, const Material& material, bool point_lights) {
    SurfaceNeeds needs;
    needs.vertex_colours = !mesh.vertex_colours.empty();
    needs.relief = under_relief(mesh, material);
    needs.volume = material.volume.source != SolidSource::none;
    const bool mapped = has_textures && material.texturing.lies_on(mesh);
    needs.textured = has_textures && (mapped || needs.relief || needs.volume);
    needs.local_light = material.shines() || (material.lit && point_lights);
    const bool texels_have_alpha = mapped && has_alpha(material.texturing);
    needs.holes = texels_have_alpha && material.texturing.alpha == TexelAlpha::cut_out;
    needs.varies = varying_opacity(mesh) || (texels_have_alpha && !needs.holes);
    return needs;
  }
};

}  // namespace spanline
