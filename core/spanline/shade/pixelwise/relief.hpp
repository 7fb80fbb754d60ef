#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "spanline/pixel/pixel_format.hpp"
#include "spanline/raster/link.hpp"
#include "spanline/raster/polygon_corners.hpp"
#include "spanline/shade/pixelwise/pixelwise_shader.hpp"

namespace spanline {

/// The signed light on vertices and polygons under relief: 2^14 is full light, the range is [−2, 2]. It is coded as 16
/// bits that stay clear of both ends of their range, so that interpolation cannot overflow.
namespace relief_light {
inline constexpr std::int32_t zero = 1 << 15;
/// Codes a signed light in 65536ths.
[[nodiscard]] constexpr std::int32_t coded(std::int32_t light) {
  return std::clamp<std::int32_t>((light >> 2) + zero, 64, 65471);
}
[[nodiscard]] constexpr std::int32_t decoded(std::uint32_t value) {
  return static_cast<std::int32_t>(value >> 16) - zero;
}
/// The coded light on a normal of a table; the code of no light if the table is empty.
[[nodiscard]] std::uint32_t shade(const ShadingGroup& group, std::span<const PackedNormal> normals, std::size_t number);
}  // namespace relief_light

/// Computes a shade for every vertex of a mesh under relief, for smooth shading.
void shade_vertices_for_relief(const Mesh& mesh, const ShadingGroup& group, std::uint32_t* shades);

/// The state of a polygon under relief. Its texture coordinates are texels of the height map, 16 fraction bits, and its
/// light is N·L.
struct ReliefSurface : PixelwiseSurface {
  std::int32_t along_s,
      along_t;          ///< bump: T·L and B·L, 2^14. Emboss: the step towards the light, −1, 0 or 1 texel each way
  std::int32_t turned;  ///< emboss: light added by turning the normal, 2^14
  std::int32_t factor;  ///< bump: slope for a height difference of 1, 2^16. Emboss: cosine of the turn, 2^14
  std::uint16_t ambient;
  std::uint16_t colour;  ///< RGB565; used without a texture

  /// The light at a point of the height map, 65535ths.
  [[nodiscard]] std::uint32_t light_at(std::uint32_t u, std::uint32_t v, std::int32_t facing) const;
  [[nodiscard]] LitTexel texel(std::uint32_t u, std::uint32_t v, std::uint32_t light_word) const;

  [[nodiscard]] static bool serves(const Material& material, bool vertex_colours);

  template <class Gradients>
  void make_kind(const ShadingGroup& shading, const PolygonCorners& polygon, const Gradients& gradients) {
    const HeightMap& map = *group->pixelwise->relief.heights;
    const auto corners = gradients.corners();
    const auto vertex = [&](unsigned i) { return group->vertices[gradients.index(corners[i])]; };
    fit_texture_plane(gradients,
                      texture_plane_values({vertex(0), vertex(1), vertex(2)}, group->texturing.mapping,
                                           {map.log2_width, map.log2_height, 16, 16}),
                      plane);
    set_polygon(shading, polygon.polygon);
  }
  [[nodiscard]] static SurfaceLight flat_light(const ShadingGroup& shading, Link polygon) {
    return {relief_light::shade(shading, shading.mesh->polygon_normals, polygon), 0};
  }

 private:
  /// Finds the directions of the texture's axes on a polygon of the mesh, and the light along them.
  void set_polygon(const ShadingGroup& shading, std::uint32_t polygon);
};

/// Bump mapping and embossing (model/relief.hpp), flat or smooth, over a colour or the nearest texels of a texture,
/// under one light. The error is below 1/100 of full light (tested).
template <class Format>
using ReliefShader = PixelwiseShader<Format, ReliefSurface>;

}  // namespace spanline
