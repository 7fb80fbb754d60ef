#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "scenes/textured_wall.hpp"
#include "shade/shading_scene.hpp"
#include "support/random_texture.hpp"
#include "support/ready_made_studios.hpp"

namespace spanline::test {

inline constexpr Capacity wall_capacity{.band_lines = 240,
                                        .colour_bands = 1,
                                        .vertices = 4,
                                        .shades = 4,
                                        .textures = 4,
                                        .polygons = 2,
                                        .active = 2,
                                        .awake = 2};

/// The benchmark's wall.
template <class Traits>
Picture<Traits> wall(const Material& material, const FrameSettings& settings, int band_lines = 240) {
  Capacity capacity = wall_capacity;
  capacity.band_lines = static_cast<std::uint16_t>(band_lines);
  if constexpr (Traits::Shaders::see_through) capacity.fragments = 2u * capacity.width * capacity.height;
  Studio<Traits> studio(capacity);
  studio.begin(settings);
  studio.add(scenes::textured_wall::mesh, {}, material);
  auto picture = studio.draw();
  EXPECT_TRUE(studio.status().ok()) << to_string(studio.status().fault);
  return picture;
}
/// Its distance along the axis of view at a column.
inline double wall_distance(int x) { return 3 / (1 - (x + 0.5 - 160) / 320); }
/// Fog before it, and the share of it by the formula in floating point.
struct WallFog {
  Fog fog;

  explicit WallFog(FogCurve curve) : fog{curve, Q16_16::from_ratio(9, 4), Q16_16::from_int(5), {255, 255, 255}} {}
  [[nodiscard]] double share(int x) const {
    return fog.curve == FogCurve::linear ? part(x) : (1 - std::exp2(-6 * part(x))) * 64 / 63;
  }
  /// By how much a pixel may be off: an entry of the table is a 64th of the distance, half of it to either side.
  [[nodiscard]] double allowed(int x) const {
    const double slope = fog.curve == FogCurve::linear ? 1 / 2.75 : std::exp2(-6 * part(x)) * 6 * std::log(2.0) / 2.75;
    return 1.0 / 126 + 0.004 + slope * wall_distance(x) / 60;
  }

 private:
  [[nodiscard]] static double part(int x) { return std::clamp((wall_distance(x) - 2.25) / 2.75, 0.0, 1.0); }
};
/// The mean of 4 × 4 pixels of a wall of one colour.
template <class Traits>
void expect_mean_of_dither(const Picture<Traits>& picture, Rgb888 colour) {
  double red = 0, green = 0, blue = 0;
  for (int y = 100; y < 104; ++y)
    for (int x = 60; x < 64; ++x) {
      const Channels shown(picture.pixels[picture.at(x, y)]);
      red += shown.red / 31.0;
      green += shown.green / 63.0;
      blue += shown.blue / 31.0;
    }
  EXPECT_NEAR(red / 16, colour.red / 255.0, 0.0025);
  EXPECT_NEAR(green / 16, colour.green / 255.0, 0.0025);
  EXPECT_NEAR(blue / 16, colour.blue / 255.0, 0.0025);
}
/// Texture coordinates of the wall at a pixel.
inline std::array<double, 2> wall_point(int x, int y) {
  const double z = wall_distance(x), s = (z - 2) / 4, ray_y = (120 - (y + 0.5)) / 320;
  return {s, 0.5 - (1.0 / 6 + s / 3) * ray_y / 0.375};
}

}  // namespace spanline::test
