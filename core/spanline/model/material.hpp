#pragma once
/// @file
/// What surfaces look like.
///
/// ```cpp
/// constexpr Material plain{.colour = {240, 160, 60}};
/// constexpr Material glass{.colour = {90, 160, 200}, .shading = ShadingMode::gouraud, .opacity = 100};
/// static constexpr std::uint16_t words[] = {0xffff, 0x0000, 0x0000, 0xffff};
/// static constexpr Texture checks{.log2_width = 1, .log2_height = 1, .words = words};
/// constexpr Material tiled{.texturing = {.texture = &checks, .filter = TextureFilter::bilinear}};
/// ```
#include <cstdint>

#include "spanline/model/colour.hpp"
#include "spanline/model/mesh.hpp"
#include "spanline/model/relief.hpp"
#include "spanline/model/texture.hpp"
#include "spanline/model/volume.hpp"

namespace spanline {

/// How a surface is lit. The renderer's list of shaders says which modes it supports (frame/renderer.hpp); a material
/// with another mode is refused by a Status.
enum class ShadingMode : std::uint8_t {
  flat,     ///< one intensity for each polygon, from its normal
  gouraud,  ///< intensity interpolated between the vertices; with vertex colours, the colour too
};

/// How a texel Ct and the lit surface colour Cf combine into the pixel (lecture 004, texture functions; OpenGL's
/// glTexEnv).
enum class TextureFunction : std::uint8_t {
  modulate,  ///< Ct·Cf
  replace,   ///< Ct, without light
  decal,     ///< a mix of Ct and Cf by the texel's alpha
  blend,     ///< Cf·(1 − Ct) + blend colour·Ct, channel by channel
};

/// How a texture is sampled between the centres of its texels.
enum class TextureFilter : std::uint8_t {
  nearest,   ///< the nearest texel
  bilinear,  ///< the mean of the four nearest texels, weighted by nearness
};

/// What the alpha of texels does, except with TextureFunction::decal, which mixes colours by it.
enum class TexelAlpha : std::uint8_t {
  cut_out,  ///< each texel is either drawn or left out
  blend,    ///< it multiplies the surface's opacity; needs a see-through `TranslucentShader`
};

/// How texture coordinates are interpolated over a polygon on screen.
enum class TextureMapping : std::uint8_t {
  perspective,  ///< in correct perspective; polygons for which it makes no visible difference are drawn affine
  affine,       ///< linearly on screen: cheaper, and distorted where the depth of a polygon varies
};

/// Whether a texture's mip levels are used.
enum class MipMapping : std::uint8_t {
  none,     ///< level 0 only
  polygon,  ///< one level for each polygon
  span,     ///< one level for each 16 columns of a row
};

/// Where texture coordinates come from.
enum class TextureCoordinates : std::uint8_t {
  mesh,        ///< the mesh's own
  sphere_map,  ///< by the mesh's vertex normals: the texture is a picture of the surroundings, as a mirror sphere shows
               ///< them from far away (environment mapping, lecture 004; OpenGL's GL_SPHERE_MAP)
};

/// How a texture is applied to a surface.
struct Texturing {
  const Texture* texture = nullptr;                           ///< null: none; must stay until the frame is drawn
  TextureFunction function = TextureFunction::modulate;       ///< modulate by default
  TextureFilter filter = TextureFilter::nearest;              ///< nearest by default
  TextureMapping mapping = TextureMapping::perspective;       ///< perspective by default
  MipMapping mip_mapping = MipMapping::none;                  ///< none by default
  TexelAlpha alpha = TexelAlpha::cut_out;                     ///< cut_out by default; only for formats with alpha
  Rgb888 blend_colour{};                                      ///< of TextureFunction::blend; white by default
  TextureCoordinates coordinates = TextureCoordinates::mesh;  ///< the mesh's own by default

  /// Whether a mesh has the data from which its texture coordinates are made.
  [[nodiscard]] bool lies_on(const Mesh& mesh) const {
    return texture != nullptr &&
           !(coordinates == TextureCoordinates::mesh ? mesh.texture_coordinates.empty() : mesh.vertex_normals.empty());
  }
};

/// Whether the texture's alpha says which parts of the surface are drawn. With a decal it mixes colours instead.
[[nodiscard]] constexpr bool has_alpha(const Texturing& texturing) {
  return texturing.texture->has_alpha() && texturing.function != TextureFunction::decal;
}

/// How a surface that is not opaque shows what lies behind it.
enum class Transparency : std::uint8_t {
  blend,        ///< layers are sorted by depth and each is blended over what lies behind it: C' = αC + (1 − α)B
  add,          ///< α times the colour is added to what lies behind, for glows; such surfaces are never opaque
  screen_door,  ///< opaque at a share α of the pixels, by an 8 × 8 pattern (shade/layer/stipple.hpp); depth-tested,
                ///< unsorted
  stochastic,   ///< the same by random patterns, for pictures that average several samples a pixel
};

/// What a surface looks like. If the mesh has colours, they replace `colour`.
struct Material {
  Rgb888 colour{};                          ///< white by default
  ShadingMode shading = ShadingMode::flat;  ///< flat by default
  Texturing texturing{};                    ///< ignored for meshes without the data for its coordinates
  TextureMatrix texture_matrix{};           ///< transforms the mesh's texture coordinates; the identity by default
  std::uint8_t opacity = 255;  ///< α in 255ths, 255 by default; blending rounds it to 32nds, patterns to 64ths
  Transparency transparency = Transparency::blend;  ///< blend by default
  /// If false, colours and textures are shown unchanged: the frame's lights, highlights and relief do not affect the
  /// surface, and its normals are not read. True by default.
  bool lit = true;
  /// The colour of highlights: specular · Σ intensity · (R·V)^shininess is added to the lit colour (lecture 003).
  /// Black, the default, means none. For renderers with `LocalFlatShader` (shade/light/local_flat.hpp).
  Rgb888 specular{0, 0, 0};
  std::uint8_t shininess = 32;  ///< the exponent of highlights, [1, 128]; 32 by default
  Volume volume{};              ///< for renderers with `VolumeShader`; none by default
  Relief relief{};  ///< for meshes with texture coordinates and renderers with `ReliefShader`; none by default

  /// Whether it has highlights.
  [[nodiscard]] constexpr bool shines() const { return lit && !(specular == Rgb888{0, 0, 0}); }
};

}  // namespace spanline
