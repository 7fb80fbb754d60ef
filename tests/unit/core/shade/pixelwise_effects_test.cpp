// Fog, dither, highlights and transparency on surfaces that are worked out pixel by pixel: solids, and those under
// relief.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "shade/shading_scene.hpp"
#include "shade/wall_picture.hpp"
#include "support/effort.hpp"
#include "support/one_coloured.hpp"

namespace spanline::test {
namespace {

/// Relief and solids, opaque and see-through.
using PixelwiseTraits = RendererTraits<
    Rgb565, ShaderList<ReliefShader<Rgb565>, VolumeShader<Rgb565>, SeeThroughShader<Rgb565, ReliefShader<Rgb565>>,
                       SeeThroughShader<Rgb565, VolumeShader<Rgb565>>>>;

/// One colour all over, as a solid and as a relief without heights.
struct Surfaces {
  OneColouredSolid solid;
  std::array<std::uint8_t, 1> height{128};
  HeightMap heights{0, 0, height};
  std::array<Material, 2> materials{};

  explicit Surfaces(std::uint16_t rgb565) : solid(rgb565) {
    materials[0].volume = solid.volume();
    materials[1].colour = widened(rgb565);
    materials[1].relief.heights = &heights;
  }
};

FrameSettings lit_wall() {
  FrameSettings settings = scenes::textured_wall::settings();
  settings.lighting.ambient = Fixed<16>::from_int(1);
  return settings;
}

TEST(PixelwiseShader, FogThickensWithTheDistance) {
  const Surfaces black(0);
  for (const FogCurve curve : {FogCurve::linear, FogCurve::exponential}) {
    const WallFog fog(curve);
    FrameSettings settings = lit_wall();
    settings.fog = fog.fog;
    for (const Material& material : black.materials) {
      const auto picture = wall<PixelwiseTraits>(material, settings);
      for (int y = 0; y < 240; ++y)
        for (int x = 0; x < 320; ++x) {
          const double shown = Channels(picture.pixels[picture.at(x, y)]).green / 63.0;
          ASSERT_LE(std::abs(shown - fog.share(x)), fog.allowed(x)) << x << ", " << y;
        }
    }
  }
}

TEST(PixelwiseShader, TheMeanOfTheDitherIsTheColour) {
  Random random(81);
  FrameSettings settings = lit_wall();
  settings.dither = true;
  for (int i = 0; i < rounds(20); ++i) {
    const auto rgb565 = static_cast<std::uint16_t>(random.between(0, 65535));
    const Surfaces surfaces(rgb565);
    const Rgb888 wanted = widened(rgb565);
    for (const Material& material : surfaces.materials) {
      const auto picture = wall<PixelwiseTraits>(material, settings);
      expect_mean_of_dither(picture, wanted);
    }
  }
}

TEST(PixelwiseShader, BlendsOverWhatLiesBehind) {
  Random random(82);
  for (int i = 0; i < rounds(20); ++i) {
    const Surfaces surfaces(static_cast<std::uint16_t>(random.between(0, 65535)));
    FrameSettings settings = lit_wall();
    settings.background = random_colour(random);
    settings.fog = WallFog(FogCurve::linear).fog;
    const Channels below(Rgb565::from(settings.background));
    for (Material material : surfaces.materials) {
      const auto opaque = wall<PixelwiseTraits>(material, settings);
      material.opacity = static_cast<std::uint8_t>(random.between(0, 250));
      const double alpha = std::round(material.opacity * 32 / 255.0) / 32;
      const auto seen_through = wall<PixelwiseTraits>(material, settings);
      for (std::size_t p = 0; p < opaque.pixels.size(); p += 7) {
        const Channels above(opaque.pixels[p]), got(seen_through.pixels[p]);
        ASSERT_NEAR(got.red, above.red * alpha + below.red * (1 - alpha), 1) << p;
        ASSERT_NEAR(got.green, above.green * alpha + below.green * (1 - alpha), 1) << p;
        ASSERT_NEAR(got.blue, above.blue * alpha + below.blue * (1 - alpha), 1) << p;
      }
    }
  }
}

TEST(PixelwiseShader, PatternsLeaveOutTheirShareOfThePixels) {
  const Surfaces surfaces(0xf81f);
  FrameSettings settings = lit_wall();
  settings.background = {0, 255, 0};
  for (const Transparency transparency : {Transparency::screen_door, Transparency::stochastic})
    for (const std::uint8_t opacity : std::array<std::uint8_t, 3>{60, 128, 200})
      for (Material material : surfaces.materials) {
        material.opacity = opacity;
        material.transparency = transparency;
        const auto picture = wall<PixelwiseTraits>(material, settings);
        int there = 0;
        for (const std::uint16_t pixel : picture.pixels) {
          ASSERT_TRUE(pixel == 0xf81f || pixel == 0x07e0);
          there += pixel == 0xf81f;
        }
        EXPECT_NEAR(there / 76800.0, opacity / 255.0, 0.01);
      }
}

}  // namespace
}  // namespace spanline::test
