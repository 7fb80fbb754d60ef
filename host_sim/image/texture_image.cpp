#include "image/texture_image.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/failure.hpp"
#include "image/palette.hpp"
#include "image/resized.hpp"
#include "spanline/pixel/pixel_format.hpp"

namespace spanline::sim {
namespace {

/// The nearest power of two in proportion that a texture may have.
int allowed_side(int side) {
  const double log2 = std::round(std::log2(std::max(1, side)));
  return 1 << static_cast<int>(std::min<double>(log2, Texture::max_log2_size));
}

std::string size_text(const ImageRgba& image) {
  return std::to_string(image.width) + "x" + std::to_string(image.height);
}

std::uint16_t word_of(const Rgba8888& pixel, TexelFormat format) {
  const std::uint16_t rgb565 = Rgb565::from(pixel.colour);
  if (format == TexelFormat::rgb565_cutout)
    return static_cast<std::uint16_t>((rgb565 & ~0x20) | (pixel.alpha >= 128 ? 0x20 : 0));
  if (format != TexelFormat::argb4444) return rgb565;
  const auto four_bits = [](unsigned value) { return (value * 15 + 127) / 255; };
  return static_cast<std::uint16_t>(four_bits(pixel.alpha) << 12 | four_bits(pixel.colour.red) << 8 |
                                    four_bits(pixel.colour.green) << 4 | four_bits(pixel.colour.blue));
}

void append_level(TextureImage& texture, const ImageRgba& level, const Palette& palette) {
  const TexelFormat format = texture.shape.format;
  if (!texture.shape.has_palette()) {
    for (const Rgba8888& pixel : level.pixels) texture.words.push_back(word_of(pixel, format));
    return;
  }
  for (int y = 0; y < level.height; ++y)
    for (int x = 0; x < level.width; ++x) {
      const auto index = static_cast<std::uint8_t>(palette.nearest(level.at(x, y).colour));
      if (format == TexelFormat::palette256 || x % 2 == 0)
        texture.bytes.push_back(index);
      else
        texture.bytes.back() = static_cast<std::uint8_t>(texture.bytes.back() | index << 4);
    }
}

}  // namespace

Texture TextureImage::view() const {
  Texture texture = shape;
  texture.words = words;
  texture.bytes = bytes;
  texture.palette = palette;
  return texture;
}

ImageRgba with_allowed_size(ImageRgba image, bool resize) {
  const auto is_power = [](int side) { return side > 0 && std::has_single_bit(static_cast<unsigned>(side)); };
  if (resize) {
    int width = allowed_side(image.width), height = allowed_side(image.height);
    while (static_cast<long>(width) * height > 1l << Texture::max_log2_texels) {
      width = std::max(1, width / 2);
      height = std::max(1, height / 2);
    }
    if (width != image.width || height != image.height) image = resized(image, width, height);
    return image;
  }
  if (!is_power(image.width) || !is_power(image.height))
    throw Failure("is " + size_text(image) + "; the sides of a texture are powers of two (--resize makes them so)");
  if (image.width > 1 << Texture::max_log2_size || image.height > 1 << Texture::max_log2_size ||
      static_cast<long>(image.width) * image.height > 1l << Texture::max_log2_texels)
    throw Failure("is " + size_text(image) + "; a texture is not " + to_string(TextureFault::too_large) +
                  " (--resize halves it)");
  return image;
}

TextureImage make_texture(ImageRgba image, const TextureOptions& options) {
  image = with_allowed_size(std::move(image), options.resize);
  TextureImage texture;
  texture.shape.format = options.format;
  texture.shape.log2_width = static_cast<std::uint8_t>(std::countr_zero(static_cast<unsigned>(image.width)));
  texture.shape.log2_height = static_cast<std::uint8_t>(std::countr_zero(static_cast<unsigned>(image.height)));
  if (options.mip_map)
    texture.shape.levels = static_cast<std::uint8_t>(std::max(texture.shape.log2_width, texture.shape.log2_height) + 1);
  Palette palette;
  if (texture.shape.has_palette()) {
    palette = Palette::of(image, options.format == TexelFormat::palette16 ? 16 : 256);
    for (const Rgb888 colour : palette.colours()) texture.palette.push_back(Rgb565::from(colour));
  }
  append_level(texture, image, palette);
  for (unsigned level = 1; level < texture.shape.levels; ++level) {
    image = resized(image, std::max(1, image.width / 2), std::max(1, image.height / 2));
    append_level(texture, image, palette);
  }
  return texture;
}

TextureImage read_texture(const std::string& path, const TextureOptions& options) {
  ImageRgba image = read_image(path);
  try {
    return make_texture(std::move(image), options);
  } catch (const Failure& failure) {
    throw file_failure(path, failure.what());
  }
}

}  // namespace spanline::sim
