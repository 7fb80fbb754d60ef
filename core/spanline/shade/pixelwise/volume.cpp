#include "spanline/shade/pixelwise/volume.hpp"

namespace spanline {

TexturePlaneValues VolumeGeometry::set(const std::array<Point, 3>& points,
                                       const std::array<std::uint32_t, 3>& of_corners, unsigned log2_size) {
  const auto& [a, b, c] = points;
  const auto to_word = [](std::int32_t coordinate) { return word(coordinate) << 12; };
  const auto side = [](std::int32_t to, std::int32_t from) {
    return static_cast<std::int32_t>(((static_cast<std::int64_t>(to) - from) + 8) >> 4);
  };
  corner = {to_word(a.s), to_word(a.t), to_word(a.r)};
  e = {side(b.s, a.s), side(b.t, a.t), side(b.r, a.r)};
  f = {side(c.s, a.s), side(c.t, a.t), side(c.r, a.r)};
  // The number of cells along the longest side: the plane counts them as texels when it decides whether affine mapping
  // is accurate enough.
  std::uint32_t longest = 1;
  for (unsigned i = 0; i < 3; ++i) longest = std::max({longest, magnitude(e[i]), magnitude(f[i])});
  const int cells = std::clamp(32 - leading_zeros_32(longest) - 16 + static_cast<int>(log2_size), 0, 8);
  constexpr std::int32_t one = 1 << 20;
  return texture_plane_values({TextureVertex{of_corners[0], 0, 0}, {of_corners[1], one, 0}, {of_corners[2], 0, one}},
                              TextureMapping::perspective, {cells, cells, 24 - cells, 24 - cells});
}

}  // namespace spanline
