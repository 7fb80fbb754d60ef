#pragma once
#include "spanline/model/material.hpp"
#include "spanline/raster/depth_format.hpp"
#include "spanline/shade/flat.hpp"
#include "spanline/shade/general_shader.hpp"
#include "spanline/shade/gouraud.hpp"
#include "spanline/shade/pixel_format.hpp"
#include "spanline/shade/polygon_id.hpp"
#include "spanline/shade/see_through.hpp"
#include "spanline/shade/shader_list.hpp"
#include "spanline/shade/textured.hpp"
#include "spanline/visibility/depth_buffer.hpp"
#include "spanline/visibility/span/spanning_scan_line.hpp"

namespace spanline {

/// What a renderer is made of, chosen when the program is compiled. A program links what its traits name and nothing
/// else.
template <class DepthFormatT, class PixelFormat, class ShaderListT, bool Statistics = false,
          class VisibilityT = ZBuffer>
struct RendererTraits {
  using Depth = DepthFormatT;      ///< Depth16<…> or Depth24<…>
  using Format = PixelFormat;      ///< Rgb565, Rgb565Swapped or PolygonIds
  using Shaders = ShaderListT;     ///< ShaderList<…>
  using Visibility = VisibilityT;  ///< ZBuffer or Spanning
  static constexpr bool statistics =
      Statistics;  ///< count spans, pixels and depth tests, and tell the sink of covered polygons
};

/// Flat shading, 16-bit depth: the smallest renderer.
template <class Format = Rgb565, class Depth = Depth16<>, bool Statistics = false, class Visibility = ZBuffer>
using FlatTraits = RendererTraits<Depth, Format, ShaderList<FlatShader<Format>>, Statistics, Visibility>;

/// Flat and Gouraud shading, with vertex colours.
template <class Format = Rgb565, class Depth = Depth16<>, bool Statistics = false, class Visibility = ZBuffer>
using FullTraits =
    RendererTraits<Depth, Format, ShaderList<FlatShader<Format>, GouraudShader<Format>, GouraudColourShader<Format>>,
                   Statistics, Visibility>;

/// Flat and Gouraud shading, opaque and see-through.
template <class Format = Rgb565, class Depth = Depth16<>, bool Statistics = false, class Visibility = ZBuffer>
using SeeThroughTraits = RendererTraits<
    Depth, Format,
    ShaderList<FlatShader<Format>, GouraudShader<Format>, GouraudColourShader<Format>,
               SeeThroughShader<Format, FlatShader<Format>>, SeeThroughShader<Format, GouraudShader<Format>>,
               SeeThroughShader<Format, GouraudColourShader<Format>>>,
    Statistics, Visibility>;

/// Draws polygon numbers instead of colours.
template <class Depth = Depth16<>, bool Statistics = false, class Visibility = ZBuffer>
using IdTraits = RendererTraits<Depth, PolygonIds, ShaderList<IdShader>, Statistics, Visibility>;

/// Textures of RGB565 that repeat, read at their nearest texel, beside flat and Gouraud shading: unlit, and under white
/// light of either kind.
template <class Format = Rgb565, class Depth = Depth16<>, bool Statistics = false, class Visibility = ZBuffer>
using TextureTraits = RendererTraits<Depth, Format,
                                     ShaderList<FlatShader<Format>, GouraudShader<Format>, GouraudColourShader<Format>,
                                                RepeatedTextureShader<Format, TexelFormat::rgb565, NoTexelLight>,
                                                RepeatedTextureShader<Format, TexelFormat::rgb565, FlatTexelLight>,
                                                RepeatedTextureShader<Format, TexelFormat::rgb565, GouraudTexelLight>>,
                                     Statistics, Visibility>;

/// The same shaders, and one behind them that serves whatever they do not: other texel formats, clamping, bilinear
/// filtering, mip maps, texture functions, coloured surfaces under a texture, fog and dither.
template <class Format = Rgb565, class Depth = Depth16<>, bool Statistics = false, class Visibility = ZBuffer>
using GeneralTraits = RendererTraits<
    Depth, Format,
    ShaderList<FlatShader<Format>, GouraudShader<Format>, GouraudColourShader<Format>,
               RepeatedTextureShader<Format, TexelFormat::rgb565, NoTexelLight>,
               RepeatedTextureShader<Format, TexelFormat::rgb565, FlatTexelLight>,
               RepeatedTextureShader<Format, TexelFormat::rgb565, GouraudTexelLight>, GeneralShader<Format>>,
    Statistics, Visibility>;

/// Whether a shader draws textures: it says which materials it serves.
template <class Shader>
concept DrawsTextures = requires(const Material& material) {
  Shader::serves(material, true);
};

/// Whether a shader serves a material on a mesh, but for its opacity.
template <class Shader, class Format>
[[nodiscard]] constexpr bool serves(const Material& material, bool vertex_colours, bool textured) {
  if constexpr (DrawsTextures<Shader>)
    return textured && Shader::serves(material, vertex_colours);
  else if (textured)
    return false;
  else if (material.shading == ShadingMode::flat)
    return std::is_same_v<Shader, FlatShader<Format>>;
  else if (vertex_colours)
    return std::is_same_v<Shader, GouraudColourShader<Format>>;
  else
    return std::is_same_v<Shader, GouraudShader<Format>>;
}

/// The place in the list of the shader that serves a material on a mesh, in a frame with effects or without; the list's
/// `count` if there is none.
template <class Traits>
[[nodiscard]] constexpr std::uint8_t shader_for(const Material& material, bool vertex_colours, bool textured,
                                                bool effects) {
  using Shaders = typename Traits::Shaders;
  using Format = typename Traits::Format;
  if constexpr (Shaders::template index_of<IdShader> < Shaders::count) {
    return Shaders::template index_of<IdShader>;
  } else {
    if (is_see_through(material))
      return Shaders::first([&]<class Shader>() {
        if constexpr (SeeThrough<Shader>)
          return (!effects || std::is_same_v<typename Shader::Inner, GeneralShader<Format>>)&&serves<
              typename Shader::Inner, Format>(material, vertex_colours, textured);
        else
          return false;
      });
    if (effects) return Shaders::template index_of<GeneralShader<Format>>;
    if (textured)
      return Shaders::first([&]<class Shader>() {
        if constexpr (DrawsTextures<Shader>)
          return Shader::serves(material, vertex_colours);
        else
          return false;
      });
    if (material.shading == ShadingMode::flat) return Shaders::template index_of<FlatShader<Format>>;
    if (vertex_colours) return Shaders::template index_of<GouraudColourShader<Format>>;
    return Shaders::template index_of<GouraudShader<Format>>;
  }
}

}  // namespace spanline
