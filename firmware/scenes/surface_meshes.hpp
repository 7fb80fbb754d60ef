#pragma once
#include <array>
#include <cstdint>

#include "spanline/model/mesh.hpp"
#include "spanline/model/texture.hpp"

namespace spanline::scenes {

/// A square of two units that faces +z, its texture upright on it, with colours and opacities of its corners.
namespace surface_square {
inline constexpr std::array<Vertex16, 4> vertices{{{-8, -8, 0}, {8, -8, 0}, {8, 8, 0}, {-8, 8, 0}}};
inline constexpr std::array<std::uint16_t, 6> indices{0, 1, 2, 0, 2, 3};
inline constexpr std::array<TextureCoordinate, 4> coordinates{{{0, 16384}, {16384, 16384}, {16384, 0}, {0, 0}}};
inline constexpr std::array<Rgb888, 4> colours{{{255, 90, 80}, {255, 240, 120}, {90, 255, 160}, {90, 130, 255}}};
inline constexpr std::array<std::uint8_t, 4> opacities{255, 200, 30, 120};

inline constexpr Mesh plain = [] {
  Mesh square;
  square.vertices = vertices;
  square.indices = indices;
  square.texture_coordinates = coordinates;
  square.step_exponent = -3;
  square.bounds = {{}, 12};
  return square;
}();
inline constexpr Mesh fading = [] {
  Mesh square = plain;
  square.vertex_colours = colours;
  square.vertex_opacities = opacities;
  return square;
}();
}  // namespace surface_square

/// A ring that is cut out, and a disc whose alpha falls from its middle.
namespace surface_textures {
inline constexpr unsigned log2_size = 4, size = 1u << log2_size;
[[nodiscard]] constexpr unsigned distance_squared(unsigned i) {
  const int x = static_cast<int>(2 * (i % size)) - static_cast<int>(size - 1),
            y = static_cast<int>(2 * (i / size)) - static_cast<int>(size - 1);
  return static_cast<unsigned>(x * x + y * y);
}
inline constexpr std::array<std::uint16_t, size* size> ring_texels = [] {
  std::array<std::uint16_t, size * size> table{};
  for (unsigned i = 0; i < table.size(); ++i) {
    const unsigned distance = distance_squared(i);
    const bool there = distance > 40 && distance < 220;
    const unsigned green = (i % 4 + 10) << 6;  // its lowest bit says whether the texel is there
    table[i] = static_cast<std::uint16_t>(i % 16 << 11 | green | (there ? 0x20u : 0u));
  }
  return table;
}();
inline constexpr std::array<std::uint16_t, size* size> disc_texels = [] {
  std::array<std::uint16_t, size * size> table{};
  for (unsigned i = 0; i < table.size(); ++i) {
    const unsigned distance = distance_squared(i), alpha = distance < 240 ? 15 - distance / 16 : 0;
    table[i] = static_cast<std::uint16_t>(alpha << 12 | 0xfff);
  }
  return table;
}();
inline constexpr Texture ring{
    .format = TexelFormat::rgb565_cutout, .log2_width = log2_size, .log2_height = log2_size, .words = ring_texels};
inline constexpr Texture disc{
    .format = TexelFormat::argb4444, .log2_width = log2_size, .log2_height = log2_size, .words = disc_texels};
}  // namespace surface_textures

}  // namespace spanline::scenes
