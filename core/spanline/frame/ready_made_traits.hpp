#pragma once
#include "spanline/frame/traits.hpp"
#include "spanline/model/material.hpp"
#include "spanline/pixel/pixel_format.hpp"
#include "spanline/raster/depth_format.hpp"
#include "spanline/shade/general/general_shader.hpp"
#include "spanline/shade/item_shaders.hpp"
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
#include "spanline/visibility/span/spanning_scan_line.hpp"
#include "spanline/visibility/zbuffer/deferred.hpp"
#include "spanline/visibility/zbuffer/depth_buffer.hpp"

namespace spanline {

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
