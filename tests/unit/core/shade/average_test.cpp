// Several samples a pixel: their mean, and stochastic transparency, which comes nearer to blending as samples are
// added.
#include "spanline/finish/average_samples.hpp"
#include "spanline/model/cull.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "spanline/pixel/premultiplied.hpp"
#include "support/random.hpp"
#include "support/ready_made_studios.hpp"

namespace spanline::test {
namespace {

std::array<unsigned, 3> split(unsigned rgb565) { return {rgb565 >> 11, (rgb565 >> 5) & 63, rgb565 & 31}; }

template <class Format>
void check_bands(unsigned factor) {
  Random random(factor);
  for (std::size_t width = 1; width < 9; ++width)
    for (std::size_t lines = 1; lines < 4; ++lines) {
      std::vector<std::uint16_t> band(width * lines * factor * factor);
      for (auto& sample : band)
        sample = static_cast<std::uint16_t>(random.between(0, 3) == 0 ? 0xffff : random.between(0, 65535));
      const std::vector<std::uint16_t> samples = band;
      average_samples<Format>(band.data(), width, lines, factor);
      for (std::size_t y = 0; y < lines; ++y)
        for (std::size_t x = 0; x < width; ++x) {
          std::array<unsigned, 3> sum{};
          for (std::size_t v = 0; v < factor; ++v)
            for (std::size_t u = 0; u < factor; ++u) {
              const auto sample =
                  split(Format::from_rgb565(samples[(y * factor + v) * width * factor + x * factor + u]));
              for (std::size_t c = 0; c < 3; ++c) sum[c] += sample[c];
            }
          for (unsigned& c : sum) c = (2 * c + factor * factor) / (2 * factor * factor);
          ASSERT_EQ(split(Format::from_rgb565(band[y * width + x])), sum) << factor;
        }
    }
}

TEST(Average, BandsOfSamplesBecomeTheirMeansInPlace) {
  check_bands<Rgb565>(2);
  check_bands<Rgb565>(4);
  check_bands<Rgb565Swapped>(4);
}

TEST(Average, EightSamplesOfFullWhiteAreWhite) { EXPECT_EQ(sample_mean(8 * spread_565::from(0xffff), 3), 0xffff); }

/// Root of the mean squared error, in steps of a channel of 5 bits, of a stack of layers drawn with factor² samples
/// against blending.
double error_against_blending(unsigned factor, unsigned seed) {
  constexpr std::uint16_t size = 64;
  using Traits = RendererTraits<Rgb565, ShaderList<FlatShader<Rgb565>, SeeThroughShader<Rgb565, FlatShader<Rgb565>>>>;
  const std::array<std::uint16_t, 4> colours{0x001f, 0xf800, 0x07e0, 0xffff};
  const std::array<std::uint8_t, 4> opacities{255, 102, 153, 64};
  Capacity capacity;
  capacity.width = capacity.height = static_cast<std::uint16_t>(size * factor);
  capacity.band_lines = capacity.height;
  capacity.colour_bands = 1;
  capacity.instances = capacity.polygons = 4;
  Studio<Traits> studio(capacity);
  std::array<double, 3> want{};
  std::vector<std::vector<ScreenVertex>> layers;
  FrameSettings settings;
  settings.cull = Cull::none;
  settings.stipple_seed = static_cast<std::uint8_t>(seed);
  studio.begin(settings);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto z = static_cast<std::int32_t>(4000 - 100 * i);
    const Corners over_all{Corner{-160, -160, z}, Corner{9000, -160, z}, Corner{-160, 9000, z}};
    layers.push_back(vertices_of(std::array<Corners, 1>{over_all}, 16, capacity.width, capacity.height));
    Material material;
    material.opacity = opacities[i];
    material.transparency = Transparency::stochastic;
    studio.add_screen(layers.back(), {&colours[i], 1}, material);
    const auto colour = split(colours[i]);
    for (std::size_t c = 0; c < 3; ++c)
      want[c] += (colour[c] * (c == 1 ? 31 / 63.0 : 1) - want[c]) * std::round(opacities[i] / 255.0 * 64) / 64;
  }
  auto picture = studio.draw();
  EXPECT_TRUE(studio.status().ok());
  average_samples<Rgb565>(picture.pixels.data(), size, size, factor);
  double sum = 0;
  for (std::size_t i = 0; i < std::size_t{size} * size; ++i) {
    const auto got = split(picture.pixels[i]);
    for (std::size_t c = 0; c < 3; ++c) sum += std::pow(got[c] * (c == 1 ? 31 / 63.0 : 1) - want[c], 2);
  }
  return std::sqrt(sum / (3.0 * size * size));
}

TEST(Average, StochasticTransparencysErrorFallsByTheRootOfTheSamples) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    const double four = error_against_blending(2, seed), sixteen = error_against_blending(4, seed);
    EXPECT_LT(four, 8);  // of 31 steps: a layer's share of 4 samples has a deviation of up to a quarter
    EXPECT_GT(four, 3);
    EXPECT_NEAR(sixteen / four, 0.5, 0.05);
  }
}

}  // namespace
}  // namespace spanline::test
