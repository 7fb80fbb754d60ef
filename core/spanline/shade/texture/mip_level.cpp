#include "spanline/shade/texture/mip_level.hpp"

#include <algorithm>

#include "spanline/math/bits.hpp"

namespace spanline {
namespace {

/// Twice the area of a triangle, from two of its sides. It is shifted down by `shift` to fit 32 bits, which is accurate
/// enough for a logarithm.
std::uint32_t doubled_area(std::int64_t ax, std::int64_t ay, std::int64_t bx, std::int64_t by, int& shift) {
  const std::int64_t cross = ax * by - ay * bx;
  auto area = static_cast<std::uint64_t>(cross < 0 ? -cross : cross);
  for (shift = 0; (area >> 32) != 0; ++shift) area >>= 1;
  return static_cast<std::uint32_t>(std::max<std::uint64_t>(area, 1));
}

}  // namespace

std::int32_t log2_in_256ths(std::uint32_t value) {
  const int zeros = leading_zeros_32(value);
  const std::uint32_t fraction = ((value << zeros) >> 23) & 255;
  // log2(1 + f) exceeds f by at most 22/256; a parabola approximates the excess to within 2/256.
  const std::uint32_t bow = fraction * (256 - fraction) * 22 >> 14;
  return (31 - zeros) * 256 + signed_word(fraction + bow);
}

TexelDensity texel_density(const std::array<const ScreenVertex*, 3>& screen,
                           const std::array<TextureVertex, 3>& corners, const Texture& texture,
                           const TexturePlaneValues& values) {
  int texel_shift, pixel_shift;
  const auto side = [](std::int32_t to, std::int32_t from) { return (static_cast<std::int64_t>(to) - from) >> 4; };
  const std::uint32_t texels =
      doubled_area(side(corners[1].s, corners[0].s), side(corners[1].t, corners[0].t), side(corners[2].s, corners[0].s),
                   side(corners[2].t, corners[0].t), texel_shift);
  const auto x = [&](unsigned i) { return static_cast<std::int64_t>(screen[i]->x) - screen[0]->x; };
  const auto y = [&](unsigned i) { return static_cast<std::int64_t>(screen[i]->y) - screen[0]->y; };
  const std::uint32_t pixels = doubled_area(x(1), y(1), x(2), y(2), pixel_shift);
  // The area in texels is 2^-32 square textures times the texture's size; a pixel is 256 square sixteenths.
  const int exponent = texture.log2_width + texture.log2_height - 32 + texel_shift + 8 - pixel_shift;
  const std::int32_t doubled = log2_in_256ths(texels) - log2_in_256ths(pixels) + exponent * 256;
  std::int32_t of_w = 0;
  for (const std::int32_t w : values.w) of_w += log2_in_256ths(word(w) << (32 - values.bits));
  return {doubled >> 1, (doubled + of_w) >> 1};
}

std::int32_t TexelDensity::at(std::uint32_t w) const {
  if (signed_word(w) <= 0) return of_polygon;
  return at_w_of_1 - (3 * log2_in_256ths(w) >> 1);
}

unsigned TexelDensity::level(std::int32_t density, unsigned levels) {
  const std::int32_t nearest = (density + 128) >> 8;
  return static_cast<unsigned>(std::clamp<std::int32_t>(nearest, 0, static_cast<std::int32_t>(levels) - 1));
}

}  // namespace spanline
