#pragma once
/// @file
/// Textures. `spanline convert` makes them of image files.
///
/// ```cpp
/// static constexpr std::uint16_t words[] = {0xf800, 0x07e0, 0x001f, 0xffff};  // two by two texels of RGB565
/// constexpr Texture tile{.log2_width = 1, .log2_height = 1, .words = words};
/// if (validate(tile) != TextureFault::none) return;
/// ```
#include <cstddef>
#include <cstdint>
#include <span>

#include "spanline/math/fixed.hpp"

namespace spanline {

/// How texels are stored.
enum class TexelFormat : std::uint8_t {
  rgb565,         ///< a word a texel: red in bits 15…11, green in 10…5, blue in 4…0
  rgb565_cutout,  ///< the same, and bit 5 (the lowest of green) tells whether the texel is drawn
  argb4444,       ///< a word a texel: alpha in bits 15…12, then red, green, blue; drawn from alpha 8 on
  palette16,      ///< four bits a texel, the left one in the low half of a byte, rows of whole bytes
  palette256,     ///< a byte a texel
};

/// What a texture shows beyond its edges, along one axis.
enum class Wrap : std::uint8_t {
  repeat,  ///< the texture repeated
  clamp,   ///< its outermost texels
};

/// A texture as views over read-only tables, usually in flash. It owns nothing; `validate()` checks it once at load.
///
/// Level 0 has 2^log2_width × 2^log2_height texels, row by row from the top. Each further level of a mip pyramid halves
/// both sides, down to 1, and follows the one before it in the same table (lecture 004: a third more memory). Texture
/// coordinates: s to the right and t downwards, 1 is one whole texture, texel centres at (i + ½) / size.
struct Texture {
  static constexpr unsigned max_log2_size = 11;              ///< of a side
  static constexpr unsigned max_log2_texels = 20;            ///< of width and height together
  static constexpr unsigned max_levels = max_log2_size + 1;  ///< of a mip pyramid

  TexelFormat format = TexelFormat::rgb565;  ///< rgb565 by default
  std::uint8_t log2_width = 0;               ///< of level 0: 0 … max_log2_size; 0 by default, a single texel
  std::uint8_t log2_height = 0;            ///< of level 0: 0 … max_log2_size, with the width max_log2_texels at most
  std::uint8_t levels = 1;                 ///< 1, the default: no mip maps; at most down to a single texel
  Wrap wrap_s = Wrap::repeat;              ///< to the left and to the right; repeat by default
  Wrap wrap_t = Wrap::repeat;              ///< above and below; repeat by default
  std::span<const std::uint16_t> words{};  ///< texels of the formats of a word
  std::span<const std::uint8_t> bytes{};   ///< texels of the palette formats
  std::span<const std::uint16_t> palette{};  ///< RGB565, 16 or 256 of them, for the palette formats

  /// Whether texels are indices into a palette.
  [[nodiscard]] constexpr bool has_palette() const {
    return format == TexelFormat::palette16 || format == TexelFormat::palette256;
  }
  /// Whether texels have an alpha.
  [[nodiscard]] constexpr bool has_alpha() const {
    return format == TexelFormat::rgb565_cutout || format == TexelFormat::argb4444;
  }
  /// log2 of a level's width, texels.
  [[nodiscard]] constexpr unsigned log2_width_of(unsigned level) const {
    return log2_width > level ? log2_width - level : 0;
  }
  /// log2 of a level's height, texels.
  [[nodiscard]] constexpr unsigned log2_height_of(unsigned level) const {
    return log2_height > level ? log2_height - level : 0;
  }
  /// Number of entries of `words` or `bytes` that a level takes.
  [[nodiscard]] constexpr std::size_t level_size(unsigned level) const {
    const std::size_t width = std::size_t{1} << log2_width_of(level), height = std::size_t{1} << log2_height_of(level);
    return format == TexelFormat::palette16 ? (width + 1) / 2 * height : width * height;
  }
  /// Index at which a level begins; `offset_of(levels)` is the size of the table.
  [[nodiscard]] constexpr std::size_t offset_of(unsigned level) const {
    std::size_t offset = 0;
    for (unsigned i = 0; i < level; ++i) offset += level_size(i);
    return offset;
  }
};

/// A vertex's texture coordinates, in units of 2^texture_exponent of the mesh.
struct TextureCoordinate {
  std::int16_t s;  ///< to the right
  std::int16_t t;  ///< downwards
};

/// Texture coordinates after the texture matrix: 1 is one whole texture; |value| < 2,048.
using TextureUnits = Fixed<20>;

/// A texture matrix: s' = ss·s + st·t + s0, t' = ts·s + tt·t + t0. Entries are Q16.16 with |entry| < 2,048; the default
/// is the identity.
struct TextureMatrix {
  Q16_16 ss = Q16_16::from_int(1);  ///< of s in s'; 1 by default
  Q16_16 st{};                      ///< of t in s'; 0 by default
  Q16_16 s0{};                      ///< added to s', textures; 0 by default
  Q16_16 ts{};                      ///< of s in t'; 0 by default
  Q16_16 tt = Q16_16::from_int(1);  ///< of t in t'; 1 by default
  Q16_16 t0{};                      ///< added to t', textures; 0 by default
  /// Whether all entries are equal.
  friend constexpr bool operator==(const TextureMatrix&, const TextureMatrix&) = default;
};

/// What is wrong with a texture.
enum class TextureFault : std::uint8_t {
  none,           ///< nothing
  too_large,      ///< a side or the whole exceeds the limits
  levels,         ///< no level, or more than there are sizes
  texels_count,   ///< the table of the format is too short, or the other one is not empty
  palette_count,  ///< a palette of another size than the format's, or one where there is none
};

/// Checks a texture once, at load. Later code relies on it.
[[nodiscard]] TextureFault validate(const Texture& texture);

/// A short English name of the fault, for messages.
[[nodiscard]] const char* to_string(TextureFault fault);

}  // namespace spanline
