#pragma once
#include <string>

#include "image/texture_image.hpp"

namespace spanline::sim {

/// The name of a texel format on the command line, as `find_texel_format` takes it.
[[nodiscard]] const char* to_string(TexelFormat format);
/// Throws UsageError.
[[nodiscard]] TexelFormat find_texel_format(const std::string& option, const std::string& name);

/// "repeat" or "clamp". Throws UsageError.
[[nodiscard]] Wrap parse_wrap(const std::string& option, const std::string& name);

/// A freestanding C++ header: constexpr tables and the object `spanline_textures::NAME` of type spanline::Texture.
/// `source` stands in its first comment.
[[nodiscard]] std::string write_texture_header(const TextureImage& texture, const std::string& name,
                                               const std::string& source);

/// Its tables in a namespace NAME_tables, and the object NAME.
[[nodiscard]] std::string texture_definition(const TextureImage& texture, const std::string& name);

/// The tables' bytes in flash, line by line, and their sum; and the RAM, of which a texture takes none.
[[nodiscard]] std::string texture_report(const TextureImage& texture);

}  // namespace spanline::sim
