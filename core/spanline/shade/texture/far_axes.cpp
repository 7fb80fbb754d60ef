#include "spanline/shade/texture/far_axes.hpp"

#include <algorithm>

#include "spanline/math/bits.hpp"

namespace spanline {

FarAxes FarAxes::of(const Texture& texture, const std::array<TextureVertex, 3>& corners) {
  const auto far = [&](Wrap wrap, unsigned log2_size, std::int32_t TextureVertex::*coordinate) {
    // The chords of a block may pass beyond the polygon's own coordinates: an eighth of the range is left for that.
    constexpr std::int64_t most = std::int64_t{7} << (12 + TextureUnits::fraction_bits);
    return wrap == Wrap::clamp && std::any_of(corners.begin(), corners.end(), [&](const TextureVertex& corner) {
             return std::int64_t{magnitude(corner.*coordinate)} << log2_size > most;
           });
  };
  return {far(texture.wrap_s, texture.log2_width, &TextureVertex::s),
          far(texture.wrap_t, texture.log2_height, &TextureVertex::t)};
}

std::uint32_t FarAxes::near(std::uint32_t coordinate) {
  constexpr std::int32_t most = 1 << (14 + 8);
  return word(std::clamp(signed_word(coordinate), -most, most)) << 8;
}

}  // namespace spanline
