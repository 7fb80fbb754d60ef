// Bump mapping and embossing against their formulas in floating point (model/relief.hpp).
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "shade/shading_scene.hpp"
#include "shade/wall_picture.hpp"
#include "spanline/frame/ready_made_traits.hpp"
#include "spanline/shade/pixelwise/lit_texel.hpp"
#include "support/effort.hpp"

namespace spanline::test {
namespace {

template <class Depth = Depth16<>, class Visibility = ZBuffer>
using ReliefTraits = RendererTraits<
    Rgb565, ShaderList<FlatShader<Rgb565>, GouraudShader<Rgb565>, GouraudColourShader<Rgb565>, ReliefShader<Rgb565>>,
    Depth, Visibility>;

TEST(LitTexel, ChannelsAreRounded) {
  for (std::uint32_t channel = 0; channel < 64; ++channel)
    for (std::uint32_t light = 0; light < 65536; light += 13) {
      const Channels got(lit_rgb565(channel << 5 | (channel >> 1) << 11, light));
      ASSERT_NEAR(got.green, channel * light / 65535.0, 0.501);
      ASSERT_NEAR(got.red, (channel >> 1) * light / 65535.0, 0.501);
    }
  EXPECT_EQ(lit_rgb565(0xffff, 65535), 0xffff);
}

/// Heights that own their table.
struct OwnHeights {
  std::vector<std::uint8_t> table;
  HeightMap map;

  OwnHeights(Random& random, unsigned log2_width, unsigned log2_height, int roughness) {
    map.log2_width = static_cast<std::uint8_t>(log2_width);
    map.log2_height = static_cast<std::uint8_t>(log2_height);
    for (int i = 0; i < 1 << (log2_width + log2_height); ++i)
      table.push_back(static_cast<std::uint8_t>(128 + random.between(-roughness, roughness)));
    map.heights = table;
    EXPECT_TRUE(map.valid());
  }
  [[nodiscard]] double at(int x, int y) const {
    const int column = x & ((1 << map.log2_width) - 1), row = y & ((1 << map.log2_height) - 1);
    return table[static_cast<std::size_t>((row << map.log2_width) + column)] / 255.0;
  }
};

/// The benchmark's wall with its normal, (1, 0, 1) / √2, for polygons and vertices.
struct LitWall {
  std::array<PackedNormal, 4> normals{PackedNormal(361, 0, 361), PackedNormal(361, 0, 361), PackedNormal(361, 0, 361),
                                      PackedNormal(361, 0, 361)};
  Mesh mesh = scenes::textured_wall::mesh;
  LitWall() {
    mesh.vertex_normals = normals;
    mesh.polygon_normals = std::span(normals).first(2);
  }
};

/// The formula's light at a texel of the heights.
double formula(const Relief& relief, const OwnHeights& heights, const RandomLights& lights, int x, int y) {
  double light[3] = {};
  for (const DirectionalLight& l : lights.lights) {
    const double intensity = std::ldexp(l.intensity.raw(), -16);
    light[0] += l.towards.x.raw() * 0x1p-30 * intensity;
    light[1] += l.towards.y.raw() * 0x1p-30 * intensity;
    light[2] += l.towards.z.raw() * 0x1p-30 * intensity;
  }
  // s runs along (1, 0, −1) / √2, t downwards.
  const double facing = 361 / 511.0 * (light[0] + light[2]), along_s = (light[0] - light[2]) / std::sqrt(2.0),
               along_t = -light[1], ambient = std::ldexp(lights.ambient.raw(), -16);
  double lit = facing;
  if (relief.kind == ReliefKind::bump) {
    const double depth = std::ldexp(relief.depth.raw(), -16);
    const double p = std::clamp(depth * (heights.at(x + 1, y) - heights.at(x - 1, y)) / 2, -2.0, 2.0);
    const double q = std::clamp(depth * (heights.at(x, y + 1) - heights.at(x, y - 1)) / 2, -2.0, 2.0);
    lit = (facing - p * along_s - q * along_t) / std::sqrt(1 + p * p + q * q);
  } else {
    const double length = std::hypot(along_s, along_t), tangent = std::tan(std::acos(-1) / 8);
    const auto neighbour = [&](double part, double other) {
      return std::abs(part) <= std::abs(other) * tangent ? 0 : part < 0 ? -1 : 1;
    };
    const double fall = heights.at(x, y) - heights.at(x + neighbour(along_s, along_t), y + neighbour(along_t, along_s));
    const double turn = relief.turn.raw() * std::acos(-1) * 0x1p-31;
    if (std::abs(fall) > 8.5 / 255) lit = facing * std::cos(turn) + std::copysign(length * std::sin(turn), fall);
  }
  return std::min(1.0, ambient + std::max(0.0, lit));
}

TEST(Relief, LightFollowsItsFormula) {
  Random random(1);
  double worst = 0;
  for (int i = 0; i < rounds(12); ++i) {
    const OwnHeights heights(random, 6, 5, random.chance(2) ? 127 : 20);
    const RandomLights lights(random, random.between(1, 2));
    FrameSettings settings = scenes::textured_wall::settings();
    settings.lighting = lights.lighting();
    Material material{random_colour(random), random.chance(2) ? ShadingMode::flat : ShadingMode::gouraud};
    material.relief = {&heights.map, i % 2 == 0 ? ReliefKind::bump : ReliefKind::emboss,
                       nearest<Fixed<16>>(random.real(0.2, 20)), Angle::from_degrees(random.between(10, 70))};
    const LitWall wall;
    Capacity capacity{.band_lines = 240, .colour_bands = 1, .vertices = 4, .shades = 4, .textures = 4, .polygons = 2};
    Studio<ReliefTraits<>> studio(capacity);
    studio.begin(settings);
    studio.add(wall.mesh, {}, material);
    const auto picture = studio.draw();
    ASSERT_TRUE(studio.status().ok()) << to_string(studio.status().fault);
    const Channels own(Rgb565::from(material.colour));
    int other_texel = 0;
    for (int y = 0; y < 240; ++y)
      for (int x = 0; x < 320; ++x) {
        const auto [s, t] = wall_point(x, y);
        const double wanted = formula(material.relief, heights, lights, static_cast<int>(std::floor(s * 64)),
                                      static_cast<int>(std::floor(t * 32)));
        const double off = std::abs(Channels(picture.pixels[picture.at(x, y)]).green - wanted * own.green) / 63;
        if (off > 0.5 / 63 + 0.01)
          ++other_texel;
        else
          worst = std::max(worst, off - 0.5 / 63);
      }
    EXPECT_LE(other_texel, 76800 * 3 / 1000) << "round " << i;
  }
  std::printf("relief: light is off by at most %.4f beside the rounding of pixels\n", worst);
}

TEST(Relief, AFlatMapChangesNothing) {
  Random random(2);
  for (int i = 0; i < rounds(6); ++i) {
    const OwnHeights heights(random, 3, 3, 0);
    const RandomLights lights(random, 1);
    FrameSettings settings = scenes::textured_wall::settings();
    settings.lighting = lights.lighting();
    const LitWall wall;
    Capacity capacity{.band_lines = 240, .colour_bands = 1, .vertices = 4, .shades = 4, .textures = 4, .polygons = 2};
    Studio<ReliefTraits<>> studio(capacity);
    const auto draw = [&](const Material& material) {
      studio.begin(settings);
      studio.add(wall.mesh, {}, material);
      return studio.draw();
    };
    Material material{{255, 255, 255}};
    const auto plain = draw(material);
    for (const ReliefKind kind : {ReliefKind::bump, ReliefKind::emboss}) {
      material.relief = {&heights.map, kind};
      const auto embossed = draw(material);
      for (std::size_t p = 0; p < plain.pixels.size(); ++p)
        ASSERT_NEAR(Channels(plain.pixels[p]).green, Channels(embossed.pixels[p]).green, 1);
    }
  }
}

TEST(Relief, BandsAndSpansDrawTheSameBytesWithTextureOrWithout) {
  Random random(3);
  for (int i = 0; i < rounds(30); ++i) {
    const OwnHeights heights(random, 5, 4, 100);
    ShadedInstance shaded(random);
    add_effects(random, shaded.settings);
    Material material{random_colour(random), random.chance(2) ? ShadingMode::flat : ShadingMode::gouraud};
    material.relief = {&heights.map, random.chance(2) ? ReliefKind::bump : ReliefKind::emboss};
    if (random.chance(2)) material.texturing.texture = &scenes::textured_wall::texture;
    expect_alike_in_bands_and_spans<ReliefTraits<Depth24<>>, ReliefTraits<Depth24<>, Spanning>>(
        shaded.instance, shaded.settings, material);
    ASSERT_FALSE(HasFailure()) << "round " << i;
  }
}

TEST(Relief, WhatItCannotDrawIsRefused) {
  Random random(4);
  const OwnHeights heights(random, 3, 3, 9);
  const LitWall wall;
  Capacity capacity{.band_lines = 240, .colour_bands = 1, .vertices = 4, .shades = 4, .textures = 4, .polygons = 2};
  const auto status = [&]<class Traits>(const Material& material, const FrameSettings& settings, Traits*) {
    Studio<Traits> studio(capacity);
    studio.begin(settings);
    studio.add(wall.mesh, {}, material);
    return studio.status().fault;
  };
  const FrameSettings plain = scenes::textured_wall::settings();
  Material material{};
  material.relief.heights = &heights.map;
  EXPECT_EQ(status(material, plain, static_cast<ReliefTraits<>*>(nullptr)), Fault::none);
  EXPECT_EQ(status(material, plain, static_cast<GouraudTraits<>*>(nullptr)), Fault::shader_missing);
  EXPECT_EQ(status(material, plain, static_cast<TextureTraits<>*>(nullptr)), Fault::shader_missing);
  EXPECT_EQ(status(material, plain, static_cast<GeneralTraits<>*>(nullptr)), Fault::none);
  material.specular = {9, 9, 9};
  EXPECT_EQ(status(material, plain, static_cast<GeneralTraits<>*>(nullptr)), Fault::shader_missing);
}

}  // namespace
}  // namespace spanline::test
