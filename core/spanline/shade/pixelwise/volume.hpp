#pragma once
#include <algorithm>
#include <array>
#include <cstdint>

#include "spanline/pixel/pixel_format.hpp"
#include "spanline/raster/link.hpp"
#include "spanline/raster/polygon_corners.hpp"
#include "spanline/shade/light/gouraud.hpp"
#include "spanline/shade/pixelwise/pixelwise_shader.hpp"

namespace spanline {

/// A solid given by a table. A solid gives the RGB565 colour at a point, whose coordinates are in 2^-32 of the
/// repeating cube.
struct TableSolid {
  static constexpr SolidSource source = SolidSource::table;
  [[nodiscard]] static std::uint16_t at(const Volume& volume, std::uint32_t s, std::uint32_t t, std::uint32_t r) {
    const VolumeTexture& texture = *volume.texture;
    const unsigned bits = texture.log2_size;
    const auto cell = [bits](std::uint32_t coordinate) { return coordinate >> 1 >> (31 - bits); };
    return texture.palette[texture.cells[((cell(r) << bits | cell(t)) << bits) | cell(s)]];
  }
};

/// The state of a polygon of a solid. A point of the polygon is corner + a·e + b·f, where e and f are two of its sides.
/// (a, b) are texture coordinates with 24 fraction bits that are 0 or 1 at the corners and are interpolated between
/// them in correct perspective.
struct VolumeGeometry : PixelwiseSurface {
  std::array<std::uint32_t, 3> corner;  ///< s, t and r of the first corner, 2^-32 cubes
  std::array<std::int32_t, 3> e, f;     ///< sides from the first corner, 2^-16 cubes

  [[nodiscard]] std::uint32_t coordinate(unsigned axis, std::uint32_t a, std::uint32_t b) const {
    const std::int32_t share_a = signed_word(a) >> 8, share_b = signed_word(b) >> 8;
    return corner[axis] + word(share_a) * word(e[axis]) + word(share_b) * word(f[axis]);
  }

  struct Point {
    std::int32_t s, t, r;  ///< 2^-20 cubes
  };
  /// Sets corner and sides; returns the values to which the plane of (a, b) is fitted.
  [[nodiscard]] TexturePlaneValues set(const std::array<Point, 3>& points,
                                       const std::array<std::uint32_t, 3>& of_corners, unsigned log2_size);
};

/// A surface of a solid, flat or smooth; `Solid` gives its colours.
template <class Solid>
struct VolumeSurface : VolumeGeometry {
  [[nodiscard]] LitTexel texel(std::uint32_t a, std::uint32_t b, std::uint32_t light_word) const {
    return {Solid::at(group->pixelwise->volume, coordinate(0, a, b), coordinate(1, a, b), coordinate(2, a, b)),
            light_word >> 16};
  }

  [[nodiscard]] static bool serves(const Material& material, bool vertex_colours) {
    return material.volume.source == Solid::source && !vertex_colours;
  }

  template <class Gradients>
  void make_kind(const ShadingGroup& shading, const PolygonCorners&, const Gradients& gradients) {
    const TexturedGroup& textured = *shading.textured;
    const Volume& volume = textured.pixelwise->volume;
    const auto corners = gradients.corners();
    std::array<Point, 3> points{};
    std::array<std::uint32_t, 3> of_corners{};
    for (unsigned i = 0; i < 3; ++i) {
      const std::size_t index = gradients.index(corners[i]);
      const TextureVertex& vertex = textured.vertices[index];
      points[i] = {vertex.s, vertex.t, textured.pixelwise->third_coordinates[index]};
      of_corners[i] = vertex.nearness;
    }
    const unsigned log2_size = volume.texture != nullptr ? volume.texture->log2_size : VolumeTexture::max_log2_size;
    fit_texture_plane(gradients, set(points, of_corners, log2_size), plane);
  }
  [[nodiscard]] static SurfaceLight flat_light(const ShadingGroup& shading, Link polygon) {
    const LocalLighting* local = shading.textured->local;
    return local != nullptr ? local->on_polygon(polygon) : SurfaceLight{shading.polygon_intensity(polygon), 0};
  }
};

/// Shades surfaces of solids (model/volume.hpp). `Solid` is TableSolid or a struct with the same members whose colours
/// come from a function.
template <class Format, class Solid = TableSolid>
struct VolumeShader : PixelwiseShader<Format, VolumeSurface<Solid>> {
  static constexpr bool volumetric = true;
};

template <class Shader>
concept DrawsVolumes = Shader::volumetric;

}  // namespace spanline
