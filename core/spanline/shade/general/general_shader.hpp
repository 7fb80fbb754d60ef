#pragma once
#include <algorithm>
#include <cstdint>

#include "spanline/raster/polygon_corners.hpp"
#include "spanline/raster/span.hpp"
#include "spanline/raster/vertex_shade.hpp"
#include "spanline/shade/general/general_surface.hpp"
#include "spanline/shade/light/local_light.hpp"

namespace spanline {

/// One shader for everything that a material and a frame can ask for: any texture format, wrap mode, filter, texture
/// function and mip mapping, flat or smooth light, fog and dither. It decides all of this at each pixel, which makes it
/// slow but small. Shaders that stand before it in the list take the cases that they draw faster.
template <class Format>
struct GeneralShader {
  using Pixel = typename Format::Pixel;
  static constexpr bool interpolates = true;
  struct Surface;

  struct Source {
    static constexpr bool constant = false, has_holes = true;
    TextureBlocks::Coordinates coordinates;
    const GeneralSurface* surface;
    const TexelSource* texels;
    GeneralPixel at;
    [[nodiscard]] bool present() const {
      return general_pixel_present(*surface, *texels, coordinates.u, coordinates.v);
    }
    [[nodiscard]] Pixel get() const { return Format::from_rgb565(whole().rgb565); }
    /// The colour with the opacity of its texels.
    [[nodiscard]] GeneralColour whole() const {
      GeneralPixel pixel = at;
      pixel.u = coordinates.u;
      pixel.v = coordinates.v;
      return general_pixel(*surface, *texels, pixel);
    }
    void forward() {
      coordinates.forward();
      at.red += surface->red.dx;
      at.green += surface->green.dx;
      at.blue += surface->blue.dx;
      at.nearness += surface->nearness.dx;
      ++at.column;
    }
    void back() {
      coordinates.back();
      at.red -= surface->red.dx;
      at.green -= surface->green.dx;
      at.blue -= surface->blue.dx;
      at.nearness -= surface->nearness.dx;
      --at.column;
    }
    void next_piece() { coordinates.next_piece(); }
  };

  class Blocks {
   public:
    Blocks(const GeneralSurface& surface, std::int32_t column)
        : surface_(surface), walk_(surface.plane, column), texels_(surface.texels_at(column)) {}
    /// Pieces end at the screen's groups of 16 columns, because the mip level may change there.
    [[nodiscard]] std::uint32_t rest() const { return std::min(walk_.rest(), rest_of_group()); }
    [[nodiscard]] std::uint32_t rest_of_block() const { return std::min(walk_.rest_of_block(), rest_of_group()); }
    [[nodiscard]] Source source() const {
      const std::int32_t column = walk_.column();
      return {walk_.coordinates(),
              &surface_,
              &texels_,
              {0, 0, surface_.red.at(column), surface_.green.at(column), surface_.blue.at(column),
               surface_.nearness.at(column), column + surface_.plane.origin}};
    }
    void next() {
      walk_.next(rest_of_block());
      texels_ = surface_.texels_at(walk_.column());
    }

   private:
    [[nodiscard]] std::uint32_t rest_of_group() const {
      return word(TextureBlocks::block_columns -
                  ((walk_.column() + surface_.plane.origin) & (TextureBlocks::block_columns - 1)));
    }
    const GeneralSurface& surface_;
    TextureBlocks walk_;
    TexelSource texels_;
  };

  struct Surface : GeneralSurface {
    [[nodiscard]] Blocks blocks(std::int32_t column) const { return {*this, column}; }
  };

  [[nodiscard]] static bool serves(const Material&, bool) { return true; }

  template <class Gradients>
  static void make(GeneralSurface& surface, const ShadingGroup& group, const PolygonCorners& polygon,
                   const Gradients& gradients) {
    surface.group = group.textured;
    surface.textured = group.textured->vertices != nullptr;
    surface.row = static_cast<std::uint16_t>(gradients.row());
    surface.plane = {};
    surface.plane.origin = static_cast<std::int16_t>(gradients.origin());
    surface.plane.way = TexturePlane::Way::affine;
    const auto corners = gradients.corners();
    if (surface.textured) {
      const Texturing& texturing = group.textured->texturing;
      const Texture& texture = *texturing.texture;
      const auto vertex = [&](unsigned i) { return group.textured->vertices[gradients.index(corners[i])]; };
      const std::array<TextureVertex, 3> vertices{vertex(0), vertex(1), vertex(2)};
      const FarAxes far = FarAxes::of(texture, vertices);
      const TexelScale scale{texture.log2_width, texture.log2_height, FarAxes::fraction(far.u),
                             FarAxes::fraction(far.v)};
      const TexturePlaneValues values = far.any() ? far_texture_plane_values(vertices, texturing.mapping, scale)
                                                  : texture_plane_values(vertices, texturing.mapping, scale);
      fit_texture_plane(gradients, values, surface.plane);
      if (far.any()) {
        surface.plane.way = TexturePlane::Way::exact_far;
        surface.plane.far = far;
      }
      surface.density = texel_density(corners, vertices, texture, values);
    }
    surface.nearness = {};
    const FrameEffects& effects = *group.textured->effects;
    if (effects.fogged) fit_nearness(effects.fog, gradients, surface.nearness);
    light(surface, group, polygon, gradients);
  }

 private:
  static constexpr std::int32_t least = vertex_shade::lowest_intensity;
  /// A channel under an intensity, as 16 bits that stay clear of both ends of the range for interpolation.
  static std::int32_t lit(std::uint32_t channel, std::uint32_t intensity) {
    return std::clamp<std::int32_t>(static_cast<std::int32_t>(channel * 257 * intensity >> 16), least,
                                    vertex_shade::highest_intensity);
  }

  template <class Gradients>
  static void light(GeneralSurface& surface, const ShadingGroup& group, const PolygonCorners& polygon,
                    const Gradients& gradients) {
    const Mesh& mesh = *group.mesh;
    const bool smooth = group.textured->smooth;
    const Rgb888 colour =
        mesh.polygon_colours.empty() || smooth ? group.textured->colour : mesh.polygon_colours[polygon.polygon];
    if (!smooth) {
      const LocalLighting* local = group.textured->local;
      SurfaceLight light{0, 0};
      Rgb888 specular{0, 0, 0};
      if (local != nullptr) {
        light = local->on_polygon(polygon.polygon);
        specular = local->specular();
      } else {
        light.diffuse = group.polygon_intensity(polygon.polygon);
      }
      const auto all_over = [&](std::uint32_t channel, std::uint32_t shine) {
        const std::int32_t sum =
            lit(channel, light.diffuse) + static_cast<std::int32_t>(shine * 257 * light.highlight >> 16);
        return LinearFunction{word(std::min<std::int32_t>(sum, vertex_shade::highest_intensity)) << 16, 0, 0};
      };
      surface.red = all_over(colour.red, specular.red);
      surface.green = all_over(colour.green, specular.green);
      surface.blue = all_over(colour.blue, specular.blue);
      return;
    }
    if (group.textured->shades == vertex_shade::Kind::colour_and_opacity) {
      const auto fit = [&](unsigned place, LinearFunction& function) {
        gradients.fit(
            [&](const ScreenVertex* v) {
              return vertex_shade::byte_16(group.vertex_shades[gradients.index(v)], place);
            },
            function);
      };
      fit(0, surface.red);
      fit(1, surface.green);
      fit(2, surface.blue);
      return;
    }
    const bool coloured = group.textured->shades == vertex_shade::Kind::colour;
    const auto fit = [&](auto of_colour, std::uint32_t channel, LinearFunction& function) {
      gradients.fit(
          [&](const ScreenVertex* v) {
            const std::uint32_t shade = group.vertex_shades[gradients.index(v)];
            return coloured ? of_colour(shade) : lit(channel, shade);
          },
          function);
    };
    fit(vertex_shade::red_16, colour.red, surface.red);
    fit(vertex_shade::green_16, colour.green, surface.green);
    fit(vertex_shade::blue_16, colour.blue, surface.blue);
  }
};

}  // namespace spanline
