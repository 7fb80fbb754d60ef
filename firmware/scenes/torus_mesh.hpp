#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "spanline/math/trigonometry.hpp"
#include "spanline/model/mesh.hpp"

namespace spanline::scenes {

/// Tables of a torus about the y axis, made by the compiler from integers alone: ring radius 1, tube radius 0.4, in
/// steps of 2^-12. `Rings` sections of `Sides` corners; every quad between them is two triangles.
template <std::size_t Rings, std::size_t Sides>
struct TorusTables {
  static constexpr std::size_t count = Rings * Sides;
  std::array<Vertex16, count> vertices{};
  std::array<std::uint16_t, 6 * count> indices{};
  std::array<PackedNormal, 2 * count> polygon_normals{};
  std::array<PackedNormal, count> vertex_normals{};
  std::array<Rgb888, count> vertex_colours{};
};

namespace torus_detail {

inline constexpr std::int32_t ring_radius = 4096, tube_radius = 1638;

/// factor · a · b, rounded; |factor| < 2^15.
constexpr std::int32_t scaled(std::int32_t factor, Q2_30 a, Q2_30 b) {
  const std::int64_t product = multiply<Q2_30>(a, b).raw();
  return static_cast<std::int32_t>((product * factor + (std::int64_t{1} << 29)) >> 30);
}

/// A point or normal of the tube: `around` turns about the y axis, `section` about the tube; outwards at 0.
constexpr Vec3<std::int32_t> on_tube(Angle around, Angle section, std::int32_t ring, std::int32_t tube) {
  const Q2_30 one = Q2_30::from_int(1);
  return {scaled(ring, cosine(around), one) + scaled(tube, cosine(section), cosine(around)),
          scaled(tube, sine(section), one),
          scaled(ring, sine(around), one) + scaled(tube, cosine(section), sine(around))};
}

constexpr PackedNormal normal(Angle around, Angle section) {
  const Vec3<std::int32_t> n = on_tube(around, section, 0, 511);
  return {n.x, n.y, n.z};
}

/// A colour circle once around.
constexpr Rgb888 colour(Angle around) {
  const auto channel = [around](int degrees) {
    const Q2_30 wave = cosine(around + Angle::from_degrees(degrees));
    return static_cast<std::uint8_t>(128 + scaled(127, wave, Q2_30::from_int(1)));
  };
  return {channel(0), channel(120), channel(240)};
}

}  // namespace torus_detail

template <std::size_t Rings, std::size_t Sides>
constexpr TorusTables<Rings, Sides> make_torus() {
  using namespace torus_detail;
  TorusTables<Rings, Sides> tables;
  for (std::size_t i = 0; i < Rings * Sides; ++i) {
    const std::size_t ring = i / Sides, side = i % Sides;
    // Half steps: even ones are corners, odd ones the middles of the faces.
    const auto around = [](std::size_t half_steps) {
      return Angle::from_turns(static_cast<std::int64_t>(half_steps), 2 * Rings);
    };
    const auto section = [](std::size_t half_steps) {
      return Angle::from_turns(static_cast<std::int64_t>(half_steps), 2 * Sides);
    };
    const Vec3<std::int32_t> p = on_tube(around(2 * ring), section(2 * side), ring_radius, tube_radius);
    tables.vertices[i] = {static_cast<std::int16_t>(p.x), static_cast<std::int16_t>(p.y),
                          static_cast<std::int16_t>(p.z)};
    tables.vertex_normals[i] = normal(around(2 * ring), section(2 * side));
    tables.vertex_colours[i] = colour(around(2 * ring));
    tables.polygon_normals[2 * i] = tables.polygon_normals[2 * i + 1] =
        normal(around(2 * ring + 1), section(2 * side + 1));

    const std::size_t next_ring = (ring + 1) % Rings * Sides, this_ring = ring * Sides, next_side = (side + 1) % Sides;
    const std::array<std::size_t, 6> corners{this_ring + side,      this_ring + next_side, next_ring + next_side,
                                             next_ring + next_side, next_ring + side,      this_ring + side};
    for (std::size_t k = 0; k < 6; ++k) tables.indices[6 * i + k] = static_cast<std::uint16_t>(corners[k]);
  }
  return tables;
}

/// 288 vertices and 576 triangles, about half of which face the eye.
inline constexpr TorusTables<24, 12> torus_tables = make_torus<24, 12>();

inline constexpr BoundingSphere torus_bounds{{}, torus_detail::ring_radius + torus_detail::tube_radius + 2};

inline constexpr Mesh torus{.vertices = torus_tables.vertices,
                            .wide_vertices = {},
                            .indices = torus_tables.indices,
                            .corners = {},
                            .polygon_normals = torus_tables.polygon_normals,
                            .vertex_normals = torus_tables.vertex_normals,
                            .polygon_colours = {},
                            .vertex_colours = {},
                            .step_exponent = -12,
                            .bounds = torus_bounds};

/// The same with a colour at every vertex.
inline constexpr Mesh coloured_torus = [] {
  Mesh mesh = torus;
  mesh.vertex_colours = torus_tables.vertex_colours;
  return mesh;
}();

}  // namespace spanline::scenes
