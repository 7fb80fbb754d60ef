#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "spanline/math/trigonometry.hpp"
#include "spanline/model/mesh.hpp"

namespace spanline::scenes {

/// Six prisms on a plane, over regular polygons of 3 … 8 corners: 45 planar polygons of all the sizes that a mesh may
/// have, a colour each. Made by the compiler from integers alone, in steps of 2^-12.
struct PrismsTables {
  static constexpr std::size_t corners_in_all = 3 + 4 + 5 + 6 + 7 + 8;
  static constexpr std::size_t polygon_count = corners_in_all + 6 * 2;
  std::array<Vertex16, 2 * corners_in_all> vertices{};
  std::array<std::uint16_t, 6 * corners_in_all> indices{};
  std::array<std::uint8_t, polygon_count> corners{};
  std::array<PackedNormal, polygon_count> normals{};
  std::array<Rgb888, polygon_count> colours{};
};

namespace prisms_detail {

inline constexpr std::int32_t spacing = 3600, radius = 1600, half_height = 1400;

/// factor · sine or cosine, rounded.
constexpr int scaled(std::int32_t factor, Q2_30 value) {
  return static_cast<int>((std::int64_t{factor} * value.raw() + (std::int64_t{1} << 29)) >> 30);
}

/// Appends to the tables of a mesh.
struct Builder {
  PrismsTables tables{};
  std::size_t vertices = 0, indices = 0, polygons = 0;

  constexpr void vertex(int x, int y, int z) {
    tables.vertices[vertices++] = {static_cast<std::int16_t>(x), static_cast<std::int16_t>(y),
                                   static_cast<std::int16_t>(z)};
  }
  constexpr void corner(std::size_t vertex_number) {
    tables.indices[indices++] = static_cast<std::uint16_t>(vertex_number);
  }
  constexpr void polygon(std::size_t corner_count, PackedNormal normal) {
    tables.corners[polygons] = static_cast<std::uint8_t>(corner_count);
    tables.normals[polygons] = normal;
    tables.colours[polygons] = {static_cast<std::uint8_t>(80 + polygons * 53 % 176),
                                static_cast<std::uint8_t>(80 + polygons * 97 % 176),
                                static_cast<std::uint8_t>(80 + polygons * 139 % 176)};
    ++polygons;
  }

  /// A prism over `n` corners, centred at (x, 0, z). Corner i of the top is vertex 2i, of the bottom 2i + 1; corners go
  /// round clockwise as seen from above.
  constexpr void prism(std::size_t n, int x, int z) {
    const std::size_t first = vertices;
    const auto turn = [n](std::size_t half_steps) {
      return Angle::from_turns(static_cast<std::int64_t>(half_steps), static_cast<std::int64_t>(2 * n));
    };
    for (std::size_t i = 0; i < n; ++i) {
      const int dx = scaled(radius, cosine(turn(2 * i))), dz = scaled(radius, sine(turn(2 * i)));
      vertex(x + dx, half_height, z + dz);
      vertex(x + dx, -half_height, z + dz);
    }
    for (std::size_t i = 0; i < n; ++i) corner(first + 2 * (n - 1 - i));
    polygon(n, {0, 511, 0});
    for (std::size_t i = 0; i < n; ++i) corner(first + 2 * i + 1);
    polygon(n, {0, -511, 0});
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t here = first + 2 * i, next = first + 2 * ((i + 1) % n);
      for (const std::size_t v : {here, next, next + 1, here + 1}) corner(v);
      polygon(4, {scaled(511, cosine(turn(2 * i + 1))), 0, scaled(511, sine(turn(2 * i + 1)))});
    }
  }
};

constexpr PrismsTables make() {
  Builder builder;
  for (std::size_t i = 0; i < 6; ++i) {
    const int column = static_cast<int>(i % 3) - 1, row = static_cast<int>(i / 3);
    builder.prism(3 + i, column * spacing, row * spacing - spacing / 2);
  }
  return builder.tables;
}

}  // namespace prisms_detail

inline constexpr PrismsTables prisms_tables = prisms_detail::make();

inline constexpr Mesh prisms{.vertices = prisms_tables.vertices,
                             .wide_vertices = {},
                             .indices = prisms_tables.indices,
                             .corners = prisms_tables.corners,
                             .polygon_normals = prisms_tables.normals,
                             .vertex_normals = {},
                             .polygon_colours = prisms_tables.colours,
                             .vertex_colours = {},
                             .step_exponent = -12,
                             .bounds = {{}, 6200}};

/// The same, marked as planar.
inline constexpr auto planar_prisms_corners = [] {
  auto corners = prisms_tables.corners;
  for (std::uint8_t& count : corners) count |= Mesh::planar;
  return corners;
}();
inline constexpr Mesh planar_prisms = [] {
  Mesh mesh = prisms;
  mesh.corners = planar_prisms_corners;
  return mesh;
}();

}  // namespace spanline::scenes
