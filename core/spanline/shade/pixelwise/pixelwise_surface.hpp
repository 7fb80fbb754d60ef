#pragma once
#include <cstdint>

#include "spanline/raster/linear_function.hpp"
#include "spanline/shade/general/frame_effects.hpp"
#include "spanline/shade/pixelwise/lit_texel.hpp"
#include "spanline/shade/shading_group.hpp"
#include "spanline/shade/texture/texture_plane.hpp"

namespace spanline {

/// What every polygon keeps whose pixels are worked out one by one.
struct PixelwiseSurface {
  TexturePlane plane;
  LinearFunction light;      ///< 1/65536, 16 guard bits
  LinearFunction highlight;  ///< likewise; where the material shines
  LinearFunction nearness;   ///< for fog
  const TexturedGroup* group;
  bool plain;  ///< neither highlights nor effects of the frame
  bool shines;
  std::uint16_t row;  ///< of the screen

  void skip_rows(std::int32_t rows) {
    plane.skip_rows(rows);
    light.skip_rows(rows);
    highlight.skip_rows(rows);
    nearness.skip_rows(rows);
    row = static_cast<std::uint16_t>(row + rows);
  }

  /// RGB565 of a texel in a column: lit, then with what is not plain.
  [[nodiscard]] std::uint16_t pixel(const LitTexel& texel, std::int32_t column) const {
    return plain ? lit_rgb565(texel.rgb565, texel.light) : finished(texel, column);
  }

 private:
  [[nodiscard]] std::uint16_t finished(const LitTexel& texel, std::int32_t column) const;
};

}  // namespace spanline
