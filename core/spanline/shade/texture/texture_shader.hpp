#pragma once
#include <algorithm>
#include <cstdint>
#include <type_traits>

#include "spanline/cpu/texel_table.hpp"
#include "spanline/cpu/texture_steps.hpp"
#include "spanline/pixel/spread_565.hpp"
#include "spanline/raster/linear_function.hpp"
#include "spanline/raster/polygon_corners.hpp"
#include "spanline/raster/span.hpp"
#include "spanline/shade/fill_run.hpp"
#include "spanline/shade/shading_group.hpp"
#include "spanline/shade/texture/certain_blocks.hpp"
#include "spanline/shade/texture/mip_texels.hpp"
#include "spanline/shade/texture/nearest_texels.hpp"
#include "spanline/shade/texture/texture_blocks.hpp"

namespace spanline {

namespace texel_light {
/// Converts an intensity to a 16-bit value whose top 6 bits are the level of light.
[[nodiscard]] constexpr std::uint32_t value(Intensity intensity) { return intensity * 33 >> 6; }
[[nodiscard]] inline bool plain(const Material& material) {
  return material.texturing.function == TextureFunction::modulate && material.colour == Rgb888{255, 255, 255};
}
}  // namespace texel_light

/// The light on texels: none, constant over a polygon, or interpolated between the vertices. Levels are 32nds; an
/// intensity of 65535/65536 has level 32.
struct NoTexelLight {
  struct Stepper {
    [[nodiscard]] std::uint32_t apply(std::uint32_t rgb565) const { return rgb565; }
    void forward() {}
    void back() {}
    void next_piece() {}
    void next_block() {}
  };
  void next_row() {}
  void skip_rows(std::int32_t) {}
  [[nodiscard]] Stepper at(std::int32_t) const { return {}; }

  static constexpr bool interpolates = false, fogged = false;
  [[nodiscard]] static bool serves(const Material& material) {
    return material.texturing.function == TextureFunction::replace || (!material.lit && texel_light::plain(material));
  }
  template <class Gradients>
  void make(const ShadingGroup&, const PolygonCorners&, const Gradients&) {}
};

struct FlatTexelLight {
  struct Stepper {
    std::uint32_t level;
    [[nodiscard]] std::uint32_t apply(std::uint32_t rgb565) const {
      return spread_565::joined(spread_565::lit(spread_565::from(rgb565), level));
    }
    void forward() {}
    void back() {}
    void next_piece() {}
    void next_block() {}
  };
  std::uint32_t level;
  void next_row() {}
  void skip_rows(std::int32_t) {}
  [[nodiscard]] Stepper at(std::int32_t) const { return {level}; }

  static constexpr bool interpolates = false, fogged = false;
  [[nodiscard]] static bool serves(const Material& material) {
    return texel_light::plain(material) && material.shading == ShadingMode::flat;
  }
  template <class Gradients>
  void make(const ShadingGroup& group, const PolygonCorners& polygon, const Gradients&) {
    level = texel_light::value(group.polygon_intensity(polygon.polygon)) >> 10;
  }
};

struct GouraudTexelLight {
  struct Stepper {
    std::uint32_t value, step;
    [[nodiscard]] std::uint32_t apply(std::uint32_t rgb565) const {
      return spread_565::joined(spread_565::lit(spread_565::from(rgb565), value >> 26));
    }
    void forward() { value += step; }
    void back() { value -= step; }
    void next_piece() {}
    void next_block() {}
  };
  LinearFunction light;
  void next_row() { light.next_row(); }
  void skip_rows(std::int32_t rows) { light.skip_rows(rows); }
  [[nodiscard]] Stepper at(std::int32_t column) const { return {light.at(column), light.dx}; }

  static constexpr bool interpolates = true, fogged = false;
  [[nodiscard]] static bool serves(const Material& material) {
    return texel_light::plain(material) && material.shading == ShadingMode::gouraud;
  }
  template <class Gradients>
  void make(const ShadingGroup& group, const PolygonCorners&, const Gradients& gradients) {
    gradients.fit(
        [&](const ScreenVertex* v) {
          return static_cast<std::int32_t>(texel_light::value(group.vertex_shades[gradients.index(v)]));
        },
        light);
  }
};

/// A texture under white light: `Texels` reads it, `Light` shades it. It is a fast shader for surfaces whose own colour
/// is white, in modes that `GeneralShader` has too.
template <class Format, class Texels, class Light>
struct TextureShader {
  using Pixel = typename Format::Pixel;
  static constexpr bool interpolates = true;
  static constexpr bool fogged = Light::fogged;  ///< it draws only frames with fog, or only those without

  struct Source {
    static constexpr bool constant = false;
    static constexpr bool has_holes = Texels::has_holes;
    TextureSteps coordinates;
    typename Light::Stepper light;
    Texels texels;
    [[nodiscard]] bool present() const { return Texels::present(texels.at(coordinates.u, coordinates.v)); }
    [[nodiscard]] Pixel get() const {
      return Format::from_rgb565(static_cast<std::uint16_t>(light.apply(texels.at(coordinates.u, coordinates.v))));
    }
    void forward() {
      coordinates.forward();
      light.forward();
    }
    void back() {
      coordinates.back();
      light.back();
    }
    void next_piece() {
      coordinates.next_piece();
      light.next_piece();
    }
    // These functions serve loops that hold the blocks themselves: the loop passes each block, and the light follows.
    void next_block() {
      light.next_block();
      if constexpr (Texels::has_levels) texels.next_block();
    }
    void next_piece(const TextureBlock& block) {
      coordinates.next_piece(block);
      light.next_piece();
    }
    void restart(const TextureBlock& block) {
      coordinates.restart(block);
      if constexpr (Texels::has_levels) texels.place(coordinates);
    }
    void restart(const TextureBlock& block, std::uint32_t into) {
      restart(block);
      coordinates.skip(into, block);
    }
  };

  struct Surface;
  class Blocks {
   public:
    Blocks(const Surface& surface, std::int32_t column) : surface_(surface), walk_(surface.plane, column) {}
    [[nodiscard]] std::uint32_t rest() const {
      return Light::fogged ? std::min(walk_.rest(), rest_of(TextureBlocks::piece_columns)) : walk_.rest();
    }
    [[nodiscard]] std::uint32_t rest_of_block() const {
      return Light::fogged ? std::min(walk_.rest_of_block(), rest_of(TextureBlocks::block_columns))
                           : walk_.rest_of_block();
    }
    [[nodiscard]] Source source() const {
      Source source = surface_.source(walk_.column());
      source.coordinates = walk_.coordinates();
      if constexpr (Texels::has_levels) source.texels.place(source.coordinates);
      return source;
    }
    void next() { walk_.next(rest_of_block()); }

   private:
    /// Pixels left in the aligned group of `columns` screen columns, a power of two. Fog needs it because it has blocks
    /// and pieces on affine polygons too.
    [[nodiscard]] std::uint32_t rest_of(std::int32_t columns) const {
      return word(columns - ((walk_.column() + surface_.plane.origin) & (columns - 1)));
    }
    const Surface& surface_;
    TextureBlocks walk_;
  };

  struct Surface {
    /// Whether pixels are unchanged words of a texture's table.
    static constexpr bool plain_texels = std::is_same_v<Light, NoTexelLight> && !Texels::has_holes &&
                                         !Texels::in_bytes && !Texels::has_levels &&
                                         Format::from_rgb565(0x1234) == 0x1234;
    TexturePlane plane;
    Light light;
    Texels texels;
    void next_row() {
      plane.next_row();
      light.next_row();
    }
    void skip_rows(std::int32_t rows) {
      plane.skip_rows(rows);
      light.skip_rows(rows);
    }
    [[nodiscard]] Blocks blocks(std::int32_t column) const { return {*this, column}; }
    [[nodiscard]] CertainBlocks certain(std::int32_t column, std::uint32_t count) const {
      return {plane, column, count};
    }
    /// Fills whole blocks from `column` on without a depth test.
    void fill_blocks(std::int32_t column, const TextureBlock* blocks, std::uint32_t count, Pixel* pixels) const {
      fill_detail::fill_whole_blocks(pixels, count, *this, column, blocks);
    }
    /// The table of texels, for kernels that read it directly.
    [[nodiscard]] TexelTable texel_table() const requires plain_texels {
      return {texels.table, texels.mask_u, texels.mask_v};
    }
    /// A source whose texture coordinates are not set yet.
    [[nodiscard]] Source source(std::int32_t column) const {
      Source source;
      source.light = light.at(column);
      source.texels = texels;
      if constexpr (Texels::has_levels) source.texels.start(plane, column);
      return source;
    }
  };

  [[nodiscard]] static bool serves(const Material& material, bool vertex_colours) {
    const Texturing& texturing = material.texturing;
    return texturing.texture != nullptr && texturing.filter == Texels::filter &&
           (Texels::has_levels || texturing.mip_mapping == MipMapping::none) && Texels::serves(*texturing.texture) &&
           Light::serves(material) && !(vertex_colours && material.texturing.function != TextureFunction::replace);
  }

  template <class Gradients>
  static void make(Surface& surface, const ShadingGroup& group, const PolygonCorners& polygon,
                   const Gradients& gradients) {
    const Texturing& texturing = group.textured->texturing;
    const Texture& texture = *texturing.texture;
    const auto corners = gradients.corners();
    const auto vertex = [&](unsigned i) { return group.textured->vertices[gradients.index(corners[i])]; };
    const std::array<TextureVertex, 3> vertices{vertex(0), vertex(1), vertex(2)};
    const TexturePlaneValues values = texture_plane_values(
        vertices, texturing.mapping,
        {texture.log2_width, texture.log2_height, Texels::fraction_u, Texels::fraction_v(texture.log2_width)});
    fit_texture_plane(gradients, values, surface.plane);
    if constexpr (Texels::has_levels)
      surface.texels = Texels::of(texturing, texel_density(corners, vertices, texture, values));
    else
      surface.texels = Texels::of(TexelLevel::of(texture, 0));
    surface.light.make(group, polygon, gradients);
  }
};

/// Fast shaders of nearest texels in one texel format.
template <class Format, TexelFormat Texels, class Light>
using NearestTextureShader = TextureShader<Format, NearestTexels<Texels>, Light>;
/// Fast shaders of RGB565 textures, with or without mip maps, nearest or bilinear.
template <class Format, TextureFilter Filter, class Light>
using MipTextureShader = TextureShader<Format, MipTexels<Filter>, Light>;

}  // namespace spanline
