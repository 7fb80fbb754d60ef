#pragma once
#include <cstdint>

#include "spanline/raster/polygon_corners.hpp"
#include "spanline/raster/span.hpp"
#include "spanline/shade/light/local_light.hpp"
#include "spanline/shade/pixelwise/pixelwise_surface.hpp"
#include "spanline/shade/shading_group.hpp"
#include "spanline/shade/texture/texture_blocks.hpp"

namespace spanline {

/// A shader that computes each pixel from texture coordinates and light. How it does so is up to `Kind`, a
/// PixelwiseSurface that holds the state of a polygon and has these members:
///
///     LitTexel texel(u, v, light) const
///     static bool serves(const Material&, bool vertex_colours)
///     template <class Gradients> void make_kind(const ShadingGroup&, const PolygonCorners&, const Gradients&)
///     static SurfaceLight flat_light(const ShadingGroup&, Link polygon)  // 16 bits each, as vertex shades are
///
/// This shader supplies the light, either interpolated from the vertices' shades or constant over a polygon, and adds
/// highlights, fog and dither.
template <class Format, class Kind>
struct PixelwiseShader {
  using Pixel = typename Format::Pixel;
  static constexpr bool interpolates = true;

  struct Source {
    static constexpr bool constant = false;
    TextureBlocks::Coordinates coordinates;
    std::uint32_t light, step;
    std::int32_t column;
    const Kind* kind;
    [[nodiscard]] Pixel get() const {
      return Format::from_rgb565(kind->pixel(kind->texel(coordinates.u, coordinates.v, light), column));
    }
    void forward() {
      coordinates.forward();
      light += step;
      ++column;
    }
    void back() {
      coordinates.back();
      light -= step;
      --column;
    }
    void next_piece() { coordinates.next_piece(); }
  };

  class Blocks {
   public:
    Blocks(const Kind& kind, std::int32_t column) : kind_(kind), walk_(kind.plane, column) {}
    [[nodiscard]] std::uint32_t rest() const { return walk_.rest(); }
    [[nodiscard]] std::uint32_t rest_of_block() const { return walk_.rest_of_block(); }
    [[nodiscard]] Source source() const {
      return {walk_.coordinates(), kind_.light.at(walk_.column()), kind_.light.dx, walk_.column(), &kind_};
    }
    void next() { walk_.next(); }

   private:
    const Kind& kind_;
    TextureBlocks walk_;
  };

  struct Surface : Kind {
    void next_row() { this->skip_rows(1); }
    [[nodiscard]] Blocks blocks(std::int32_t column) const { return {*this, column}; }
  };

  [[nodiscard]] static bool serves(const Material& material, bool vertex_colours) {
    return Kind::serves(material, vertex_colours);
  }
  template <class Gradients>
  static void make(Surface& surface, const ShadingGroup& group, const PolygonCorners& polygon,
                   const Gradients& gradients) {
    surface.group = group.textured;
    const FrameEffects& effects = *surface.group->effects;
    surface.shines = surface.group->local != nullptr && surface.group->local->shines();
    surface.plain = !surface.shines && !effects.any();
    surface.row = static_cast<std::uint16_t>(gradients.row());
    surface.highlight = surface.nearness = {};
    surface.make_kind(group, polygon, gradients);
    if (effects.fogged) fit_nearness(effects.fog, gradients, surface.nearness);
    if (group.vertex_shades == nullptr) {
      const SurfaceLight light = Kind::flat_light(group, polygon.polygon);
      surface.light = {light.diffuse << 16, 0, 0};
      surface.highlight = {light.highlight << 16, 0, 0};
      return;
    }
    const auto fit = [&](auto value, LinearFunction& function) {
      gradients.fit([&](const ScreenVertex* v) { return value(group.vertex_shades[gradients.index(v)]); }, function);
    };
    fit(vertex_shade::intensity_16, surface.light);
    if (surface.shines) fit(vertex_shade::highlight_16, surface.highlight);
  }
};

}  // namespace spanline
