#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "scenes/textured_wall.hpp"

namespace spanline::scenes {

/// The wall of S6 under what surfaces can be asked for, one thing at a time: what each costs.
namespace wall_surfaces {

/// The checker with its mip levels, which are grey from the field's size on.
inline constexpr std::array<std::uint16_t, 5461> mip_texels = [] {
  std::array<std::uint16_t, 5461> table{};
  std::size_t at = 0;
  for (unsigned log2_size = 7; log2_size-- > 0;)
    for (std::uint32_t i = 0; i < 1u << 2 * log2_size; ++i) {
      const std::uint32_t x = i & ((1u << log2_size) - 1), y = i >> log2_size;
      const bool light = ((x ^ y) << 3 >> log2_size & 1) != 0;
      table[at++] = log2_size < 3 ? 0x8c71 : light ? 0xffff : 0x2104;
    }
  return table;
}();
inline constexpr Texture mip_mapped{.log2_width = 6, .log2_height = 6, .levels = 7, .words = mip_texels};
inline constexpr Texture clamped = [] {
  Texture texture = textured_wall::texture;
  texture.wrap_s = texture.wrap_t = Wrap::clamp;
  return texture;
}();

inline constexpr std::array<std::uint8_t, 32 * 32> height_table = [] {
  std::array<std::uint8_t, 32 * 32> table{};
  for (std::uint32_t i = 0; i < table.size(); ++i)
    table[i] = static_cast<std::uint8_t>((i & 7) * (7 - (i & 7)) * 12 + ((i >> 5) & 7) * 8);
  return table;
}();
inline constexpr HeightMap heights{5, 5, height_table};

inline constexpr std::array<std::uint8_t, 8 * 8 * 8> cells = [] {
  std::array<std::uint8_t, 8 * 8 * 8> table{};
  for (std::uint32_t i = 0; i < table.size(); ++i) table[i] = static_cast<std::uint8_t>(i ^ i >> 3 ^ i >> 6);
  return table;
}();
inline constexpr std::array<std::uint16_t, 256> cell_colours = [] {
  std::array<std::uint16_t, 256> table{};
  for (std::uint32_t i = 0; i < table.size(); ++i) table[i] = static_cast<std::uint16_t>(i * 2654435769u >> 16);
  return table;
}();
inline constexpr VolumeTexture solid_table{3, cells, cell_colours};

/// With a normal a polygon, for flat light.
inline constexpr std::array<PackedNormal, 2> normals{PackedNormal(361, 0, 361), PackedNormal(361, 0, 361)};
inline constexpr Mesh mesh = [] {
  Mesh wall = textured_wall::mesh;
  wall.polygon_normals = normals;
  return wall;
}();

struct Surface {
  const char* name;
  Material material;
  bool fog = false, dither = false;
};

inline constexpr Material textured{.colour = {255, 255, 255}, .texturing = {.texture = &textured_wall::texture}};
inline constexpr Material bilinear = [] {
  Material material = textured;
  material.texturing.filter = TextureFilter::bilinear;
  return material;
}();
inline constexpr Material filtered_mips = [] {
  Material material = bilinear;
  material.texturing.texture = &mip_mapped;
  material.texturing.mip_mapping = MipMapping::span;
  return material;
}();
inline constexpr Material clamped_texels = [] {
  Material material = textured;
  material.texturing.texture = &clamped;
  return material;
}();
inline constexpr Material under_relief(ReliefKind kind) {
  Material material;
  material.colour = {200, 160, 120};
  material.relief = {.heights = &heights, .kind = kind};
  return material;
}
inline constexpr Material solid = [] {
  Material material;
  material.volume = {.source = SolidSource::table, .texture = &solid_table, .exponent = -1};
  return material;
}();

inline constexpr std::array<Surface, 9> all{{{"nearest", textured},
                                             {"bilinear", bilinear},
                                             {"mipmap", filtered_mips},
                                             {"clamp", clamped_texels},
                                             {"dither", textured, false, true},
                                             {"bump", under_relief(ReliefKind::bump)},
                                             {"emboss", under_relief(ReliefKind::emboss)},
                                             {"solid", solid},
                                             {"solid-fog", solid, true}}};

}  // namespace wall_surfaces
}  // namespace spanline::scenes
