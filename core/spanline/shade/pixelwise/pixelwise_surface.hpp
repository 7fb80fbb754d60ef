#pragma once
#include <cstdint>

#include "spanline/raster/linear_function.hpp"
#include "spanline/shade/general/frame_effects.hpp"
#include "spanline/shade/pixelwise/lit_texel.hpp"
#include "spanline/shade/shading_group.hpp"
#include "spanline/shade/texture/texture_plane.hpp"

namespace spanline {

/// The state of any polygon whose pixels are computed one by one.
struct PixelwiseSurface {
  TexturePlane plane;
  LinearFunction light;      ///< intensity, 1/65536 with 16 guard bits
  LinearFunction highlight;  ///< intensity of the highlight in the same format, if the material has highlights
  LinearFunction nearness;   ///< position in the fog table, in frames with fog
  const TexturedGroup* group;
  bool plain;  ///< there are no highlights, fog or dither
  bool shines;
  std::uint16_t row;  ///< screen row, pixels

  void skip_rows(std::int32_t rows) {
    plane.skip_rows(rows);
    light.skip_rows(rows);
    highlight.skip_rows(rows);
    nearness.skip_rows(rows);
    row = static_cast<std::uint16_t>(row + rows);
  }

  /// The RGB565 pixel of a texel in a column: the texel is lit, and then gets highlights, fog and dither.
  [[nodiscard]] std::uint16_t pixel(const LitTexel& texel, std::int32_t column) const {
    return plain ? lit_rgb565(texel.rgb565, texel.light) : finished(texel, column);
  }

 private:
  [[nodiscard]] std::uint16_t finished(const LitTexel& texel, std::int32_t column) const;
};

}  // namespace spanline
