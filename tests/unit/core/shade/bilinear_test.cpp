// Bilinear filtering by the shader for everything and by the fast ones, against the mean of four texels.
#include <gtest/gtest.h>

#include <cmath>

#include "shade/shading_scene.hpp"
#include "shade/wall_picture.hpp"
#include "spanline/model/texel_reader.hpp"
#include "support/effort.hpp"

namespace spanline::test {
namespace {

template <class Shader, class Depth = Depth24<>, class Visibility = ZBuffer>
using Alone = RendererTraits<Rgb565, ShaderList<FlatShader<Rgb565>, GouraudShader<Rgb565>, Shader>, Depth, Visibility>;
using Fast = MipTextureShader<Rgb565, TextureFilter::bilinear, NoTexelLight>;

/// The mean of the four texels around a point of the texture, in steps of RGB565's channels.
struct Mean {
  double red = 0, green = 0, blue = 0;

  Mean(const Texture& texture, double s, double t) {
    const int width = 1 << texture.log2_width, height = 1 << texture.log2_height;
    const double u = s * width - 0.5, v = t * height - 0.5, right = u - std::floor(u), down = v - std::floor(v);
    for (int i = 0; i < 4; ++i) {
      const int column = static_cast<int>(std::floor(u)) + i % 2, row = static_cast<int>(std::floor(v)) + i / 2;
      const Channels texel(read_texel(texture, word(column & (width - 1)), word(row & (height - 1))).rgb565);
      const double weight = (i % 2 != 0 ? right : 1 - right) * (i / 2 != 0 ? down : 1 - down);
      red += texel.red * weight;
      green += texel.green * weight;
      blue += texel.blue * weight;
    }
  }
};

/// How far off a wall's picture is at most, red or blue and green.
template <class Shader>
std::array<double, 2> worst_of(const Texture& texture) {
  const Material material{
      .texturing = {.texture = &texture, .function = TextureFunction::replace, .filter = TextureFilter::bilinear}};
  const auto picture = wall<Alone<Shader>>(material, scenes::textured_wall::settings());
  std::array<double, 2> worst{};
  for (int y = 0; y < 240; ++y)
    for (int x = 0; x < 320; ++x) {
      const auto [s, t] = wall_point(x, y);
      const Mean wanted(texture, s, t);
      const Channels shown(picture.pixels[picture.at(x, y)]);
      worst[0] = std::max({worst[0], std::abs(shown.red - wanted.red), std::abs(shown.blue - wanted.blue)});
      worst[1] = std::max(worst[1], std::abs(shown.green - wanted.green));
    }
  return worst;
}

TEST(Bilinear, PixelsAreTheMeanOfFourTexels) {
  Random random(43);
  const OwnTexture small(random, TexelFormat::rgb565, 3, 3), long_one(random, TexelFormat::rgb565, 4, 1);
  for (const OwnTexture* own : {&small, &long_one}) {
    // Half a step of the pixel, a hundredth of a texel, and the rounding of weights and channels.
    const auto [red, green] = worst_of<GeneralShader<Rgb565>>(own->texture);
    EXPECT_LE(red, 0.5 + 0.7);
    EXPECT_LE(green, 0.5 + 1.2);
    // Distances and weights are 32nds there: each is off by a 64th of what two texels differ.
    const auto [fast_red, fast_green] = worst_of<Fast>(own->texture);
    EXPECT_LE(fast_red, 0.5 + 3 * 31 / 64.0);
    EXPECT_LE(fast_green, 0.5 + 3 * 63 / 64.0);
    std::printf("bilinear: off by at most %.2f and %.2f steps, fast %.2f and %.2f\n", red, green, fast_red, fast_green);
  }
}

TEST(Bilinear, WhereTexelsAreAlikePixelsAreTexels) {
  Random random(44);
  for (int i = 0; i < rounds(20); ++i) {
    OwnTexture own(random, TexelFormat::rgb565, 3, 2);
    std::fill(own.words.begin(), own.words.end(), own.words.front());
    const auto [red, green] = worst_of<Fast>(own.texture);
    EXPECT_NEAR(red, 0, 1e-9);
    EXPECT_NEAR(green, 0, 1e-9);
  }
}

TEST(Bilinear, MipMapsAreFilteredAsTheGeneralShaderDoes) {
  Random random(46);
  const OwnTexture own(random, TexelFormat::rgb565, 6, 5, true);
  for (const MipMapping mapping : {MipMapping::polygon, MipMapping::span})
    for (const int scale : {1, 3, 9, 40}) {
      Material material{.texturing = {.texture = &own.texture,
                                      .function = TextureFunction::replace,
                                      .filter = TextureFilter::bilinear,
                                      .mip_mapping = mapping}};
      material.texture_matrix.ss = material.texture_matrix.tt = Q16_16::from_int(scale);
      const auto fast = wall<Alone<Fast>>(material, scenes::textured_wall::settings());
      const auto general = wall<Alone<GeneralShader<Rgb565>>>(material, scenes::textured_wall::settings());
      for (std::size_t p = 0; p < fast.pixels.size(); ++p) {
        const Channels a(fast.pixels[p]), b(general.pixels[p]);
        ASSERT_LE(std::abs(a.red - b.red), 2) << p;
        ASSERT_LE(std::abs(a.green - b.green), 3) << p;
        ASSERT_LE(std::abs(a.blue - b.blue), 2) << p;
      }
    }
}

TEST(Bilinear, BandsAndSpansDrawTheSameBytes) {
  Random random(45);
  for (int i = 0; i < rounds(24); ++i) {
    const OwnTexture own(random, TexelFormat::rgb565, static_cast<unsigned>(random.between(0, 6)),
                         static_cast<unsigned>(random.between(0, 6)), true);
    const ShadedInstance shaded(random);
    Material material{.colour = {255, 255, 255},
                      .shading = ShadingMode::gouraud,
                      .texturing = {.texture = &own.texture, .filter = TextureFilter::bilinear}};
    material.texturing.mip_mapping = static_cast<MipMapping>(random.between(0, 2));
    using Lit = MipTextureShader<Rgb565, TextureFilter::bilinear, GouraudTexelLight>;
    expect_alike_in_bands_and_spans<Alone<Lit>, Alone<Lit, Depth24<>, Spanning>>(shaded.instance, shaded.settings,
                                                                                 material);
    ASSERT_FALSE(HasFailure()) << "round " << i;
  }
}

}  // namespace
}  // namespace spanline::test
