#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "spanline/model/texture.hpp"

namespace spanline::sim {

/// A texture of the core that owns its texels.
struct TextureImage {
  unsigned log2_width = 0, log2_height = 0;
  std::vector<std::uint16_t> words;  ///< RGB565

  [[nodiscard]] Texture view() const;
};

/// Reads a PNG file as RGB565, channels rounded. Throws Failure that names the file where it cannot be read, is no PNG,
/// or has sides that a texture cannot have.
[[nodiscard]] TextureImage read_texture(const std::string& path);

}  // namespace spanline::sim
