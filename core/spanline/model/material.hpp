#pragma once
#include <cstdint>

#include "spanline/model/colour.hpp"
#include "spanline/model/texture.hpp"

namespace spanline {

/// How a surface is lit. The renderer's type lists which of these it links (frame/renderer.hpp); asking for another is
/// a Status.
enum class ShadingMode : std::uint8_t {
  flat,     ///< one intensity a polygon, from its normal
  gouraud,  ///< intensity interpolated between the vertices; with vertex colours, the colour too
};

/// How a texel Ct and the lit surface colour Cf make the pixel (lecture 004, texture functions; OpenGL's glTexEnv).
enum class TextureFunction : std::uint8_t {
  modulate,  ///< Ct·Cf
  replace,   ///< Ct: no light
  decal,     ///< Ct where the texel is there, Cf where it is not
  blend,     ///< Cf·(1 − Ct) + blend colour·Ct, channel by channel
};

enum class TextureFilter : std::uint8_t { nearest, bilinear };

/// What the alpha of texels does to surfaces that are modulated, replaced or blended; decals mix by it.
enum class TexelAlpha : std::uint8_t {
  cut_out,  ///< texels are there, or they are not
  blend,    ///< it multiplies the surface's opacity: for renderers with a `TranslucentShader` that is seen through
};

/// How texture coordinates run over a polygon on screen.
enum class TextureMapping : std::uint8_t {
  perspective,  ///< as they should; polygons so small or so level that it makes no difference are drawn affine
  affine,       ///< linear over the screen: cheaper, and wrong where the depth of a polygon varies
};

/// Whether a texture's mip levels are used.
enum class MipMapping : std::uint8_t {
  none,     ///< level 0
  polygon,  ///< one level a polygon
  span,     ///< one level for each 16 columns of a row
};

/// How a texture is laid on a surface.
struct Texturing {
  const Texture* texture = nullptr;  ///< null: none; must stay until the frame is drawn
  TextureFunction function = TextureFunction::modulate;
  TextureFilter filter = TextureFilter::nearest;
  TextureMapping mapping = TextureMapping::perspective;
  MipMapping mip_mapping = MipMapping::none;
  TexelAlpha alpha = TexelAlpha::cut_out;
  Rgb888 blend_colour{};  ///< of TextureFunction::blend
};

/// Whether the texture has an alpha that tells what of the surface is there; a decal is mixed by it instead.
[[nodiscard]] constexpr bool has_alpha(const Texturing& texturing) {
  return texturing.texture->has_alpha() && texturing.function != TextureFunction::decal;
}

/// How a surface that is not opaque shows what lies behind it.
enum class Transparency : std::uint8_t {
  blend,        ///< layers in their order of depth, each over what lies behind it: C' = αC + (1 − α)B
  add,          ///< α of the colour added to what lies behind, as light: glows. Never opaque
  screen_door,  ///< opaque at a share α of the pixels, by an 8 × 8 pattern (shade/stipple.hpp); depth-tested, no order
  stochastic,   ///< the same by random patterns, for pictures that average several samples a pixel
};

/// What a surface looks like. Colours of the mesh, where it has them, replace `colour`.
struct Material {
  Rgb888 colour{};
  ShadingMode shading = ShadingMode::flat;
  Texturing texturing{};  ///< of meshes with texture coordinates; others are drawn without
  TextureMatrix texture_matrix{};
  std::uint8_t opacity = 255;  ///< α in 255ths; blending rounds it to 32nds and patterns to 64ths
  Transparency transparency = Transparency::blend;
};

}  // namespace spanline
