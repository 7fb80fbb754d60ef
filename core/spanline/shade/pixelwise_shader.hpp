#pragma once
#include <cstdint>

#include "spanline/raster/span.hpp"
#include "spanline/shade/shading_group.hpp"
#include "spanline/shade/texture_blocks.hpp"

namespace spanline {

/// A shader whose pixels are worked out one by one from texture coordinates and one linear function, by what a
/// polygon's `Kind` makes of them:
///
///     TexturePlane plane; LinearFunction light;
///     std::uint16_t pixel(u, v, light) const       // RGB565
///     static bool serves(const Material&, bool vertex_colours)
///     template <class Gradients> void make_kind(const ShadingGroup&, const PolygonCorners&, const Gradients&)
///     static std::uint32_t flat_light(const ShadingGroup&, Link polygon)  // 16 bits, as vertex shades are
///
/// The light is made here: of the vertices' shades, or the same all over a polygon.
template <class Format, class Kind>
struct PixelwiseShader {
  using Pixel = typename Format::Pixel;
  static constexpr bool interpolates = true;

  struct Source {
    static constexpr bool constant = false;
    TextureBlocks::Coordinates coordinates;
    std::uint32_t light, step;
    const Kind* kind;
    [[nodiscard]] Pixel get() const { return Format::from_rgb565(kind->pixel(coordinates.u, coordinates.v, light)); }
    void forward() {
      coordinates.forward();
      light += step;
    }
    void back() {
      coordinates.back();
      light -= step;
    }
    void bend() { coordinates.bend(); }
  };

  class Blocks {
   public:
    Blocks(const Kind& kind, std::int32_t column) : kind_(kind), walk_(kind.plane, column) {}
    [[nodiscard]] std::uint32_t rest() const { return walk_.rest(); }
    [[nodiscard]] std::uint32_t rest_of_block() const { return walk_.rest_of_block(); }
    [[nodiscard]] Source source() const {
      return {walk_.coordinates(), kind_.light.at(walk_.column()), kind_.light.dx, &kind_};
    }
    void next() { walk_.next(); }

   private:
    const Kind& kind_;
    TextureBlocks walk_;
  };

  struct Surface : Kind {
    void next_row() { skip_rows(1); }
    void skip_rows(std::int32_t rows) {
      this->plane.skip_rows(rows);
      this->light.skip_rows(rows);
    }
    [[nodiscard]] Blocks blocks(std::int32_t column) const { return {*this, column}; }
  };

  [[nodiscard]] static bool serves(const Material& material, bool vertex_colours) {
    return Kind::serves(material, vertex_colours);
  }
  template <class Gradients>
  static void make(Surface& surface, const ShadingGroup& group, const PolygonCorners& polygon,
                   const Gradients& gradients) {
    surface.make_kind(group, polygon, gradients);
    if (group.vertex_shades == nullptr) {
      surface.light = {Kind::flat_light(group, polygon.polygon) << 16, 0, 0};
      return;
    }
    gradients.fit([&](const ScreenVertex* v) { return signed_word(group.vertex_shades[gradients.index(v)]); },
                  surface.light);
  }
};

}  // namespace spanline
