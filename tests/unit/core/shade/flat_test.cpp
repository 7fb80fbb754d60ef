// Flat shading against the formula in floating point: at most one step of a 5- or 6-bit channel off.
#include <gtest/gtest.h>

#include "shade/shading_scene.hpp"
#include "support/effort.hpp"

namespace spanline::test {
namespace {

double greatest_difference(std::uint16_t pixel, Rgb888 colour, double light) {
  const Channels got(pixel);
  return std::max({std::fabs(got.red - colour.red * light * 31 / 255),
                   std::fabs(got.green - colour.green * light * 63 / 255),
                   std::fabs(got.blue - colour.blue * light * 31 / 255)});
}

/// A triangle with a normal, drawn; the middle pixel.
std::uint16_t drawn_pixel(Random& random, const Lighting& lighting, const Rotation& rotation, PackedNormal normal,
                          Rgb888 colour, bool by_polygon) {
  ShadedTriangle t(random);
  t.owned.vertices = {{-512, -512, 0}, {512, -512, 0}, {0, 512, 0}};
  t.owned.fit_bounds();
  t.owned.polygon_normals = {normal};
  if (by_polygon) t.owned.polygon_colours = {colour};
  t.settings.lighting = lighting;
  // The mesh is turned together with the camera, so that it always fills the middle of the picture.
  t.settings.camera.axes = rotation.transposed();
  t.transform.rotation = rotation;
  const Direction ahead = rotation.column(2);
  t.transform.translation = {multiply<Q16_16>(ahead.x, Q16_16::from_int(-100)),
                             multiply<Q16_16>(ahead.y, Q16_16::from_int(-100)),
                             multiply<Q16_16>(ahead.z, Q16_16::from_int(-100))};
  const auto picture = t.draw<Rgb565>({by_polygon ? Rgb888{} : colour, ShadingMode::flat});
  EXPECT_TRUE(picture.drawn(32, 32));
  return picture.pixels[picture.at(32, 32)];
}

TEST(Flat, OneLightIsWithinAStepOfTheFormula) {
  Random random(1);
  double worst = 0;
  for (int i = 0; i < rounds(6000); ++i) {
    const RandomLights lights(random, random.between(0, 4));
    const RealNormal normal = random_normal(random);
    const Rotation rotation = random_rotation(random);
    const Rgb888 colour = random_colour(random);
    const std::uint16_t pixel =
        drawn_pixel(random, lights.lighting(), rotation, normal.packed, colour, random.chance(2));
    const double difference = greatest_difference(pixel, colour, lights.on(normal, rotation));
    ASSERT_LE(difference, 1.0);
    worst = std::max(worst, difference);
  }
  std::printf("flat: %.3f steps at most (0.5 is rounding)\n", worst);
}

TEST(Flat, SumsOfLightsSaturate) {
  Random random(2);
  const std::vector<DirectionalLight> lights(4, DirectionalLight{{{}, {}, Q2_30::from_int(1)}, Fixed<16>::from_int(4)});
  const Lighting lighting{Fixed<16>::from_int(1), lights};
  EXPECT_EQ(drawn_pixel(random, lighting, {}, PackedNormal(0, 0, 511), {255, 255, 255}, false), 0xffff);
  EXPECT_EQ(drawn_pixel(random, lighting, {}, PackedNormal(0, 0, 511), {255, 0, 255}, false), 0xf81f);
  EXPECT_EQ(drawn_pixel(random, lighting, {}, PackedNormal(0, 0, 511), {0, 0, 0}, true), 0);
}

TEST(Flat, LightFromBehindGivesNothing) {
  Random random(3);
  const std::vector<DirectionalLight> lights{{{{}, {}, -Q2_30::from_int(1)}, Fixed<16>::from_int(4)}};
  EXPECT_EQ(drawn_pixel(random, {Fixed<16>{}, lights}, {}, PackedNormal(0, 0, 511), {255, 255, 255}, false), 0);
}

TEST(Flat, WithoutNormalsSurfacesAreFullyLit) {
  Random random(5);
  ShadedTriangle t(random);
  t.owned.vertices = {{-512, -512, 0}, {512, -512, 0}, {0, 512, 0}};
  t.owned.fit_bounds();
  t.settings.lighting = {Fixed<16>{}, {}};
  const auto picture = t.draw<Rgb565>({{255, 255, 255}, ShadingMode::flat});
  EXPECT_EQ(picture.pixels[picture.at(32, 32)], 0xffff);
}

TEST(PixelFormats, EveryColourIsRoundedToItsNearestStep) {
  for (int c = 0; c < 256; ++c) {
    const auto byte = static_cast<std::uint8_t>(c);
    const Channels got(Rgb565::from({byte, byte, byte}));
    ASSERT_LE(std::fabs(got.red - c * 31 / 255.0), 0.52) << c;
    ASSERT_LE(std::fabs(got.green - c * 63 / 255.0), 0.52) << c;
    ASSERT_EQ(got.red, got.blue) << c;
  }
  EXPECT_EQ(Rgb565::from({255, 255, 255}), 0xffff);
}

TEST(PixelFormats, TheSwappedFormatHasTheSamePixelsWithTheirBytesExchanged) {
  Random random(6);
  for (int i = 0; i < rounds(300); ++i) {
    ShadedTriangle t(random);
    const RandomLights lights(random, 2);
    t.settings.lighting = lights.lighting();
    t.settings.background = random_colour(random);
    t.owned.vertex_normals = {random_normal(random).packed, random_normal(random).packed, random_normal(random).packed};
    t.owned.polygon_normals = {random_normal(random).packed};
    if (random.chance(2))
      t.owned.vertex_colours = {random_colour(random), random_colour(random), random_colour(random)};
    const Material material{random_colour(random), random.chance(2) ? ShadingMode::flat : ShadingMode::gouraud};
    const auto plain = t.draw<Rgb565>(material);
    const auto swapped = t.draw<Rgb565Swapped>(material);
    ASSERT_EQ(plain.depth, swapped.depth);
    for (std::size_t p = 0; p < plain.pixels.size(); ++p)
      ASSERT_EQ(swapped.pixels[p], static_cast<std::uint16_t>(plain.pixels[p] << 8 | plain.pixels[p] >> 8));
  }
}

}  // namespace
}  // namespace spanline::test
