#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "scenes/textured_wall.hpp"
#include "support/random_texture.hpp"
#include "support/studio.hpp"

namespace spanline::test {

inline constexpr Capacity wall_capacity{
    .band_lines = 240, .colour_bands = 1, .vertices = 4, .shades = 4, .textures = 4, .polygons = 2, .active = 2};

/// The benchmark's wall.
template <class Traits>
Picture<Traits> wall(const Material& material, const FrameSettings& settings, int band_lines = 240) {
  Capacity capacity = wall_capacity;
  capacity.band_lines = static_cast<std::uint16_t>(band_lines);
  Studio<Traits> studio(capacity);
  studio.begin(settings);
  studio.add(scenes::textured_wall::mesh, {}, material);
  auto picture = studio.draw();
  EXPECT_TRUE(studio.status().ok()) << to_string(studio.status().fault);
  return picture;
}
/// Its distance along the axis of view at a column.
inline double wall_distance(int x) { return 3 / (1 - (x + 0.5 - 160) / 320); }
/// Texture coordinates there.
inline std::array<double, 2> wall_point(int x, int y) {
  const double z = wall_distance(x), s = (z - 2) / 4, ray_y = (120 - (y + 0.5)) / 320;
  return {s, 0.5 - (1.0 / 6 + s / 3) * ray_y / 0.375};
}

}  // namespace spanline::test
