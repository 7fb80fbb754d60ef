#pragma once
#include <array>
#include <cstdint>

#include "spanline/model/texture.hpp"
#include "spanline/raster/screen_vertex.hpp"
#include "spanline/raster/span.hpp"
#include "spanline/shade/texture/texture_plane.hpp"

namespace spanline {

/// The density of a texture on a polygon, by which the mip level is chosen: texels a pixel along one axis, as a
/// logarithm to base 2 in 256ths. On a plane in perspective, the area of a pixel in texels is proportional to 1/w³.
struct TexelDensity {
  std::int32_t of_polygon;  ///< √(texels / pixels) of the whole polygon
  std::int32_t at_w_of_1;   ///< density at the points where the word of w is 1

  /// The mip level nearest to a density; a density halfway between two levels takes the larger texture.
  [[nodiscard]] static unsigned level(std::int32_t density, unsigned levels);
  /// Density where the word of w is `w`; if that word is invalid, the density of the whole polygon.
  [[nodiscard]] std::int32_t at(std::uint32_t w) const;

  static constexpr std::int32_t group_columns = 16;
  /// The screen column at which the group of columns begins that share one mip level with `column` of a plane.
  [[nodiscard]] static std::int32_t group_of(const TexturePlane& plane, std::int32_t column) {
    return (column + plane.origin) & -group_columns;
  }
  /// Density at the middle of a group, on a plane in perspective.
  [[nodiscard]] std::int32_t of_group(const TexturePlane& plane, std::int32_t group) const {
    return at(plane.w.at(group + group_columns / 2 - plane.origin));
  }
};

/// log2 of a value ≥ 1, in 256ths, within 3/256.
[[nodiscard]] std::int32_t log2_in_256ths(std::uint32_t value);

/// The density on a triangle, from its corners on the screen, in sixteenths, and on the texture.
[[nodiscard]] TexelDensity texel_density(const std::array<const ScreenVertex*, 3>& screen,
                                         const std::array<TextureVertex, 3>& corners, const Texture& texture,
                                         const TexturePlaneValues& values);

}  // namespace spanline
