#pragma once
#include "spanline/model/material.hpp"
#include "spanline/raster/depth_format.hpp"
#include "spanline/shade/flat.hpp"
#include "spanline/shade/fogged_texels.hpp"
#include "spanline/shade/general_shader.hpp"
#include "spanline/shade/gouraud.hpp"
#include "spanline/shade/item_shaders.hpp"
#include "spanline/shade/local_flat.hpp"
#include "spanline/shade/pixel_format.hpp"
#include "spanline/shade/polygon_id.hpp"
#include "spanline/shade/relief.hpp"
#include "spanline/shade/see_through.hpp"
#include "spanline/shade/shader_list.hpp"
#include "spanline/shade/textured.hpp"
#include "spanline/shade/translucent.hpp"
#include "spanline/shade/volume.hpp"
#include "spanline/visibility/deferred.hpp"
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
  using Visibility = VisibilityT;  ///< ZBuffer, BoundedZBuffer, Deferred<…> or Spanning
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

/// Flat and Gouraud shading, with point lights and highlights.
template <class Format = Rgb565, class Depth = Depth16<>, bool Statistics = false, class Visibility = ZBuffer>
using LocalLightTraits = RendererTraits<
    Depth, Format,
    ShaderList<FlatShader<Format>, GouraudShader<Format>, GouraudColourShader<Format>, LocalFlatShader<Format>>,
    Statistics, Visibility>;

/// Flat and Gouraud shading, opaque and see-through.
template <class Format = Rgb565, class Depth = Depth16<>, bool Statistics = false, class Visibility = ZBuffer>
using SeeThroughTraits = RendererTraits<
    Depth, Format,
    ShaderList<FlatShader<Format>, GouraudShader<Format>, GouraudColourShader<Format>,
               SeeThroughShader<Format, FlatShader<Format>>, SeeThroughShader<Format, GouraudShader<Format>>,
               SeeThroughShader<Format, GouraudColourShader<Format>>>,
    Statistics, Visibility>;

/// All of those, opaque and see-through, and opacities that vary over a polygon.
template <class Format = Rgb565, class Depth = Depth16<>, bool Statistics = false, class Visibility = ZBuffer>
using GeneralSeeThroughTraits = RendererTraits<
    Depth, Format,
    ShaderList<FlatShader<Format>, GouraudShader<Format>, GouraudColourShader<Format>,
               RepeatedTextureShader<Format, TexelFormat::rgb565, NoTexelLight>,
               RepeatedTextureShader<Format, TexelFormat::rgb565, FlatTexelLight>,
               RepeatedTextureShader<Format, TexelFormat::rgb565, GouraudTexelLight>,
               LevelTextureShader<Format, TextureFilter::bilinear, NoTexelLight>,
               LevelTextureShader<Format, TextureFilter::bilinear, FlatTexelLight>,
               LevelTextureShader<Format, TextureFilter::bilinear, GouraudTexelLight>,
               LevelTextureShader<Format, TextureFilter::nearest, NoTexelLight>,
               LevelTextureShader<Format, TextureFilter::nearest, FlatTexelLight>,
               LevelTextureShader<Format, TextureFilter::nearest, GouraudTexelLight>, GeneralShader<Format>,
               LocalFlatShader<Format>, ReliefShader<Format>, VolumeShader<Format>,
               SeeThroughShader<Format, FlatShader<Format>>, SeeThroughShader<Format, GouraudShader<Format>>,
               SeeThroughShader<Format, GouraudColourShader<Format>>, SeeThroughShader<Format, ReliefShader<Format>>,
               SeeThroughShader<Format, VolumeShader<Format>>, SeeThroughShader<Format, TranslucentShader<Format>>>,
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

/// The same, and textures in fog. In a frame with fog it draws nothing but those.
template <class Format = Rgb565, class Depth = Depth16<>, bool Statistics = false, class Visibility = ZBuffer>
using FoggedTextureTraits =
    RendererTraits<Depth, Format,
                   ShaderList<FlatShader<Format>, GouraudShader<Format>, GouraudColourShader<Format>,
                              RepeatedTextureShader<Format, TexelFormat::rgb565, NoTexelLight>,
                              RepeatedTextureShader<Format, TexelFormat::rgb565, FlatTexelLight>,
                              RepeatedTextureShader<Format, TexelFormat::rgb565, GouraudTexelLight>,
                              FoggedTextureShader<Format, TexelFormat::rgb565>>,
                   Statistics, Visibility>;

/// The shaders of TextureTraits, and one behind them that serves whatever they do not: other texel formats, clamping,
/// bilinear filtering, mip maps, texture functions, coloured surfaces under a texture, fog and dither; and point
/// lights, highlights, relief and solids of tables.
template <class Format = Rgb565, class Depth = Depth16<>, bool Statistics = false, class Visibility = ZBuffer>
using GeneralTraits = RendererTraits<
    Depth, Format,
    ShaderList<FlatShader<Format>, GouraudShader<Format>, GouraudColourShader<Format>,
               RepeatedTextureShader<Format, TexelFormat::rgb565, NoTexelLight>,
               RepeatedTextureShader<Format, TexelFormat::rgb565, FlatTexelLight>,
               RepeatedTextureShader<Format, TexelFormat::rgb565, GouraudTexelLight>,
               LevelTextureShader<Format, TextureFilter::bilinear, NoTexelLight>,
               LevelTextureShader<Format, TextureFilter::bilinear, FlatTexelLight>,
               LevelTextureShader<Format, TextureFilter::bilinear, GouraudTexelLight>,
               LevelTextureShader<Format, TextureFilter::nearest, NoTexelLight>,
               LevelTextureShader<Format, TextureFilter::nearest, FlatTexelLight>,
               LevelTextureShader<Format, TextureFilter::nearest, GouraudTexelLight>, GeneralShader<Format>,
               LocalFlatShader<Format>, ReliefShader<Format>, VolumeShader<Format>>,
    Statistics, Visibility>;

/// The shader that makes the colours of one that is seen through; others themselves.
template <class Shader>
struct ColourShaderOf {
  using type = Shader;
};
template <SeeThrough Shader>
struct ColourShaderOf<Shader> {
  using type = typename Shader::Inner;
};
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
  bool vertex_colours = false, textured = false;
  bool effects = false;      ///< fog or dither
  bool varies = false;       ///< the opacity, over a polygon
  bool local_light = false;  ///< point lights or highlights (shade/local_light.hpp)
  bool relief = false;       ///< bump mapping or embossing (shade/relief.hpp)
  bool volume = false;       ///< a solid (shade/volume.hpp)
  bool dither = false;       ///< of the effects
};

/// Whether a shader serves a material, but for its opacity.
template <class Shader, class Format>
[[nodiscard]] constexpr bool serves(const Material& material, const SurfaceNeeds& needs) {
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

}  // namespace spanline
