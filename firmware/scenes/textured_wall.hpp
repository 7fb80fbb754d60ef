#pragma once
#include <array>
#include <cstdint>

#include "spanline/frame/renderer.hpp"

namespace spanline::scenes {

using namespace spanline::literals;

/// Benchmark scene S6: a wall of two triangles that covers the picture and goes from 2 to 6 units away, under a texture
/// of 64 × 64 texels. Corners, clockwise from top left: (−1, ¾, −2), (3, 2¼, −6), (3, −2¼, −6), (−1, −¾, −2) with
/// texture coordinates (0, ⅓), (1, 0), (1, 1), (0, ⅔).
namespace textured_wall {

/// Quarters of a unit.
inline constexpr std::array<Vertex16, 4> vertices{{{-4, 3, -8}, {12, 9, -24}, {12, -9, -24}, {-4, -3, -8}}};
inline constexpr std::array<std::uint16_t, 6> indices{0, 2, 1, 0, 3, 2};
inline constexpr std::array<TextureCoordinate, 4> coordinates{{{0, 5461}, {16384, 0}, {16384, 16384}, {0, 10923}}};
inline constexpr Mesh mesh = [] {
  Mesh wall;
  wall.vertices = vertices;
  wall.indices = indices;
  wall.texture_coordinates = coordinates;
  wall.step_exponent = -2;
  wall.bounds = {{4, 0, -16}, 17};
  return wall;
}();

/// The same with normals for the light: as if the wall were a bay.
inline constexpr std::array<PackedNormal, 4> normals{PackedNormal(-300, 100, 400), PackedNormal(350, 200, 310),
                                                     PackedNormal(350, -200, 310), PackedNormal(-300, -100, 400)};
inline constexpr Mesh lit_mesh = [] {
  Mesh wall = mesh;
  wall.vertex_normals = normals;
  return wall;
}();

/// A checker of 8 × 8 fields.
inline constexpr std::array<std::uint16_t, 64 * 64> texels = [] {
  std::array<std::uint16_t, 64 * 64> table{};
  for (std::uint32_t i = 0; i < table.size(); ++i) table[i] = ((i >> 3) ^ (i >> 9)) & 1 ? 0xffff : 0x2104;
  return table;
}();
inline constexpr Texture texture{.log2_width = 6, .log2_height = 6, .words = texels};

/// A checker of 4 × 4 fields in 32 × 32 texels with a grain in blue, so that no texel is like its neighbours.
inline constexpr std::array<std::uint16_t, 32 * 32> grained_texels = [] {
  std::array<std::uint16_t, 32 * 32> table{};
  for (std::uint32_t i = 0; i < table.size(); ++i)
    table[i] =
        static_cast<std::uint16_t>((((i >> 2) ^ (i >> 7)) & 1 ? 0xd5a8 : 0x39a8) + ((i * 2654435769u >> 20) & 15));
  return table;
}();
inline constexpr Texture grained{.log2_width = 5, .log2_height = 5, .words = grained_texels};

/// The view, for a picture 240 lines high.
inline FrameSettings settings() {
  FrameSettings frame;
  frame.camera.focal = 320.0_q16;
  frame.camera.near_plane = 0.5_q16;
  frame.camera.far_plane = 16.0_q16;
  return frame;
}
inline constexpr std::array<DirectionalLight, 1> lights{{{{0.6_q30, {}, 0.8_q30}, Fixed<16>::from_ratio(9, 10)}}};
/// The view of benchmark scene S6F: the same wall, lit and in fog.
inline FrameSettings fogged_settings() {
  FrameSettings frame = settings();
  frame.lighting = {Fixed<16>::from_ratio(1, 10), lights};
  frame.fog = {FogCurve::linear, Q16_16::from_ratio(9, 4), 7.0_q16, {160, 176, 200}};
  return frame;
}
inline constexpr Material lit_material{.colour = {255, 255, 255},
                                       .shading = ShadingMode::gouraud,
                                       .texturing = {.texture = &texture, .function = TextureFunction::modulate}};
inline constexpr Material material{.texturing = {.texture = &texture, .function = TextureFunction::replace}};

}  // namespace textured_wall
}  // namespace spanline::scenes
