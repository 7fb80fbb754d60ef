#pragma once
/// @file
/// Traits that most programs want, by what they draw.
///
/// ```cpp
/// #include <spanline/frame/renderer.hpp>
///
/// using Plain = Renderer<FlatTraits<Rgb565Swapped>>;                   // high byte first, as SPI displays take it
/// using Smooth = Renderer<GouraudTraits<Rgb565, Depth24<>>>;           // 24 bits of depth
/// using Frugal = Renderer<GouraudTraits<Rgb565, Depth24<>, Spanning>>;  // no depth buffer
/// using Everything = Renderer<GeneralSeeThroughTraits<>>;
/// ```
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
#include "spanline/visibility/sort/depth_sort.hpp"
#include "spanline/visibility/sort/painter.hpp"
#include "spanline/visibility/span/spanning_scan_line.hpp"
#include "spanline/visibility/zbuffer/deferred.hpp"
#include "spanline/visibility/zbuffer/depth_buffer.hpp"

namespace spanline {

// Lists of shaders, each longer than the one before it.

/// Flat and Gouraud shading, with vertex colours.
template <class Format>
using PlainShaders = ShaderList<FlatShader<Format>, GouraudShader<Format>, GouraudColourShader<Format>>;

/// The same, and nearest texels of repeating RGB565 textures: unlit, flat or smooth under white light.
template <class Format>
using TextureShaders =
    WithShaders<PlainShaders<Format>, NearestTextureShader<Format, TexelFormat::rgb565, NoTexelLight>,
                NearestTextureShader<Format, TexelFormat::rgb565, FlatTexelLight>,
                NearestTextureShader<Format, TexelFormat::rgb565, GouraudTexelLight>>;

/// The same, and such textures with mip maps and bilinear filtering. The general shader at the end serves what the
/// others do not: other texel formats, clamping, texture functions, coloured surfaces under a texture, fog and dither.
/// There are shaders for point lights, highlights, relief and solids given by tables.
template <class Format>
using GeneralShaders =
    WithShaders<TextureShaders<Format>, MipTextureShader<Format, TextureFilter::bilinear, NoTexelLight>,
                MipTextureShader<Format, TextureFilter::bilinear, FlatTexelLight>,
                MipTextureShader<Format, TextureFilter::bilinear, GouraudTexelLight>,
                MipTextureShader<Format, TextureFilter::nearest, NoTexelLight>,
                MipTextureShader<Format, TextureFilter::nearest, FlatTexelLight>,
                MipTextureShader<Format, TextureFilter::nearest, GouraudTexelLight>, GeneralShader<Format>,
                LocalFlatShader<Format>, ReliefShader<Format>, VolumeShader<Format>>;

// Traits by what they shade. After the pixel format there may be options in any order, each at most once: a depth
// format (Depth16<> by default), a visibility algorithm (ZBuffer by default), and Counted (frame/traits.hpp).
//
//     FlatTraits<>                               // RGB565, 16-bit depth, a z-buffer
//     FlatTraits<Rgb565, Depth24<>, Spanning>    // 24-bit depth by spanning scan line

/// Flat shading: the smallest renderer.
template <class Format = Rgb565, class... Options>
using FlatTraits = RendererTraits<Format, ShaderList<FlatShader<Format>>, Options...>;

/// Flat and Gouraud shading, with vertex colours.
template <class Format = Rgb565, class... Options>
using GouraudTraits = RendererTraits<Format, PlainShaders<Format>, Options...>;

/// The same with point lights and highlights.
template <class Format = Rgb565, class... Options>
using LocalLightTraits = RendererTraits<Format, WithShaders<PlainShaders<Format>, LocalFlatShader<Format>>, Options...>;

/// Flat and Gouraud shading, opaque and see-through.
template <class Format = Rgb565, class... Options>
using SeeThroughTraits = RendererTraits<
    Format,
    WithShaders<PlainShaders<Format>, SeeThroughShader<Format, FlatShader<Format>>,
                SeeThroughShader<Format, GouraudShader<Format>>, SeeThroughShader<Format, GouraudColourShader<Format>>>,
    Options...>;

/// Textures at their nearest texel.
template <class Format = Rgb565, class... Options>
using TextureTraits = RendererTraits<Format, TextureShaders<Format>, Options...>;

/// The same, and textures in fog. A frame with fog shows only those.
template <class Format = Rgb565, class... Options>
using FoggedTextureTraits =
    RendererTraits<Format, WithShaders<TextureShaders<Format>, FoggedTextureShader<Format, TexelFormat::rgb565>>,
                   Options...>;

/// Everything that can be drawn opaque.
template <class Format = Rgb565, class... Options>
using GeneralTraits = RendererTraits<Format, GeneralShaders<Format>, Options...>;

/// Everything, opaque and see-through, including opacities that vary over a polygon.
template <class Format = Rgb565, class... Options>
using GeneralSeeThroughTraits = RendererTraits<
    Format,
    WithShaders<GeneralShaders<Format>, SeeThroughShader<Format, FlatShader<Format>>,
                SeeThroughShader<Format, GouraudShader<Format>>, SeeThroughShader<Format, GouraudColourShader<Format>>,
                SeeThroughShader<Format, ReliefShader<Format>>, SeeThroughShader<Format, VolumeShader<Format>>,
                SeeThroughShader<Format, TranslucentShader<Format>>>,
    Options...>;

/// Draws polygon numbers instead of colours. It takes only options, because there is one format of numbers.
template <class... Options>
using IdTraits = RendererTraits<PolygonIds, ShaderList<IdShader>, Options...>;

}  // namespace spanline
