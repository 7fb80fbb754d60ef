#pragma once
#include <algorithm>
#include <cstdint>

#include "spanline/raster/polygon_corners.hpp"
#include "spanline/shade/light/flat.hpp"
#include "spanline/shade/light/local_light.hpp"

namespace spanline {

/// Flat shading under everything that `LocalLighting` supports: point lights and highlights. A renderer with this
/// shader in its list uses it for flat shading in such light, and then also lights vertices that way.
template <class Format>
struct LocalFlatShader : FlatShader<Format> {
  using typename FlatShader<Format>::Surface;

  static void make(Surface& surface, const ShadingGroup& group, const PolygonCorners& polygon) {
    const LocalLighting& lighting = *group.textured->local;
    const Mesh& mesh = *group.mesh;
    const LitColour colour =
        mesh.polygon_colours.empty() ? group.colour : LitColour::from(mesh.polygon_colours[polygon.polygon]);
    const LitColour specular = LitColour::from(lighting.specular());
    const SurfaceLight light = lighting.on_polygon(polygon.polygon);
    const auto channel = [&](std::uint32_t own, std::uint32_t shine, std::uint32_t greatest) {
      return std::min((own * light.diffuse + shine * light.highlight + (1u << 23)) >> 24, greatest);
    };
    surface.pixel = Format::pack(channel(colour.red, specular.red, 31), channel(colour.green, specular.green, 63),
                                 channel(colour.blue, specular.blue, 31));
  }
};

}  // namespace spanline
