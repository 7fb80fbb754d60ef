#pragma once
#include <array>
#include <cstdint>

#include "spanline/model/texture.hpp"
#include "spanline/raster/screen_vertex.hpp"
#include "spanline/raster/span.hpp"
#include "spanline/shade/texture/texture_plane.hpp"

namespace spanline {

/// The density of a texture on a polygon, for the choice of a mip level: texels a pixel each way, as a logarithm to the
/// base 2 in 256ths. Over a plane in perspective a pixel's area in texels goes with 1/w³.
struct TexelDensity {
  std::int32_t of_polygon;  ///< √(texels / pixels) of the whole
  std::int32_t at_w_of_1;   ///< where the word of w is 1

  /// The nearest level: halves of its sizes go to the larger texture.
  [[nodiscard]] static unsigned level(std::int32_t density, unsigned levels);
  /// Density where the word of w is `w`; the polygon's where that word means nothing.
  [[nodiscard]] std::int32_t at(std::uint32_t w) const;

  static constexpr std::int32_t group_columns = 16;
  /// Where on the screen the columns begin that have one level together, of which `column` of a plane is one.
  [[nodiscard]] static std::int32_t group_of(const TexturePlane& plane, std::int32_t column) {
    return (column + plane.origin) & -group_columns;
  }
  /// Density in the middle of those columns, on a plane in perspective.
  [[nodiscard]] std::int32_t of_group(const TexturePlane& plane, std::int32_t group) const {
    return at(plane.w.at(group + group_columns / 2 - plane.origin));
  }
};

/// log2 of a value ≥ 1 in 256ths, good to 3 of them.
[[nodiscard]] std::int32_t log2_in_256ths(std::uint32_t value);

/// √(texels / pixels) of a triangle: corners on the screen in sixteenths and on the texture.
[[nodiscard]] TexelDensity texel_density(const std::array<const ScreenVertex*, 3>& screen,
                                         const std::array<TextureVertex, 3>& corners, const Texture& texture,
                                         const TexturePlaneValues& values);

}  // namespace spanline
