#pragma once
#include <cstdint>

#include "spanline/raster/polygon_corners.hpp"
#include "spanline/raster/span.hpp"
#include "spanline/shade/shading_group.hpp"

namespace spanline {

/// Flat shading: one colour a polygon, lit by the polygon's normal.
///
/// A shader is a struct with a `Surface`, which holds its state for one polygon while that is active. `make` fills the
/// surface when the polygon starts, `next_row` steps it one row down, and `source` gives a pixel source for a run that
/// begins at a column. A pixel source gives the current pixel and steps left and right. The z-buffers inline sources
/// into their loops; span algorithms fill whole runs.
template <class Format>
struct FlatShader {
  using Pixel = typename Format::Pixel;
  static constexpr bool interpolates = false;

  struct Source {
    static constexpr bool constant = true;
    Pixel pixel;
    [[nodiscard]] Pixel get() const { return pixel; }
    void forward() {}
    void back() {}
  };

  struct Surface {
    Pixel pixel;
    void next_row() {}
    void skip_rows(std::int32_t) {}
    [[nodiscard]] Source source(std::int32_t) const { return {pixel}; }
  };

  [[nodiscard]] static Pixel colour_of(const ShadingGroup& group, const PolygonCorners& polygon) {
    if (group.mesh == nullptr) return Format::from_rgb565(group.screen_colours[polygon.polygon]);
    const Mesh& mesh = *group.mesh;
    const LitColour colour =
        mesh.polygon_colours.empty() ? group.colour : LitColour::from(mesh.polygon_colours[polygon.polygon]);
    return Format::lit(colour, group.polygon_intensity(polygon.polygon));
  }

  static void make(Surface& surface, const ShadingGroup& group, const PolygonCorners& polygon) {
    surface.pixel = colour_of(group, polygon);
  }
};

}  // namespace spanline
