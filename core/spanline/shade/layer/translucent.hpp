#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "spanline/model/mesh.hpp"
#include "spanline/raster/polygon_corners.hpp"
#include "spanline/shade/general/general_shader.hpp"

namespace spanline {

/// The general shader with an opacity that varies over a polygon: that of its vertices, that of its texels, or the
/// product of both. It is drawn see-through by SeeThroughShader<Format, TranslucentShader<Format>>.
template <class Format>
struct TranslucentShader {
  using General = GeneralShader<Format>;
  using Pixel = typename Format::Pixel;
  static constexpr bool interpolates = true, translucent = true;
  struct Surface;

  struct Source : General::Source {
    std::uint32_t of_vertices, step;  ///< opacity of the vertices and its step a column, 8 bits in bits 31…24

    /// The pixel's opacity, 255ths of the material's.
    [[nodiscard]] std::uint32_t opacity() const {
      return with(general_opacity(*this->surface, *this->texels, this->coordinates.u, this->coordinates.v));
    }
    /// The pixel's colour and opacity.
    [[nodiscard]] GeneralColour translucent() const {
      GeneralColour colour = this->whole();
      colour.opacity = static_cast<std::uint8_t>(with(colour.opacity));
      return colour;
    }
    [[nodiscard]] std::int32_t screen_column() const { return this->at.column; }
    [[nodiscard]] std::int32_t screen_row() const { return this->surface->row; }
    void forward() {
      General::Source::forward();
      of_vertices += step;
    }
    void back() {
      General::Source::back();
      of_vertices -= step;
    }

   private:
    [[nodiscard]] std::uint32_t with(std::uint32_t of_texels) const {
      return word(in_255ths(signed_word((of_vertices >> 24) * of_texels)));
    }
  };

  class Blocks {
   public:
    Blocks(const Surface& surface, std::int32_t column)
        : opacity_(surface.opacity), general_(surface, column), column_(column) {}
    [[nodiscard]] std::uint32_t rest() const { return general_.rest(); }
    [[nodiscard]] std::uint32_t rest_of_block() const { return general_.rest_of_block(); }
    [[nodiscard]] Source source() const { return {general_.source(), opacity_.at(column_), opacity_.dx}; }
    void next() {
      column_ += signed_word(general_.rest_of_block());
      general_.next();
    }

   private:
    const LinearFunction& opacity_;
    typename General::Blocks general_;
    std::int32_t column_;
  };

  struct Surface : GeneralSurface {
    LinearFunction opacity;  ///< opacity of the vertices, 8 bits in bits 31…24

    void next_row() { skip_rows(1); }
    void skip_rows(std::int32_t rows) {
      GeneralSurface::skip_rows(rows);
      opacity.skip_rows(rows);
    }
    [[nodiscard]] Blocks blocks(std::int32_t column) const { return {*this, column}; }
  };

  [[nodiscard]] static bool serves(const Material&, bool) { return true; }

  template <class Gradients>
  static void make(Surface& surface, const ShadingGroup& group, const PolygonCorners& polygon,
                   const Gradients& gradients) {
    General::make(surface, group, polygon, gradients);
    if (group.textured->shades != vertex_shade::Kind::colour_and_opacity) {
      surface.opacity = {word(vertex_shade::highest_intensity) << 16, 0, 0};
      return;
    }
    gradients.fit(
        [&](const ScreenVertex* v) { return vertex_shade::byte_16(group.vertex_shades[gradients.index(v)], 3); },
        surface.opacity);
  }
};

/// Computes the shade of every vertex of a mesh whose vertices have opacities (Kind::colour_and_opacity): its opacity,
/// and its colour, or else the material's, under the group's light.
void shade_translucent_vertices(const Mesh& mesh, Rgb888 colour, const ShadingGroup& group, std::uint32_t* shades);

}  // namespace spanline
