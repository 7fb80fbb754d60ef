// Textures in fog by their fast form against formulas in floating point, and by every path the same bytes.
#include <gtest/gtest.h>
#include <spanline/frame/ready_made_traits.hpp>

#include <cmath>

#include "shade/shading_scene.hpp"
#include "shade/wall_picture.hpp"

namespace spanline::test {
namespace {

namespace scene = scenes::textured_wall;

template <class Traits>
Picture<Traits> fogged_wall(const Material& material, const FrameSettings& settings, int band_lines = 240) {
  Capacity capacity = wall_capacity;
  capacity.band_lines = static_cast<std::uint16_t>(band_lines);
  Studio<Traits> studio(capacity);
  studio.begin(settings);
  studio.add(scene::lit_mesh, {}, material);
  auto picture = studio.draw();
  EXPECT_TRUE(studio.status().ok()) << to_string(studio.status().fault);
  return picture;
}

/// The light at a corner of the wall.
double corner_light(std::size_t corner) {
  const PackedNormal n = scene::normals[corner];
  return std::min(1.0, 0.1 + 0.9 * std::max(0.0, (0.6 * n.x() + 0.8 * n.z()) / 511));
}
/// As Gouraud shading spreads it over the two triangles, which meet from top left to bottom right.
double wall_light(int x, int y) {
  const double right = (x + 0.5) / 320, down = (y + 0.5) / 240;
  const double top_left = corner_light(0), top_right = corner_light(1), bottom_right = corner_light(2),
               bottom_left = corner_light(3);
  if (down < right) return top_left + (top_right - top_left) * right + (bottom_right - top_right) * down;
  return top_left + (bottom_left - top_left) * down + (bottom_right - bottom_left) * right;
}

TEST(TexturesInFog, ChannelsAreTexelTimesLightAndFogInThirtySeconds) {
  Random random(61);
  const OwnTexture own(random, TexelFormat::rgb565, 6, 6);
  const auto drawn = [&](ShadingMode shading, TextureFunction function) {
    Material material = scene::lit_material;
    material.shading = shading;
    material.texturing.texture = &own.texture;
    material.texturing.function = function;
    return material;
  };
  // Without normals of its own a polygon has all the light.
  const std::pair<Material, bool> materials[] = {{drawn(ShadingMode::gouraud, TextureFunction::modulate), true},
                                                 {drawn(ShadingMode::flat, TextureFunction::modulate), false},
                                                 {drawn(ShadingMode::gouraud, TextureFunction::replace), false}};
  FrameSettings settings = scene::fogged_settings();
  const Rgb888 fog = settings.fog.colour;
  for (const auto& [material, is_lit] : materials)
    for (const FogCurve curve : {FogCurve::linear, FogCurve::exponential}) {
      const bool lit = is_lit;  // clang 14 lets no closure take a binding
      settings.fog.curve = curve;
      const auto picture = fogged_wall<FoggedTextureTraits<>>(material, settings);
      int wrong = 0;
      double worst = 0;
      for (int y = 0; y < 240; ++y)
        for (int x = 0; x < 320; ++x) {
          const auto [s, t] = wall_point(x, y);
          const auto column = static_cast<std::uint32_t>(s * 64) & 63, row = static_cast<std::uint32_t>(t * 64) & 63;
          const Channels texel(own.words[row * 64 + column]), shown(picture.pixels[picture.at(x, y)]);
          const double z = wall_distance(x), length = 4.75, part = std::clamp((z - 2.25) / length, 0.0, 1.0);
          const bool linear = curve == FogCurve::linear;
          const double share = linear ? part : (1 - std::exp2(-6 * part)) * 64 / 63;
          const double slope = (linear ? 1 : std::exp2(-6 * part) * 6 * std::log(2.0)) / length;
          const double light = lit ? wall_light(x, y) : 1;
          const auto off = [&](double of_texel, double of_fog, double shown_channel, double steps) {
            const double wanted = of_texel * light * (1 - share) + of_fog * share;
            // Half a step of the pixel; half a 32nd of each level; a 64th of the distance that the table knows; half a
            // piece of either's slope, which the light shares with the fog.
            const double fog_off = slope * z / 64 + 2 * slope * z * z / 3 / 320, light_off = lit ? 2 * 0.004 : 0;
            const double allowed = 0.5 / steps + (of_texel + of_fog) / 64 +
                                   std::abs(of_fog - of_texel * light) * fog_off + of_texel * light_off + 0.003;
            return std::abs(shown_channel / steps - wanted) / allowed;
          };
          const double most = std::max({off(texel.red / 31.0, fog.red / 255.0, shown.red, 31),
                                        off(texel.green / 63.0, fog.green / 255.0, shown.green, 63),
                                        off(texel.blue / 31.0, fog.blue / 255.0, shown.blue, 31)});
          if (most > 1)
            ++wrong;
          else
            worst = std::max(worst, most);
        }
      std::printf("%d of 76800 pixels are off, others by %.2f of what is allowed at most\n", wrong, worst);
      EXPECT_LE(wrong, 76800 * 3 / 1000);  // those of a neighbouring texel
    }
}

TEST(TexturesInFog, WhatIsWhiteStaysWhiteInWhiteFog) {
  const OwnTexture own = [] {
    OwnTexture white;
    white.words.assign(64, 0xffff);
    white.texture = {.log2_width = 3, .log2_height = 3, .words = white.words};
    return white;
  }();
  Material material = scene::lit_material;
  material.shading = ShadingMode::flat;
  material.texturing.texture = &own.texture;
  FrameSettings settings = scene::fogged_settings();
  settings.fog.colour = {255, 255, 255};
  const auto picture = fogged_wall<FoggedTextureTraits<>>(material, settings);
  for (const std::uint16_t pixel : picture.pixels) {
    const Channels shown(pixel);
    ASSERT_GE(shown.red, 30);
    ASSERT_GE(shown.green, 61);
  }
}

TEST(TexturesInFog, EveryAlgorithmAndBandDrawsTheSameBytes) {
  Random random(62);
  const OwnTexture own(random, TexelFormat::rgb565, 5, 6);
  Material material = scene::lit_material;
  material.texturing.texture = &own.texture;
  for (const TextureMapping mapping : {TextureMapping::perspective, TextureMapping::affine}) {
    material.texturing.mapping = mapping;
    const FrameSettings settings = scene::fogged_settings();
    const auto pixels = fogged_wall<FoggedTextureTraits<>>(material, settings).pixels;
    using At24 = FoggedTextureTraits<Rgb565, Depth24<>>;
    EXPECT_EQ((fogged_wall<At24>(material, settings, 7).pixels), pixels);
    EXPECT_EQ((fogged_wall<FoggedTextureTraits<Rgb565, Depth24<>, Spanning>>(material, settings, 16).pixels), pixels);
    // Statistics draw piece by piece.
    EXPECT_EQ((fogged_wall<FoggedTextureTraits<Rgb565, Depth16<>, Counted>>(material, settings).pixels), pixels);
  }
}

TEST(TexturesInFog, OtherSurfacesOfAFoggedFrameAndDitherAreMissing) {
  Studio<FoggedTextureTraits<>> studio(wall_capacity);
  FrameSettings settings = scene::fogged_settings();
  studio.begin(settings);
  EXPECT_EQ(studio.renderer().add(scene::lit_mesh, {}, {}).fault, Fault::shader_missing);
  settings.dither = true;
  studio.begin(settings);
  EXPECT_EQ(studio.renderer().add(scene::lit_mesh, {}, scene::lit_material).fault, Fault::shader_missing);
  settings.dither = false;
  settings.fog.curve = FogCurve::none;
  studio.begin(settings);
  EXPECT_TRUE(studio.renderer().add(scene::lit_mesh, {}, scene::lit_material).ok());
}

}  // namespace
}  // namespace spanline::test
