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

/// One level of a texture and how it is read.
struct TexelSource {
  const Texture* texture;
  std::size_t offset;  ///< of the level in the table
  std::uint8_t level, log2_width, log2_height;

  [[nodiscard]] static TexelSource of(const Texture& texture, unsigned level);
};

/// What `GeneralShader` keeps of a polygon: everything that a material and a frame can ask for, chosen pixel by pixel.
struct GeneralSurface {
  TexturePlane plane;
  LinearFunction red, green, blue;  ///< of the lit surface, 8 bits on top
  LinearFunction nearness;          ///< for fog
  TexelDensity density;
  const TexturedGroup* group;
  bool textured;
  std::uint16_t row;  ///< of the screen

  void next_row() { skip_rows(1); }
  void skip_rows(std::int32_t rows) {
    plane.skip_rows(rows);
    red.skip_rows(rows);
    green.skip_rows(rows);
    blue.skip_rows(rows);
    nearness.skip_rows(rows);
    row = static_cast<std::uint16_t>(row + rows);
  }
  /// The texture's level for the 16 columns of the screen around a column.
  [[nodiscard]] TexelSource texels_at(std::int32_t column) const;
};

/// A pixel of a general surface: texture coordinates in 2^-16 texels of level 0, colours with 8 bits on top.
struct GeneralPixel {
  std::uint32_t u, v, red, green, blue, nearness;
  std::int32_t column;  ///< of the screen
};

/// What a pixel of a general surface comes to.
struct GeneralColour {
  std::uint16_t rgb565;
  std::uint8_t opacity;  ///< of its texels in 255ths; 255 without texels that blend
};

/// Whether there is anything: nearest texels alone decide.
[[nodiscard]] bool general_pixel_present(const GeneralSurface& surface, const TexelSource& texels, std::uint32_t u,
                                         std::uint32_t v);
/// The texture function over the lit colour (lecture 004), then fog, then rounding or dither.
[[nodiscard]] GeneralColour general_pixel(const GeneralSurface& surface, const TexelSource& texels,
                                          const GeneralPixel& pixel);
/// Its opacity alone.
[[nodiscard]] std::uint8_t general_opacity(const GeneralSurface& surface, const TexelSource& texels, std::uint32_t u,
                                           std::uint32_t v);

}  // namespace spanline
