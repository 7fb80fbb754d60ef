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

/// How a texture is read between its texels.
enum class TextureFilter : std::uint8_t {
  nearest,   ///< the texel that is nearest
  bilinear,  ///< a mean of the four around, weighed by nearness
};

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

/// Where texture coordinates come from.
enum class TextureCoordinates : std::uint8_t {
  mesh,        ///< the mesh's own
  sphere_map,  ///< by the mesh's vertex normals: the texture is a picture of the surroundings, as a mirror sphere shows
               ///< them from far away (environment mapping, lecture 004; OpenGL's GL_SPHERE_MAP)
};

/// How a texture is laid on a surface.
struct Texturing {
  const Texture* texture = nullptr;                           ///< null: none; must stay until the frame is drawn
  TextureFunction function = TextureFunction::modulate;       ///< modulate by default
  TextureFilter filter = TextureFilter::nearest;              ///< nearest by default
  TextureMapping mapping = TextureMapping::perspective;       ///< perspective by default
  MipMapping mip_mapping = MipMapping::none;                  ///< none by default
  TexelAlpha alpha = TexelAlpha::cut_out;                     ///< cut_out by default; of formats with alpha alone
  Rgb888 blend_colour{};                                      ///< of TextureFunction::blend; white by default
  TextureCoordinates coordinates = TextureCoordinates::mesh;  ///< the mesh's own by default

  /// Whether a mesh has what its coordinates are made of.
  [[nodiscard]] bool lies_on(const Mesh& mesh) const {
    return texture != nullptr &&
           !(coordinates == TextureCoordinates::mesh ? mesh.texture_coordinates.empty() : mesh.vertex_normals.empty());
  }
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
  Rgb888 colour{};                          ///< white by default
  ShadingMode shading = ShadingMode::flat;  ///< flat by default
  Texturing texturing{};                    ///< of meshes that it lies on; others are drawn without
  TextureMatrix texture_matrix{};           ///< changes the mesh's texture coordinates; leaves them by default
  std::uint8_t opacity = 255;  ///< α in 255ths, 0 … 255, 255 by default; blending rounds it to 32nds, patterns to 64ths
  Transparency transparency = Transparency::blend;  ///< blend by default
  /// Where it is false, colours and textures are shown as they are: the frame's lights, highlights and relief do
  /// nothing to the surface, and its normals are not looked at. True by default.
  bool lit = true;
  /// What the surface adds to its lit colour where it mirrors a light: specular · Σ intensity · (R·V)^shininess
  /// (lecture 003); black, the default: nothing. For renderers with `LocalFlatShader` (shade/local_flat.hpp).
  Rgb888 specular{0, 0, 0};
  std::uint8_t shininess = 32;  ///< the exponent of highlights, [1, 128]; 32 by default
  Volume volume{};              ///< for renderers with `VolumeShader`; none by default
  Relief relief{};  ///< of meshes with texture coordinates; for renderers with `ReliefShader`; none by default

  /// Whether it has highlights.
  [[nodiscard]] constexpr bool shines() const { return lit && !(specular == Rgb888{0, 0, 0}); }
};

}  // namespace spanline
