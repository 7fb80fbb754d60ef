// The shader for everything against formulas in floating point: fog, dither, mip levels, filters and texture functions.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "shade/shading_scene.hpp"
#include "shade/wall_picture.hpp"
#include "spanline/frame/ready_made_traits.hpp"
#include "spanline/model/texel_reader.hpp"
#include "support/effort.hpp"

namespace spanline::test {
namespace {

template <class Depth = Depth16<>, class Visibility = ZBuffer>
using GeneralAlone = RendererTraits<
    Rgb565, ShaderList<FlatShader<Rgb565>, GouraudShader<Rgb565>, GouraudColourShader<Rgb565>, GeneralShader<Rgb565>>,
    Depth, Visibility>;

constexpr std::array<TexelFormat, 5> formats{TexelFormat::rgb565, TexelFormat::rgb565_cutout, TexelFormat::argb4444,
                                             TexelFormat::palette16, TexelFormat::palette256};

TEST(GeneralShader, ReplacingByNearestTexelsIsWhatTheFastShadersDoButForTheLastBitsOfCoordinates) {
  Random random(41);
  const OwnTexture own(random, TexelFormat::rgb565, 6, 6);
  Material material{.texturing = {.texture = &own.texture, .function = TextureFunction::replace}};
  const auto fast = wall<TextureTraits<>>(material, scenes::textured_wall::settings());
  const auto general = wall<GeneralAlone<>>(material, scenes::textured_wall::settings());
  int different = 0;
  for (std::size_t i = 0; i < fast.pixels.size(); ++i) different += fast.pixels[i] != general.pixels[i];
  EXPECT_LE(different, 76800 / 1000);
}

TEST(GeneralShader, EveryFormatShowsItsTexelsRepeatedOrClamped) {
  Random random(42);
  for (const TexelFormat format : formats)
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
      OwnTexture own(random, format, 4, 3);
      own.texture.wrap_s = wrap;
      Material material{.texturing = {.texture = &own.texture, .function = TextureFunction::replace}};
      material.texture_matrix.ss = Q16_16::from_int(3);
      material.texture_matrix.s0 = Q16_16::from_int(-1);
      const auto picture = wall<GeneralAlone<>>(material, scenes::textured_wall::settings());
      int wrong = 0;
      for (int y = 0; y < 240; ++y)
        for (int x = 0; x < 320; ++x) {
          const auto [s, t] = wall_point(x, y);
          int column = static_cast<int>(std::floor((3 * s - 1) * 16)), row = static_cast<int>(std::floor(t * 8)) & 7;
          column = wrap == Wrap::repeat ? column & 15 : std::clamp(column, 0, 15);
          const Texel texel =
              read_texel(own.texture, static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row));
          wrong += picture.pixels[picture.at(x, y)] != (texel.alpha >= 8 ? texel.rgb565 : 0);
        }
      EXPECT_LE(wrong, 76800 * 3 / 1000) << static_cast<int>(format);
    }
}

TEST(GeneralShader, ClampedTexturesDoNotAppearAgainFarBeyondTheirEdges) {
  Random random(48);
  OwnTexture own(random, TexelFormat::rgb565, Texture::max_log2_size, 0);
  own.texture.wrap_s = Wrap::clamp;
  const std::uint16_t first = own.words.front(), last = own.words.back();
  for (const int scale : {20, 400, 2000})
    for (const TextureFilter filter : {TextureFilter::nearest, TextureFilter::bilinear})
      for (const TextureMapping mapping : {TextureMapping::perspective, TextureMapping::affine}) {
        Material material{
            .texturing = {
                .texture = &own.texture, .function = TextureFunction::replace, .filter = filter, .mapping = mapping}};
        material.texture_matrix.ss = Q16_16::from_int(scale);
        material.texture_matrix.s0 = Q16_16::from_int(-scale / 2);
        const auto picture = wall<GeneralAlone<>>(material, scenes::textured_wall::settings());
        // The texture itself is a few columns wide. Affine planes have it elsewhere, and on a slope.
        const double wide = 1 + scale / 60.0;
        int others = 0;
        for (int y = 0; y < 240; ++y)
          for (int x = 0; x < 320; ++x) {
            const std::uint16_t shown = picture.pixels[picture.at(x, y)];
            others += shown != first && shown != last;
            if (mapping == TextureMapping::affine) continue;
            const double s = scale * (wall_point(x, y)[0] - 0.5);
            if (s < -wide) {
              ASSERT_EQ(shown, first) << scale << ": " << x << ", " << y;
            }
            if (s > wide) {
              ASSERT_EQ(shown, last) << scale << ": " << x << ", " << y;
            }
          }
        EXPECT_LE(others, 240 * (4 + 700 / scale)) << scale;
      }
}

TEST(GeneralShader, BilinearTexelsAtTheEndOfWordsDoNotOverflow) {
  Random random(49);
  const OwnTexture own(random, TexelFormat::rgb565, Texture::max_log2_size, 0);
  // All pixels are at s = −16 textures, −2^31 in words of 16.16 texels, and so between the last texel and the first.
  Material material{
      .texturing = {.texture = &own.texture, .function = TextureFunction::replace, .filter = TextureFilter::bilinear}};
  material.texture_matrix.ss = {};
  material.texture_matrix.s0 = Q16_16::from_int(-16);
  const auto at_end = wall<GeneralAlone<>>(material, scenes::textured_wall::settings());
  material.texture_matrix.s0 = {};
  const auto at_zero = wall<GeneralAlone<>>(material, scenes::textured_wall::settings());
  EXPECT_EQ(at_end.pixels, at_zero.pixels);
}

TEST(GeneralShader, FogThickensWithTheDistanceAlongTheAxisOfView) {
  FrameSettings settings = scenes::textured_wall::settings();
  const Material black{.colour = {0, 0, 0}};
  for (const FogCurve curve : {FogCurve::linear, FogCurve::exponential}) {
    const WallFog fog(curve);
    settings.fog = fog.fog;
    for (const auto& picture : {wall<GeneralTraits<>>(black, settings).pixels,
                                wall<GeneralTraits<Rgb565, Depth24<>>>(black, settings).pixels}) {
      double worst = 0;
      for (int y = 0; y < 240; ++y)
        for (int x = 0; x < 320; ++x) {
          const double shown = Channels(picture[static_cast<std::size_t>(y * 320 + x)]).green / 63.0;
          const double off = std::abs(shown - fog.share(x));
          worst = std::max(worst, off / fog.allowed(x));
          ASSERT_LE(off, fog.allowed(x)) << x << ", " << y;
        }
      std::printf("fog is off by at most %.2f of what is allowed\n", worst);
    }
  }
}

TEST(GeneralShader, TheMeanOfTheDitherIsTheColour) {
  Random random(44);
  FrameSettings settings = scenes::textured_wall::settings();
  settings.dither = true;
  for (int i = 0; i < rounds(30); ++i) {
    const Rgb888 colour = random_colour(random);
    const auto picture = wall<GeneralTraits<>>({.colour = colour}, settings);
    expect_mean_of_dither(picture, colour);
  }
}

TEST(GeneralShader, MipLevelsFollowTheDensityOfTexels) {
  Random random(45);
  OwnTexture own(random, TexelFormat::rgb565, 9, 9, true);
  for (unsigned level = 0; level < own.texture.levels; ++level)
    for (std::size_t i = 0; i < own.texture.level_size(level); ++i)
      own.words[own.texture.offset_of(level) + i] = static_cast<std::uint16_t>(level + 1);
  FrameSettings settings = scenes::textured_wall::settings();
  for (const int scale : {1, 2, 5, 20, 200}) {
    Material material{
        .texturing = {.texture = &own.texture, .function = TextureFunction::replace, .mip_mapping = MipMapping::span}};
    material.texture_matrix.ss = material.texture_matrix.tt = Q16_16::from_int(scale);
    const auto picture = wall<GeneralTraits<>>(material, settings);
    EXPECT_EQ(wall<GeneralAlone<>>(material, settings).pixels, picture.pixels);
    material.texturing.filter = TextureFilter::bilinear;
    EXPECT_EQ(wall<GeneralTraits<>>(material, settings).pixels, picture.pixels);
    for (int y = 0; y < 240; ++y)
      for (int x = 0; x < 320; ++x) {
        // Texels a pixel each way: 128·scale a unit of the wall; the wall's area a pixel grows with z³.
        const double z = wall_distance((x & ~15) + 8), along = 512.0 * scale / 4 * z * z / 3 / 320;
        const double across = 512.0 * scale * (1.0 / 6 + (z - 2) / 4 / 3) / 0.375 / 320;
        const double wanted = std::clamp(std::log2(along * across) / 2, 0.0, 9.0);
        const int level = picture.pixels[picture.at(x, y)] - 1;
        ASSERT_LE(std::abs(level - wanted), 0.5 + 0.06) << "scale " << scale << " at " << x << ", " << y;
      }
    // A level a polygon: one of those that its groups of columns show.
    material.texturing.mip_mapping = MipMapping::polygon;
    const auto by_polygon = wall<GeneralTraits<>>(material, settings);
    for (const std::size_t at : {by_polygon.at(10, 120), by_polygon.at(300, 100)})
      EXPECT_NEAR(by_polygon.pixels[at], picture.pixels[at], 2) << scale;
  }
}

TEST(GeneralShader, TextureFunctionsFollowTheirFormulas) {
  Random random(46);
  for (int i = 0; i < rounds(40); ++i) {
    OwnTexture own(random, TexelFormat::argb4444, 0, 0);
    const Texel texel = read_texel(own.texture, 0, 0);
    const Rgb888 surface = random_colour(random), blend = random_colour(random);
    const double ct = Channels(texel.rgb565).green / 63.0, cf = surface.green / 255.0, alpha = texel.alpha / 15.0;
    const std::array<std::pair<TextureFunction, double>, 4> functions{
        {{TextureFunction::modulate, ct * cf},
         {TextureFunction::replace, ct},
         {TextureFunction::decal, ct * alpha + cf * (1 - alpha)},
         {TextureFunction::blend, cf * (1 - ct) + blend.green / 255.0 * ct}}};
    for (const auto& [function, wanted] : functions) {
      const Material material{.colour = surface,
                              .texturing = {.texture = &own.texture, .function = function, .blend_colour = blend}};
      const auto picture = wall<GeneralTraits<>>(material, scenes::textured_wall::settings());
      const bool there = function == TextureFunction::decal || texel.alpha >= 8;
      EXPECT_NEAR(Channels(picture.pixels[picture.at(100, 120)]).green / 63.0, there ? wanted : 0, 0.5 / 63 + 0.006)
          << static_cast<int>(function);
    }
  }
}

TEST(GeneralShader, BandsAndSpansDrawTheSameBytes) {
  Random random(47);
  for (int i = 0; i < rounds(40); ++i) {
    const TexelFormat format = formats[random.chance(2) ? 0 : static_cast<std::size_t>(3 + random.between(0, 1))];
    OwnTexture own(random, format, 5, 4, random.chance(2));
    if (random.chance(2)) own.texture.wrap_t = Wrap::clamp;
    ShadedInstance shaded(random);
    add_effects(random, shaded.settings);
    Material material{.colour = random_colour(random)};
    if (random.chance(2)) material.shading = ShadingMode::gouraud;
    if (!random.chance(4)) material.texturing.texture = &own.texture;
    material.texturing.function = static_cast<TextureFunction>(random.between(0, 3));
    material.texturing.mip_mapping = static_cast<MipMapping>(random.between(0, 2));
    if (random.chance(2)) material.texturing.filter = TextureFilter::bilinear;
    if (random.chance(3)) material.texturing.coordinates = TextureCoordinates::sphere_map;
    using ByBuffer = GeneralTraits<Rgb565, Depth24<>>;
    using BySpans = GeneralTraits<Rgb565, Depth24<>, Spanning>;
    expect_alike_in_bands_and_spans<ByBuffer, BySpans>(shaded.instance, shaded.settings, material);
    ASSERT_FALSE(HasFailure()) << "round " << i;
  }
}

}  // namespace
}  // namespace spanline::test
