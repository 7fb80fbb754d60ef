#pragma once
#include <cstdint>

#include "spanline/raster/linear_function.hpp"
#include "spanline/raster/span.hpp"
#include "spanline/shade/shading_group.hpp"
#include "spanline/shade/spread_565.hpp"
#include "spanline/shade/texels.hpp"
#include "spanline/shade/texture_plane.hpp"

namespace spanline {

/// Light of texels: none, a level a polygon, or a level interpolated between the vertices. Levels are 32nds;
/// 65535/65536 of full light is 32.
struct NoTexelLight {
  struct Stepper {
    [[nodiscard]] std::uint32_t apply(std::uint32_t rgb565) const { return rgb565; }
    void forward() {}
    void back() {}
  };
  void next_row() {}
  void skip_rows(std::int32_t) {}
  [[nodiscard]] Stepper at(std::int32_t) const { return {}; }

  static constexpr bool interpolates = false;
  [[nodiscard]] static bool serves(const Material& material) {
    return material.texturing.function == TextureFunction::replace;
  }
  template <class Gradients>
  void make(const ShadingGroup&, const PolygonCorners&, const Gradients&) {}
};

namespace texel_light {
/// An intensity as the 16-bit value whose top 6 bits are the level.
[[nodiscard]] constexpr std::uint32_t value(Intensity intensity) { return intensity * 33 >> 6; }
[[nodiscard]] inline bool plain(const Material& material) {
  return material.texturing.function == TextureFunction::modulate && material.colour == Rgb888{255, 255, 255};
}
}  // namespace texel_light

struct FlatTexelLight {
  struct Stepper {
    std::uint32_t level;
    [[nodiscard]] std::uint32_t apply(std::uint32_t rgb565) const {
      return spread_565::joined(spread_565::lit(spread_565::from(rgb565), level));
    }
    void forward() {}
    void back() {}
  };
  std::uint32_t level;
  void next_row() {}
  void skip_rows(std::int32_t) {}
  [[nodiscard]] Stepper at(std::int32_t) const { return {level}; }

  static constexpr bool interpolates = false;
  [[nodiscard]] static bool serves(const Material& material) {
    return texel_light::plain(material) && material.shading == ShadingMode::flat;
  }
  template <class Gradients>
  void make(const ShadingGroup& group, const PolygonCorners& polygon, const Gradients&) {
    const Mesh& mesh = *group.mesh;
    const Intensity intensity =
        mesh.polygon_normals.empty() ? Intensity{65535} : group.intensity(mesh.polygon_normals[polygon.polygon]);
    level = texel_light::value(intensity) >> 10;
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
  };
  LinearFunction light;
  void next_row() { light.next_row(); }
  void skip_rows(std::int32_t rows) { light.skip_rows(rows); }
  [[nodiscard]] Stepper at(std::int32_t column) const { return {light.at(column), light.dx}; }

  static constexpr bool interpolates = true;
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

/// A texture under white light: `Texels` reads it, `Light` shades it. For surfaces of one colour, which is white, in
/// modes that `GeneralTextureShader` has as well; this is their fast form.
template <class Format, class Texels, class Light>
struct TextureShader {
  using Pixel = typename Format::Pixel;
  static constexpr bool interpolates = true;

  struct Source {
    static constexpr bool constant = false;
    static constexpr bool has_holes = Texels::has_holes;
    TextureBlocks::Coordinates coordinates;
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
    void bend() { coordinates.bend(); }
    /// From one block to the next; light goes on. Member by member: a copy of the whole goes through memory.
    void restart(const TextureBlocks::Coordinates& c) {
      coordinates.u = c.u;
      coordinates.v = c.v;
      coordinates.du = c.du;
      coordinates.dv = c.dv;
      coordinates.ddu = c.ddu;
      coordinates.ddv = c.ddv;
    }
  };

  struct Surface;
  class Blocks {
   public:
    Blocks(const Surface& surface, std::int32_t column) : surface_(surface), walk_(surface.plane, column) {}
    [[nodiscard]] std::uint32_t rest() const { return walk_.rest(); }
    [[nodiscard]] std::uint32_t rest_of_block() const { return walk_.rest_of_block(); }
    [[nodiscard]] bool at_block() const { return walk_.at_block(); }
    [[nodiscard]] Source source() const {
      Source source;
      source.restart(walk_.coordinates());
      source.light = surface_.light.at(walk_.column());
      source.texels = surface_.texels;
      return source;
    }
    void next() { walk_.next(); }
    [[nodiscard]] TextureBlocks::CertainBlocks certain(std::uint32_t count) const { return walk_.certain(count); }
    void leave(const TextureBlocks::CertainBlocks& blocks) { walk_.leave(blocks); }

   private:
    const Surface& surface_;
    TextureBlocks walk_;
  };

  struct Surface {
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
  };

  [[nodiscard]] static bool serves(const Material& material, bool vertex_colours) {
    const Texturing& texturing = material.texturing;
    return texturing.texture != nullptr && texturing.filter == TextureFilter::nearest &&
           texturing.mip_mapping == MipMapping::none && Texels::serves(*texturing.texture) && Light::serves(material) &&
           !(vertex_colours && material.texturing.function != TextureFunction::replace);
  }

  template <class Gradients>
  static void make(Surface& surface, const ShadingGroup& group, const PolygonCorners& polygon,
                   const Gradients& gradients) {
    const Texturing& texturing = group.textured->texturing;
    const Texture& texture = *texturing.texture;
    const auto corners = gradients.corners();
    const auto vertex = [&](unsigned i) { return group.textured->vertices[gradients.index(corners[i])]; };
    fit_texture_plane(gradients,
                      texture_plane_values({vertex(0), vertex(1), vertex(2)}, texturing.mapping,
                                           {texture.log2_width, texture.log2_height, Texels::fraction_u,
                                            Texels::fraction_v(texture.log2_width), Texels::offset}),
                      surface.plane);
    surface.texels = Texels::of(TexelLevel::of(texture, 0));
    surface.light.make(group, polygon, gradients);
  }
};

/// The fast shaders for one way to read a texture.
template <class Format, TexelFormat Texels, class Light>
using RepeatedTextureShader = TextureShader<Format, RepeatedTexels<Texels>, Light>;

}  // namespace spanline
