// Images on their way to textures: what files hold, what formats keep of it, and what is refused.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/failure.hpp"
#include "image/palette.hpp"
#include "image/texture_image.hpp"
#include "image_bytes.hpp"
#include "spanline/model/texel_reader.hpp"

namespace spanline::sim::test {
namespace {

ImageRgba gradient(int width, int height, bool with_alpha = false) {
  ImageRgba image{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      image.pixels.push_back({{static_cast<std::uint8_t>(255 * x / width), static_cast<std::uint8_t>(255 * y / height),
                               static_cast<std::uint8_t>(128 + 100 * std::sin(x * 0.1))},
                              static_cast<std::uint8_t>(with_alpha ? (x * 37 + y * 11) % 256 : 255)});
  return image;
}

int distance(Rgb888 a, Rgb888 b) {
  return std::max({std::abs(a.red - b.red), std::abs(a.green - b.green), std::abs(a.blue - b.blue)});
}

Rgb888 widened(std::uint16_t word) {
  const unsigned red = word >> 11, green = (word >> 5) & 63u, blue = word & 31u;
  return {static_cast<std::uint8_t>(red * 255 / 31), static_cast<std::uint8_t>(green * 255 / 63),
          static_cast<std::uint8_t>(blue * 255 / 31)};
}

TEST(Image, PngKeepsEveryPixelAndJpegNearlyAll) {
  const ImageRgba image = gradient(37, 21, true);
  const ImageRgba png = decode_image(png_with_alpha(image));
  EXPECT_EQ(png.width, 37);
  EXPECT_EQ(png.pixels, image.pixels);
  const ImageRgba jpeg = decode_image(jpeg_of(image));
  ASSERT_EQ(jpeg.pixels.size(), image.pixels.size());
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    EXPECT_LE(distance(jpeg.pixels[i].colour, image.pixels[i].colour), 8) << i;
    EXPECT_EQ(jpeg.pixels[i].alpha, 255);
  }
}

TEST(Image, WhatEndsEarlyIsRefusedAndDamageDoesNotCrash) {
  std::mt19937 random(7);
  for (const std::vector<std::byte>& file : {png_with_alpha(gradient(24, 18, true)), jpeg_of(gradient(24, 18))}) {
    for (std::size_t size = 0; size + 1 < file.size(); size += 5) {
      const std::vector<std::byte> cut(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(size));
      EXPECT_THROW(static_cast<void>(decode_image(cut)), Failure) << size << " of " << file.size();
    }
    for (int i = 0; i < 300; ++i) {
      std::vector<std::byte> damaged = file;
      for (int k = 0; k < 3; ++k) damaged[4 + random() % (damaged.size() - 4)] = static_cast<std::byte>(random());
      try {
        const ImageRgba image = decode_image(damaged);
        EXPECT_EQ(image.pixels.size(), static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
      } catch (const Failure& failure) {
        EXPECT_NE(std::string(failure.what()), "");
      }
    }
  }
}

TEST(TextureImage, EveryFormatKeepsWhatItCan) {
  const ImageRgba image = gradient(32, 16, true);
  for (const auto& [format, greatest] : {std::pair{TexelFormat::rgb565, 5},
                                         {TexelFormat::rgb565_cutout, 7},
                                         {TexelFormat::argb4444, 14},
                                         {TexelFormat::palette256, 16},
                                         {TexelFormat::palette16, 80}}) {
    const TextureImage own = make_texture(image, {.format = format});
    const Texture texture = own.view();
    ASSERT_EQ(validate(texture), TextureFault::none);
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 32; ++x) {
        const Texel texel = read_texel(texture, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
        const Rgba8888& pixel = image.at(x, y);
        EXPECT_LE(distance(widened(texel.rgb565), pixel.colour), greatest) << static_cast<int>(format);
        if (format == TexelFormat::rgb565_cutout) {
          EXPECT_EQ(texel.alpha, pixel.alpha >= 128 ? 15 : 0);
        }
        if (format == TexelFormat::argb4444) {
          EXPECT_NEAR(texel.alpha, pixel.alpha / 17.0, 0.51);
        }
      }
  }
}

TEST(TextureImage, FewColoursAreKeptAsTheyAre) {
  ImageRgba image{16, 16, {}};
  for (int i = 0; i < 256; ++i) {
    const auto step = static_cast<std::uint8_t>(i % 13 * 16);
    image.pixels.push_back({{step, static_cast<std::uint8_t>(255 - step), 7}, 255});
  }
  const Palette palette = Palette::of(image, 16);
  EXPECT_EQ(palette.colours().size(), 16U);
  for (const Rgba8888& pixel : image.pixels) EXPECT_EQ(palette.colours()[palette.nearest(pixel.colour)], pixel.colour);
}

TEST(TextureImage, MipLevelsAreMeansDownToOneTexel) {
  ImageRgba image = gradient(16, 4);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i].alpha = i % 3 == 0 ? 0 : 255;
  const TextureImage own = make_texture(image, {.format = TexelFormat::rgb565, .mip_map = true});
  const Texture texture = own.view();
  ASSERT_EQ(validate(texture), TextureFault::none);
  EXPECT_EQ(texture.levels, 5);
  EXPECT_EQ(own.words.size(), 64U + 16 + 4 + 2 + 1);
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 8; ++x) {
      double red = 0, weight = 0;
      for (int k = 0; k < 4; ++k) {
        const Rgba8888& pixel = image.at(2 * x + k % 2, 2 * y + k / 2);
        red += pixel.colour.red * pixel.alpha;
        weight += pixel.alpha;
      }
      const Texel texel =
          read_texel(texture, texture.offset_of(1), 3, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
      EXPECT_NEAR(widened(texel.rgb565).red, red / weight, 5);
    }
}

TEST(TextureImage, SidesThatATextureCannotHaveAreRefusedOrResized) {
  const auto refuse = [](int width, int height) {
    EXPECT_THROW(static_cast<void>(make_texture(
                     {width, height, std::vector<Rgba8888>(static_cast<std::size_t>(width * height))}, {})),
                 Failure);
  };
  refuse(12, 8);
  refuse(4096, 1);
  refuse(2048, 1024);
  const auto size = [](int width, int height) {
    const TextureImage image = make_texture(gradient(width, height), {.resize = true});
    EXPECT_EQ(validate(image.view()), TextureFault::none);
    return std::pair{1 << image.shape.log2_width, 1 << image.shape.log2_height};
  };
  EXPECT_EQ(size(12, 8), (std::pair{16, 8}));
  EXPECT_EQ(size(11, 100), (std::pair{8, 128}));
  EXPECT_EQ(size(4000, 3), (std::pair{2048, 4}));
  EXPECT_EQ(size(2048, 1024), (std::pair{1024, 512}));
  // Resizing keeps the mean.
  const ImageRgba odd = gradient(13, 9);
  const TextureImage resized = make_texture(odd, {.resize = true});
  double before = 0, after = 0;
  for (const Rgba8888& pixel : odd.pixels) before += pixel.colour.red;
  for (const std::uint16_t word : resized.words) after += widened(word).red;
  EXPECT_NEAR(before / static_cast<double>(odd.pixels.size()), after / static_cast<double>(resized.words.size()), 3);
}

}  // namespace
}  // namespace spanline::sim::test
