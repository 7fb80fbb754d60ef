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

// Lists of shaders, each longer than the one before it.

/// Flat and Gouraud shading, with vertex colours.
template <class Format>
using PlainShaders = ShaderList<FlatShader<Format>, GouraudShader<Format>, GouraudColourShader<Format>>;

/// And textures of RGB565 that repeat, read at their nearest texel: unlit, and under white light of either kind.
template <class Format>
using TextureShaders =
    WithShaders<PlainShaders<Format>, RepeatedTextureShader<Format, TexelFormat::rgb565, NoTexelLight>,
                RepeatedTextureShader<Format, TexelFormat::rgb565, FlatTexelLight>,
                RepeatedTextureShader<Format, TexelFormat::rgb565, GouraudTexelLight>>;

/// And such textures with mip maps and bilinear filtering; one shader behind them that serves whatever they do not:
/// other texel formats, clamping, texture functions, coloured surfaces under a texture, fog and dither; and point
/// lights, highlights, relief and solids of tables.
template <class Format>
using GeneralShaders =
    WithShaders<TextureShaders<Format>, LevelTextureShader<Format, TextureFilter::bilinear, NoTexelLight>,
                LevelTextureShader<Format, TextureFilter::bilinear, FlatTexelLight>,
                LevelTextureShader<Format, TextureFilter::bilinear, GouraudTexelLight>,
                LevelTextureShader<Format, TextureFilter::nearest, NoTexelLight>,
                LevelTextureShader<Format, TextureFilter::nearest, FlatTexelLight>,
                LevelTextureShader<Format, TextureFilter::nearest, GouraudTexelLight>, GeneralShader<Format>,
                LocalFlatShader<Format>, ReliefShader<Format>, VolumeShader<Format>>;

/// Flat shading, 16-bit depth: the smallest renderer.
template <class Format = Rgb565, class Depth = Depth16<>, bool Statistics = false, class Visibility = ZBuffer>
using FlatTraits = RendererTraits<Depth, Format, ShaderList<FlatShader<Format>>, Statistics, Visibility>;

/// Flat and Gouraud shading, with vertex colours.
template <class Format = Rgb565, class Depth = Depth16<>, bool Statistics = false, class Visibility = ZBuffer>
using FullTraits = RendererTraits<Depth, Format, PlainShaders<Format>, Statistics, Visibility>;

/// The same with point lights and highlights.
template <class Format = Rgb565, class Depth = Depth16<>, bool Statistics = false, class Visibility = ZBuffer>
using LocalLightTraits =
    RendererTraits<Depth, Format, WithShaders<PlainShaders<Format>, LocalFlatShader<Format>>, Statistics, Visibility>;

/// Flat and Gouraud shading, opaque and see-through.
template <class Format = Rgb565, class Depth = Depth16<>, bool Statistics = false, class Visibility = ZBuffer>
using SeeThroughTraits = RendererTraits<
    Depth, Format,
    WithShaders<PlainShaders<Format>, SeeThroughShader<Format, FlatShader<Format>>,
                SeeThroughShader<Format, GouraudShader<Format>>, SeeThroughShader<Format, GouraudColourShader<Format>>>,
    Statistics, Visibility>;

/// Textures at their nearest texel.
template <class Format = Rgb565, class Depth = Depth16<>, bool Statistics = false, class Visibility = ZBuffer>
using TextureTraits = RendererTraits<Depth, Format, TextureShaders<Format>, Statistics, Visibility>;

/// The same, and textures in fog. In a frame with fog it draws nothing but those.
template <class Format = Rgb565, class Depth = Depth16<>, bool Statistics = false, class Visibility = ZBuffer>
using FoggedTextureTraits =
    RendererTraits<Depth, Format, WithShaders<TextureShaders<Format>, FoggedTextureShader<Format, TexelFormat::rgb565>>,
                   Statistics, Visibility>;

/// Everything that is opaque.
template <class Format = Rgb565, class Depth = Depth16<>, bool Statistics = false, class Visibility = ZBuffer>
using GeneralTraits = RendererTraits<Depth, Format, GeneralShaders<Format>, Statistics, Visibility>;

/// All of it, opaque and see-through, and opacities that vary over a polygon.
template <class Format = Rgb565, class Depth = Depth16<>, bool Statistics = false, class Visibility = ZBuffer>
using GeneralSeeThroughTraits = RendererTraits<
    Depth, Format,
    WithShaders<GeneralShaders<Format>, SeeThroughShader<Format, FlatShader<Format>>,
                SeeThroughShader<Format, GouraudShader<Format>>, SeeThroughShader<Format, GouraudColourShader<Format>>,
                SeeThroughShader<Format, ReliefShader<Format>>, SeeThroughShader<Format, VolumeShader<Format>>,
                SeeThroughShader<Format, TranslucentShader<Format>>>,
    Statistics, Visibility>;

/// Draws polygon numbers instead of colours.
template <class Depth = Depth16<>, bool Statistics = false, class Visibility = ZBuffer>
using IdTraits = RendererTraits<Depth, PolygonIds, ShaderList<IdShader>, Statistics, Visibility>;

}  // namespace spanline
