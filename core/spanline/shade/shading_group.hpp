#pragma once
#include <cstddef>
#include <cstdint>

#include "spanline/model/light.hpp"
#include "spanline/model/material.hpp"
#include "spanline/model/mesh.hpp"
#include "spanline/pixel/pixel_format.hpp"
#include "spanline/raster/texture_vertex.hpp"
#include "spanline/raster/vertex_shade.hpp"

namespace spanline {

/// A light as one group sees it: turned into the mesh's own axes and scaled, so that a packed normal gives an
/// intensity by three products.
struct ModelLight {
  std::int32_t x, y, z;  ///< light·intensity · 65536 · 64 / 511

  /// Intensity (1/65536) that falls on a packed normal; negative if it faces away.
  [[nodiscard]] std::int32_t on(PackedNormal normal) const {
    return (normal.x() * x + normal.y() * y + normal.z() * z) >> 6;
  }
};

struct FrameEffects;
class LocalLighting;

/// What shaders that work out pixel by pixel need to know of a group.
struct PixelwiseGroup {
  Relief relief;
  Volume volume;
  const std::int32_t* third_coordinates;  ///< r, one a vertex, where there is a solid
};

/// What shaders need to know of a textured group besides, the general shader of any, and others of groups in local
/// light.
struct TexturedGroup {
  const TextureVertex* vertices;  ///< one a vertex; null without a texture
  Texturing texturing;
  Rgb888 colour;                              ///< the material's
  bool smooth = false;                        ///< light and colour are interpolated
  vertex_shade::Kind shades{};                ///< what `vertex_shades` are
  const FrameEffects* effects = nullptr;      ///< of the frame; for the general shader
  const LocalLighting* local = nullptr;       ///< where the light is more than the group's own
  const PixelwiseGroup* pixelwise = nullptr;  ///< for shaders that ask for it
};

/// How a see-through group shows what lies behind it; nothing to opaque ones.
struct Layering {
  std::uint16_t transparency : 2 = 0;  ///< Transparency
  std::uint16_t level : 7 = 0;         ///< coverage in 32nds where colours mix, in 64ths where pixels are left out
  std::uint16_t variant : 7 = 0;       ///< screen-door: number of the group; stochastic: seed
};

/// What shaders need to know of a group of polygons.
struct ShadingGroup {
  const Mesh* mesh = nullptr;  ///< null for triangles given on screen
  union {
    const std::uint16_t* screen_colours = nullptr;  ///< of triangles given on screen: RGB565, one a triangle
    const TexturedGroup* textured;  ///< of a mesh: for shaders of textures, in local light, and the general one
  };
  const std::uint32_t* vertex_shades = nullptr;  ///< Gouraud: one a vertex (gouraud.hpp)
  const std::uint16_t* ramp = nullptr;           ///< Gouraud without vertex colours: 64 pixels
  std::uint32_t first_id = 0;                    ///< id of the group's triangle 0
  LitColour colour{};                            ///< the material's
  std::uint16_t ambient = 65535;                 ///< 1/65536
  std::uint8_t light_count = 0;
  std::uint8_t shader = 0;  ///< place in the renderer's list of shaders
  Layering layering{};
  ModelLight lights[Lighting::max_lights] = {};

  /// Makes it new, but for the lights: as many as are counted are written.
  void clear() {
    mesh = nullptr;
    screen_colours = nullptr;
    vertex_shades = nullptr;
    ramp = nullptr;
    first_id = 0;
    colour = {};
    ambient = 65535;
    light_count = shader = 0;
    layering = {};
  }

  /// min(1, ambient + Σ max(0, n·l)), 1/65536.
  [[nodiscard]] Intensity intensity(PackedNormal normal) const {
    std::int32_t sum = ambient;
    for (unsigned i = 0; i < light_count; ++i) {
      const std::int32_t light = lights[i].on(normal);
      if (light > 0) sum += light;
    }
    return sum > 65535 ? 65535 : static_cast<Intensity>(sum);
  }
  /// The light on a polygon of the mesh; full where it has no normals.
  [[nodiscard]] Intensity polygon_intensity(std::size_t polygon) const {
    return mesh->polygon_normals.empty() ? Intensity{65535} : intensity(mesh->polygon_normals[polygon]);
  }
};

}  // namespace spanline
