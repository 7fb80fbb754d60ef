#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "image/image_file.hpp"
#include "spanline/model/texture.hpp"

namespace spanline::sim {

/// A texture of the core that owns its texels.
struct TextureImage {
  Texture shape;  ///< without its tables
  std::vector<std::uint16_t> words, palette;
  std::vector<std::uint8_t> bytes;

  /// The texture, good for as long as this lives.
  [[nodiscard]] Texture view() const;
  [[nodiscard]] std::size_t flash_bytes() const { return words.size() * 2 + bytes.size() + palette.size() * 2; }
};

struct TextureOptions {
  TexelFormat format = TexelFormat::rgb565;
  bool mip_map = false;  ///< the whole pyramid
  bool resize = false;   ///< sides that are no powers of two go to the next, and those beyond the limits are halved
};

/// Resizes the image to sides that a texture may have, or throws Failure where `resize` is not set and they are not.
[[nodiscard]] ImageRgba with_allowed_size(ImageRgba image, bool resize);

/// Quantises an image: channels are rounded, palettes chosen by median cut over level 0. A mip level's texel is the
/// mean of the four above it, weighted by their alpha. Throws Failure for sides that a texture cannot have.
[[nodiscard]] TextureImage make_texture(ImageRgba image, const TextureOptions& options);

/// Reads a PNG or JPEG file. Throws Failure that names the file.
[[nodiscard]] TextureImage read_texture(const std::string& path, const TextureOptions& options);

}  // namespace spanline::sim
