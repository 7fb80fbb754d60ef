#include "spanline/model/texture.hpp"

#include <algorithm>

namespace spanline {

TextureFault validate(const Texture& texture) {
  if (texture.log2_width > Texture::max_log2_size || texture.log2_height > Texture::max_log2_size ||
      texture.log2_width + texture.log2_height > static_cast<int>(Texture::max_log2_texels))
    return TextureFault::too_large;
  if (texture.levels == 0 || texture.levels > std::max(texture.log2_width, texture.log2_height) + 1)
    return TextureFault::levels;
  const std::size_t size = texture.offset_of(texture.levels);
  const bool fits = texture.has_palette() ? texture.bytes.size() >= size && texture.words.empty()
                                          : texture.words.size() >= size && texture.bytes.empty();
  if (!fits) return TextureFault::texels_count;
  const std::size_t palette = texture.format == TexelFormat::palette16    ? 16
                              : texture.format == TexelFormat::palette256 ? 256
                                                                          : 0;
  return texture.palette.size() == palette ? TextureFault::none : TextureFault::palette_count;
}

const char* to_string(TextureFault fault) {
  switch (fault) {
    case TextureFault::none:
      return "no fault";
    case TextureFault::too_large:
      return "larger than 2048 texels a side or 1048576 in all";
    case TextureFault::levels:
      return "number of levels out of range";
    case TextureFault::texels_count:
      return "texel table does not match the format and size";
    case TextureFault::palette_count:
      return "palette does not match the format";
  }
  return "unknown fault";
}

}  // namespace spanline
