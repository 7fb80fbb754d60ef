#include "image/texture_image.hpp"

#include <bit>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/failure.hpp"
#include "image/png.hpp"
#include "spanline/shade/pixel_format.hpp"

namespace spanline::sim {
namespace {

/// More than any PNG of 2048 × 2048 pixels takes.
constexpr std::uintmax_t greatest_file = std::uintmax_t{64} << 20;

std::vector<std::byte> read_bytes(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) throw file_failure(path, "is no file that can be read");
  if (std::filesystem::file_size(path, error) > greatest_file) throw file_failure(path, "is too large for a texture");
  std::ifstream file(path, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  if (!file) throw file_failure(path, "cannot be read");
  const auto* data = reinterpret_cast<const std::byte*>(bytes.data());
  return {data, data + bytes.size()};
}

Picture read_picture(const std::string& path) {
  const std::vector<std::byte> bytes = read_bytes(path);
  try {
    return decode_png(bytes);
  } catch (const Failure& failure) {
    throw file_failure(path, failure.what());
  }
}

}  // namespace

Texture TextureImage::view() const {
  Texture texture;
  texture.log2_width = static_cast<std::uint8_t>(log2_width);
  texture.log2_height = static_cast<std::uint8_t>(log2_height);
  texture.words = words;
  return texture;
}

TextureImage read_texture(const std::string& path) {
  const Picture picture = read_picture(path);
  const auto width = static_cast<unsigned>(picture.width), height = static_cast<unsigned>(picture.height);
  const std::string size = std::to_string(width) + "x" + std::to_string(height);
  if (!std::has_single_bit(width) || !std::has_single_bit(height))
    throw file_failure(path, "is " + size + "; the sides of a texture are powers of two");
  TextureImage image{
      static_cast<unsigned>(std::countr_zero(width)), static_cast<unsigned>(std::countr_zero(height)), {}};
  for (const Rgb888 colour : picture.pixels) image.words.push_back(Rgb565::from(colour));
  if (const TextureFault fault = validate(image.view()); fault != TextureFault::none)
    throw file_failure(path, "is " + size + "; a texture is not " + to_string(fault));
  return image;
}

}  // namespace spanline::sim
