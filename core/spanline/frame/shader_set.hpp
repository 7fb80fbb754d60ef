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

/// What a renderer's list of shaders has: a program links nothing else, and its pools hold nothing else.
template <class Traits>
struct ShaderSet {
  using Shaders = typename Traits::Shaders;  ///< the list
  using Format = typename Traits::Format;    ///< of pixels

  /// Whether a shader is in the list as it is.
  template <class Shader>
  static constexpr bool has = Shaders::template index_of<Shader> < Shaders::count;
  /// Whether a shader is in the list, plain or seen through.
  template <class Shader>
  static constexpr bool has_colours_of = Shaders::first([]<class S>() {
                                           return std::is_same_v<ColourShader<S>, Shader>;
                                         }) < Shaders::count;

  /// Places in the list; its `count` for shaders that it does not have.
  static constexpr std::uint8_t general = Shaders::template index_of<GeneralShader<Format>>;
  /// The place of the shader for opacities that vary over a polygon.
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

  /// Whether a place in the list is that of a shader with all effects.
  [[nodiscard]] static constexpr bool is_general(std::uint8_t shader) {
    if constexpr (has_translucent) {
      if (shader == translucent) return true;
    }
    return has_effects && shader == general;
  }
};

}  // namespace spanline
