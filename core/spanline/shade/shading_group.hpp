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

/// A light in the mesh's own axes, scaled so that three products with a packed normal give an intensity.
struct ModelLight {
  std::int32_t x, y, z;  ///< direction to the light times intensity · 65536 · 64 / 511

  /// The intensity, 1/65536, that falls on a packed normal; negative if the normal points away from the light.
  [[nodiscard]] std::int32_t on(PackedNormal normal) const {
    return (normal.x() * x + normal.y() * y + normal.z() * z) >> 6;
  }
};

struct FrameEffects;
class LocalLighting;

/// Extra data for groups drawn by shaders that compute each pixel (PixelwiseShader).
struct PixelwiseGroup {
  Relief relief;
  Volume volume;
  const std::int32_t* third_coordinates;  ///< texture coordinate r of each vertex, if there is a solid
};

/// Extra data for textured groups, groups drawn by GeneralShader, and groups in local light.
struct TexturedGroup {
  const TextureVertex* vertices;  ///< one for each vertex; null without a texture
  Texturing texturing;
  Rgb888 colour;                              ///< of the material
  bool smooth = false;                        ///< whether light and colour are interpolated between the vertices
  vertex_shade::Kind shades{};                ///< what each of `vertex_shades` holds
  const FrameEffects* effects = nullptr;      ///< of the frame; used by GeneralShader
  const LocalLighting* local = nullptr;       ///< null unless the group is in local light
  const PixelwiseGroup* pixelwise = nullptr;  ///< null unless the shader needs it
};

/// How a see-through group shows what lies behind it. Opaque groups ignore it.
struct Layering {
  std::uint16_t transparency : 2 = 0;  ///< a value of Transparency
  std::uint16_t level : 7 = 0;         ///< opacity: 32nds where colours are mixed, 64ths where pixels are left out
  std::uint16_t variant : 7 = 0;       ///< screen-door: number of the group; stochastic: seed
};

/// The data that shaders need of a group of polygons.
struct ShadingGroup {
  const Mesh* mesh = nullptr;  ///< null for triangles given in screen coordinates
  union {
    const std::uint16_t* screen_colours = nullptr;  ///< polygons given on screen: RGB565, one for each
    const TexturedGroup* textured;                  ///< meshes: set if the shader needs it
  };
  const std::uint32_t* vertex_shades = nullptr;  ///< Gouraud shading: one for each vertex (gouraud.hpp)
  const std::uint16_t* ramp = nullptr;  ///< Gouraud shading without vertex colours: 64 pixels from dark to full light
  std::uint32_t first_id = 0;           ///< id of the group's triangle 0
  LitColour colour{};                   ///< of the material
  std::uint16_t ambient = 65535;        ///< ambient intensity, 1/65536
  std::uint8_t light_count = 0;
  std::uint8_t shader = 0;  ///< index in the renderer's list of shaders
  Layering layering{};
  ModelLight lights[Lighting::max_lights] = {};

  /// Resets everything but the lights, of which only the first `light_count` are ever read.
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
  /// The intensity on a polygon of the mesh; full light if the mesh has no normals.
  [[nodiscard]] Intensity polygon_intensity(std::size_t polygon) const {
    return mesh->polygon_normals.empty() ? Intensity{65535} : intensity(mesh->polygon_normals[polygon]);
  }
};

}  // namespace spanline
