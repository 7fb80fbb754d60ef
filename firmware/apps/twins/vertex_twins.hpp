#pragma once
#include <cstdint>
#include <span>

#include "spanline/cpu/transform_vertices.hpp"
#include "spanline/model/mesh.hpp"
#include "twin_case.hpp"

/// The transform of vertices: none, one and many, near and far, depths at both clamps.
namespace twins {

using namespace spanline;

inline VertexConstants random_constants(Random& random) {
  VertexConstants c{};
  const std::int32_t reach = 1 << 13, z_reach = 1 << 24;
  for (int j = 0; j < 3; ++j) {
    c.x[j] = between(random, -reach, reach) / 2;
    c.y[j] = between(random, -reach, reach) / 2;
    c.z[j] = between(random, -z_reach, z_reach);
  }
  c.x_offset = between(random, -(1 << 27), 1 << 27);
  c.y_offset = between(random, -(1 << 27), 1 << 27);
  // Distances in [2^24, 2^29): the entries together move at most 3 · 2^24 · 2^15 / 2^14.
  c.z_offset = between(random, 0, 1) == 0 ? between(random, (1 << 26) * 2, (1 << 28) + (1 << 27)) : (7 << 24);
  c.shift = between(random, 12, 24);
  c.depth_scale = random() | 0x80000000u;
  c.depth_shift = between(random, 5, 20);
  c.depth_bits = between(random, 0, 1) == 0 ? 16 : 24;
  c.depth_fraction = 27 - c.depth_bits;
  c.depth_base = (1u << 27) + (random() >> 5);
  c.centre_x = between(random, 0, 2047 * 8) + ScreenVertex::bias;
  c.centre_y = between(random, 0, 2047 * 8) + ScreenVertex::bias;
  const std::int32_t all = (1 << c.depth_bits) - 1;
  c.nearest = between(random, 0, all / 2);
  c.farthest = between(random, c.nearest, all);
  return c;
}

inline bool vertices_alike(Random& random) {
  constexpr std::size_t most = 24;
  static Vertex16 vertices[most];
  static ScreenVertex fast[most], portable[most];
  const VertexConstants constants = random_constants(random);
  for (std::size_t i = 0; i < most; ++i) {
    const std::uint32_t a = random(), b = random();
    vertices[i] = {static_cast<std::int16_t>(a), static_cast<std::int16_t>(a >> 16), static_cast<std::int16_t>(b)};
    fast[i] = portable[i] = {};
  }
  const std::span<const Vertex16> some(vertices, random.below(most + 1));
  transform_vertices<false>(constants, some, fast);
  transform_vertices<false, Form::portable>(constants, some, portable);
  for (std::size_t i = 0; i < most; ++i) {
    if (fast[i].x != portable[i].x || fast[i].y != portable[i].y || fast[i].depth_word != portable[i].depth_word)
      return false;
  }
  return true;
}

}  // namespace twins
