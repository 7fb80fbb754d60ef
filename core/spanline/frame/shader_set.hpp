#pragma once
#include <cstdint>
#include <type_traits>

#include "spanline/model/material.hpp"
#include "spanline/shade/general/general_shader.hpp"
#include "spanline/shade/layer/see_through.hpp"
#include "spanline/shade/layer/translucent.hpp"
#include "spanline/shade/light/flat.hpp"
#include "spanline/shade/light/gouraud.hpp"
#include "spanline/shade/light/local_flat.hpp"
#include "spanline/shade/pixelwise/relief.hpp"
#include "spanline/shade/pixelwise/volume.hpp"
#include "spanline/shade/polygon_id.hpp"
#include "spanline/shade/shader_list.hpp"
#include "spanline/shade/texture/fogged_texel_light.hpp"
#include "spanline/shade/texture/texture_shader.hpp"

namespace spanline {

/// The shader that computes the colours: that inside a see-through shader, or the shader itself.
template <class Shader>
struct ColourShaderOf {
  using type = Shader;  ///< itself
};
/// The case of a see-through shader.
template <SeeThrough Shader>
struct ColourShaderOf<Shader> {
  using type = typename Shader::Inner;  ///< the shader inside
};
/// The same as a type.
template <class Shader>
using ColourShader = typename ColourShaderOf<Shader>::type;

/// Whether a shader draws textures; such a shader says which materials it serves.
template <class Shader>
concept DrawsTextures = requires(const Material& material) {
  Shader::serves(material, true);
};

/// Whether a shader draws only in frames with fog.
template <class Shader>
concept Fogged = DrawsTextures<Shader> && requires {
  requires Shader::fogged;
};

/// Whether a see-through shader's opacity may vary over a polygon.
template <class Shader>
concept Translucent = SeeThrough<Shader> && requires {
  requires Shader::Inner::translucent;
};

/// What a renderer's list of shaders contains. A program links only this, and its pools hold only data for it.
template <class Traits>
struct ShaderSet {
  using Shaders = typename Traits::Shaders;  ///< the list
  using Format = typename Traits::Format;    ///< of pixels

  /// Whether exactly this shader is in the list.
  template <class Shader>
  static constexpr bool has = Shaders::template index_of<Shader> < Shaders::count;
  /// Whether a shader is in the list, by itself or inside a see-through shader.
  template <class Shader>
  static constexpr bool has_colours_of = Shaders::first([]<class S>() {
                                           return std::is_same_v<ColourShader<S>, Shader>;
                                         }) < Shaders::count;

  /// Index in the list; its `count` for shaders that it does not have.
  static constexpr std::uint8_t general = Shaders::template index_of<GeneralShader<Format>>;
  /// Index of the shader for opacities that vary over a polygon.
  static constexpr std::uint8_t translucent = Shaders::first([]<class Shader>() { return Translucent<Shader>; });
  static constexpr bool has_ids = has<IdShader>;                            ///< numbers are drawn, not colours
  static constexpr bool has_translucent = translucent < Shaders::count;     ///< opacities that vary over a polygon
  static constexpr bool has_ramps = has<GouraudShader<Format>>;             ///< groups have a ramp of their colour
  static constexpr bool has_local_light = has<LocalFlatShader<Format>>;     ///< point lights and highlights
  static constexpr bool has_relief = has_colours_of<ReliefShader<Format>>;  ///< bump mapping and embossing
  /// Vertices have shades.
  static constexpr bool has_shades = has_ramps || has_translucent || has<GouraudColourShader<Format>>;
  /// Vertices have texture coordinates.
  static constexpr bool has_textures =
      Shaders::first([]<class Shader>() { return DrawsTextures<ColourShader<Shader>>; }) < Shaders::count;
  /// Surfaces are cut from solids: vertices have a third texture coordinate.
  static constexpr bool has_volumes =
      Shaders::first([]<class Shader>() { return DrawsVolumes<ColourShader<Shader>>; }) < Shaders::count;
  static constexpr bool has_pixelwise = has_relief || has_volumes;  ///< groups have a PixelwiseGroup
  /// Fog or dither.
  static constexpr bool has_effects =
      general < Shaders::count || has_translucent || has_pixelwise ||
      Shaders::first([]<class Shader>() { return Fogged<ColourShader<Shader>>; }) < Shaders::count;

  /// Whether the shader at an index has all effects.
  [[nodiscard]] static constexpr bool is_general(std::uint8_t shader) {
    if constexpr (has_translucent) {
      if (shader == translucent) return true;
    }
    return has_effects && shader == general;
  }
};

}  // namespace spanline
