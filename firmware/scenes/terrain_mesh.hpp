#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "spanline/math/trigonometry.hpp"
#include "spanline/model/mesh.hpp"

namespace spanline::scenes {

/// Hills on a grid of 17 × 17 vertices, too wide for 16 bits: 2.4 million steps across, which are 2344 world units in
/// steps of 2^-10. The mesh lies 4096 units to the side of its origin (its offset). Made by the compiler from integers
/// alone.
struct TerrainTables {
  static constexpr std::size_t cells = 16, row = cells + 1;
  std::array<Vertex32, row * row> vertices{};
  std::array<std::uint16_t, 6 * cells * cells> indices{};
  std::array<PackedNormal, 2 * cells * cells> normals{};
  std::array<Rgb888, 2 * cells * cells> colours{};
};

namespace terrain_detail {

inline constexpr std::int32_t cell = 150'000, half_width = 8 * cell, hill = 90'000;

/// Two waves across each other: at most ±2·hill.
constexpr std::int32_t height(std::size_t column, std::size_t row) {
  const auto wave = [](std::size_t at, std::int64_t length) {
    return std::int64_t{sine(Angle::from_turns(static_cast<std::int64_t>(at), length)).raw()};
  };
  return static_cast<std::int32_t>(((wave(2 * column + row, 13) + wave(3 * row + 40 - column, 21)) * hill) >> 30);
}

constexpr PackedNormal normal(const Vertex32& a, const Vertex32& b, const Vertex32& c) {
  const auto difference = [](const Vertex32& from, const Vertex32& to) {
    return Vec3<std::int64_t>{std::int64_t{to.x} - from.x, std::int64_t{to.y} - from.y, std::int64_t{to.z} - from.z};
  };
  const Vec3<std::int64_t> u = difference(a, b), v = difference(a, c);
  const Direction n = normalise(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x);
  const auto component = [](Q2_30 value) {
    return static_cast<int>((std::int64_t{value.raw()} * 511 + (std::int64_t{1} << 29)) >> 30);
  };
  return {component(n.x), component(n.y), component(n.z)};
}

/// Water, meadow, rock and snow, by the height of a corner.
constexpr Rgb888 colour(std::int32_t y) {
  if (y < -hill) return {60, 110, 220};
  if (y < hill / 2) return {90, 170, 70};
  return y < hill * 5 / 4 ? Rgb888{150, 120, 90} : Rgb888{245, 245, 250};
}

constexpr TerrainTables make() {
  constexpr std::size_t row = TerrainTables::row;
  TerrainTables tables;
  for (std::size_t i = 0; i < row * row; ++i) {
    const std::size_t x = i % row, z = i / row;
    tables.vertices[i] = {static_cast<std::int32_t>(x) * cell - half_width, height(x, z),
                          static_cast<std::int32_t>(z) * cell - half_width};
  }
  for (std::size_t i = 0; i < 2 * TerrainTables::cells * TerrainTables::cells; ++i) {
    const std::size_t corner = i / 2 % TerrainTables::cells + i / 2 / TerrainTables::cells * row;
    const std::array<std::size_t, 3> triangle = i % 2 == 0 ? std::array{corner, corner + row, corner + row + 1}
                                                           : std::array{corner, corner + row + 1, corner + 1};
    for (std::size_t k = 0; k < 3; ++k) tables.indices[3 * i + k] = static_cast<std::uint16_t>(triangle[k]);
    const Vertex32 &a = tables.vertices[triangle[0]], &b = tables.vertices[triangle[1]],
                   &c = tables.vertices[triangle[2]];
    tables.normals[i] = normal(a, b, c);
    tables.colours[i] = colour(a.y);
  }
  return tables;
}

}  // namespace terrain_detail

inline constexpr TerrainTables terrain_tables = terrain_detail::make();

inline constexpr Mesh terrain{.vertices = {},
                              .wide_vertices = terrain_tables.vertices,
                              .indices = terrain_tables.indices,
                              .corners = {},
                              .polygon_normals = terrain_tables.normals,
                              .vertex_normals = {},
                              .polygon_colours = terrain_tables.colours,
                              .vertex_colours = {},
                              .offset = {4096 * 1024, 0, 0},
                              .step_exponent = -10,
                              .bounds = {{}, 1'720'000}};

}  // namespace spanline::scenes
