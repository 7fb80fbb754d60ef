#pragma once
#include <cstdint>
#include <type_traits>

#include "spanline/model/material.hpp"
#include "spanline/pixel/pixel_format.hpp"

namespace spanline {

/// The table of one mip level and its index masks.
struct TexelLevel {
  const std::uint16_t* words;
  const std::uint8_t* bytes;
  const std::uint16_t* palette;
  std::uint32_t mask_u, mask_v;  ///< width − 1; (height − 1) · width

  [[nodiscard]] static TexelLevel of(const Texture& texture, unsigned level) {
    const std::size_t offset = texture.offset_of(level);
    const unsigned log2_width = texture.log2_width_of(level);
    return {texture.words.empty() ? nullptr : texture.words.data() + offset,
            texture.bytes.empty() ? nullptr : texture.bytes.data() + offset, texture.palette.data(),
            (1u << log2_width) - 1, ((1u << texture.log2_height_of(level)) - 1) << log2_width};
  }
};

/// Reads the nearest texels of a texture that repeats both ways. u has 16 fraction bits. v has 12 + log2 of the width,
/// so that its integer part lands on the table's row bits.
template <TexelFormat Format>
struct NearestTexels {
  static constexpr TextureFilter filter = TextureFilter::nearest;
  static constexpr bool has_levels = false;
  static constexpr bool has_holes = Format == TexelFormat::rgb565_cutout;
  static constexpr int fraction_u = 16;
  [[nodiscard]] static constexpr int fraction_v(unsigned log2_width) { return 12 + static_cast<int>(log2_width); }

  static_assert(Format != TexelFormat::palette16 && Format != TexelFormat::argb4444, "read by the general shader");
  static constexpr bool in_bytes = Format == TexelFormat::palette256;

  std::conditional_t<in_bytes, const std::uint8_t*, const std::uint16_t*> table;
  const std::uint16_t* palette;
  std::uint32_t mask_u, mask_v;

  [[nodiscard]] static bool serves(const Texture& texture) {
    return texture.format == Format && texture.wrap_s == Wrap::repeat && texture.wrap_t == Wrap::repeat;
  }
  [[nodiscard]] static NearestTexels of(const TexelLevel& level) {
    if constexpr (in_bytes)
      return {level.bytes, level.palette, level.mask_u, level.mask_v};
    else
      return {level.words, level.palette, level.mask_u, level.mask_v};
  }
  /// The RGB565 colour at (u, v).
  [[nodiscard]] std::uint32_t at(std::uint32_t u, std::uint32_t v) const {
    const std::uint32_t texel = table[((u >> 16) & mask_u) + ((v >> 12) & mask_v)];
    return in_bytes ? palette[texel] : texel;
  }
  [[nodiscard]] static bool present(std::uint32_t texel) {
    return Format != TexelFormat::rgb565_cutout || (texel & 0x20) != 0;
  }
};

}  // namespace spanline
