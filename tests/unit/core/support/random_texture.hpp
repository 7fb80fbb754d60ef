#pragma once
#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "spanline/model/texture.hpp"
#include "support/random.hpp"

namespace spanline::test {

/// A texture that owns its texels.
struct OwnTexture {
  std::vector<std::uint16_t> words, palette;
  std::vector<std::uint8_t> bytes;
  Texture texture;

  OwnTexture() = default;
  OwnTexture(Random& random, TexelFormat format, unsigned log2_width, unsigned log2_height, bool mips = false) {
    texture.format = format;
    texture.log2_width = static_cast<std::uint8_t>(log2_width);
    texture.log2_height = static_cast<std::uint8_t>(log2_height);
    if (mips) texture.levels = static_cast<std::uint8_t>(std::max(log2_width, log2_height) + 1);
    const std::size_t size = texture.offset_of(texture.levels);
    if (texture.has_palette()) {
      for (std::size_t i = 0; i < size; ++i) bytes.push_back(static_cast<std::uint8_t>(random.between(0, 255)));
      for (int i = 0; i < (format == TexelFormat::palette16 ? 16 : 256); ++i)
        palette.push_back(static_cast<std::uint16_t>(random.between(0, 65535)));
    } else {
      for (std::size_t i = 0; i < size; ++i) words.push_back(static_cast<std::uint16_t>(random.between(0, 65535)));
    }
    texture.words = words;
    texture.bytes = bytes;
    texture.palette = palette;
    if (validate(texture) != TextureFault::none) throw std::logic_error("a texture that is not valid");
  }
};

}  // namespace spanline::test
