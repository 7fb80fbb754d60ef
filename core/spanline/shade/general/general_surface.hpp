#pragma once
#include <array>
#include <cstdint>

#include "spanline/model/texture.hpp"
#include "spanline/raster/linear_function.hpp"
#include "spanline/raster/span.hpp"
#include "spanline/shade/general/frame_effects.hpp"
#include "spanline/shade/shading_group.hpp"
#include "spanline/shade/texture/mip_level.hpp"
#include "spanline/shade/texture/texture_blocks.hpp"

namespace spanline {

/// One mip level of a texture and how it is sampled.
struct TexelSource {
  const Texture* texture;
  std::size_t offset;  ///< of the level in the table, texels
  std::uint8_t level, log2_width, log2_height;

  [[nodiscard]] static TexelSource of(const Texture& texture, unsigned level);
};

/// The state that `GeneralShader` keeps of a polygon. What to do with it is decided at each pixel.
struct GeneralSurface {
  TexturePlane plane;
  LinearFunction red, green, blue;  ///< colour of the lit surface, 8 bits a channel in bits 31…24
  LinearFunction nearness;          ///< position in the fog table, used in frames with fog
  TexelDensity density;
  const TexturedGroup* group;
  bool textured;
  std::uint16_t row;  ///< screen row, pixels

  void next_row() { skip_rows(1); }
  void skip_rows(std::int32_t rows) {
    plane.skip_rows(rows);
    red.skip_rows(rows);
    green.skip_rows(rows);
    blue.skip_rows(rows);
    nearness.skip_rows(rows);
    row = static_cast<std::uint16_t>(row + rows);
  }
  /// The mip level for the group of 16 screen columns that holds `column`.
  [[nodiscard]] TexelSource texels_at(std::int32_t column) const;
};

/// Inputs of one pixel: texture coordinates in 2^-16 texels of level 0, and colours with 8 bits in bits 31…24.
struct GeneralPixel {
  std::uint32_t u, v, red, green, blue, nearness;
  std::int32_t column;  ///< screen column, pixels
};

/// The result of one pixel.
struct GeneralColour {
  std::uint16_t rgb565;
  std::uint8_t opacity;  ///< of its texels, 255ths; 255 unless the texels blend
};

/// Whether the pixel is drawn at all. The nearest texel alone decides, whatever the filter.
[[nodiscard]] bool general_pixel_present(const GeneralSurface& surface, const TexelSource& texels, std::uint32_t u,
                                         std::uint32_t v);
/// The pixel's colour: the texture function applied to the lit colour (lecture 004), then fog, then rounding or dither.
[[nodiscard]] GeneralColour general_pixel(const GeneralSurface& surface, const TexelSource& texels,
                                          const GeneralPixel& pixel);
/// The pixel's opacity alone, 255ths.
[[nodiscard]] std::uint8_t general_opacity(const GeneralSurface& surface, const TexelSource& texels, std::uint32_t u,
                                           std::uint32_t v);

}  // namespace spanline
