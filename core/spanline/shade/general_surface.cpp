#include "spanline/shade/general_surface.hpp"

#include <algorithm>
#include <array>

#include "spanline/shade/colour_888.hpp"
#include "spanline/shade/texel_reader.hpp"

namespace spanline {
namespace {

std::uint32_t wrapped(std::int32_t texel, unsigned log2_size, Wrap wrap) {
  const std::int32_t last = (1 << log2_size) - 1;
  return word(wrap == Wrap::clamp ? std::clamp<std::int32_t>(texel, 0, last) : texel & last);
}

Texel texel_at(const TexelSource& source, std::int32_t x, std::int32_t y) {
  const Texture& texture = *source.texture;
  return read_texel(texture, source.offset, source.log2_width, wrapped(x, source.log2_width, texture.wrap_s),
                    wrapped(y, source.log2_height, texture.wrap_t));
}

Texel nearest_texel(const TexelSource& source, std::uint32_t u, std::uint32_t v) {
  const int shift = 16 + source.level;
  return texel_at(source, signed_word(u) >> shift, signed_word(v) >> shift);
}

struct Sample {
  Colour888 colour;
  std::int32_t alpha;  ///< 255ths
};

Sample sample_of(const Texel& texel) { return {Colour888::from(widened(texel.rgb565)), texel.alpha * 17}; }

/// 255/alpha in Q8; nothing for alpha 0.
constexpr std::array<std::uint16_t, 256> straightening = [] {
  std::array<std::uint16_t, 256> table{};
  for (std::uint32_t alpha = 1; alpha < 256; ++alpha)
    table[alpha] = static_cast<std::uint16_t>((255 * 256 + alpha / 2) / alpha);
  return table;
}();

/// Four texels by their distance in 256ths: column by column, then row by row. Where alpha tells what is there, colours
/// weigh by it, or the colour of texels that are not there would show at the rim of those that are.
Sample bilinear(const TexelSource& source, std::uint32_t u, std::uint32_t v, bool by_alpha) {
  constexpr std::int32_t half = 1 << 15;
  const std::int32_t x = (signed_word(u) >> source.level) - half, y = (signed_word(v) >> source.level) - half;
  const std::int32_t right = (x >> 8) & 255, down = (y >> 8) & 255, column = x >> 16, row = y >> 16;
  const Sample corner[4] = {sample_of(texel_at(source, column, row)), sample_of(texel_at(source, column + 1, row)),
                            sample_of(texel_at(source, column, row + 1)),
                            sample_of(texel_at(source, column + 1, row + 1))};
  const auto weighted = [&](auto value) {
    const std::int32_t above = value(corner[0]) * (256 - right) + value(corner[1]) * right;
    const std::int32_t below = value(corner[2]) * (256 - right) + value(corner[3]) * right;
    return (above * (256 - down) + below * down + 32768) >> 16;
  };
  const std::int32_t alpha = weighted([](const Sample& s) { return s.alpha; });
  if (!by_alpha)
    return {Colour888::of([&](auto c) { return weighted([c](const Sample& s) { return s.colour.*c; }); }), alpha};
  return {Colour888::of([&](auto c) {
            const std::int32_t covered = weighted([c](const Sample& s) { return in_255ths(s.alpha * s.colour.*c); });
            return std::min<std::int32_t>((covered * straightening[word(alpha)] + 128) >> 8, 255);
          }),
          alpha};
}

/// What alpha of texels is for, where they have any and no decal is mixed by it.
bool uses_alpha(const Texturing& texturing, TexelAlpha alpha) {
  return texturing.alpha == alpha && has_alpha(texturing);
}

Sample sample(const Texturing& texturing, const TexelSource& texels, std::uint32_t u, std::uint32_t v) {
  if (texturing.filter == TextureFilter::nearest) return sample_of(nearest_texel(texels, u, v));
  return bilinear(texels, u, v, has_alpha(texturing));
}

Colour888 textured(const Texturing& texturing, const Sample& texel, const Colour888& surface) {
  switch (texturing.function) {
    case TextureFunction::modulate:
      return Colour888::of([&](auto c) { return in_255ths(texel.colour.*c * surface.*c); });
    case TextureFunction::replace:
      return texel.colour;
    case TextureFunction::decal:
      return mixed(surface, texel.colour, texel.alpha);
    case TextureFunction::blend: {
      const Colour888 blend = Colour888::from(texturing.blend_colour);
      return Colour888::of([&](auto c) { return mixed(surface.*c, blend.*c, texel.colour.*c); });
    }
  }
  return surface;
}

/// A product of a side in 2^-16 textures and one on the other axis; enough of it for a logarithm.
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
  // log2(1 + f) is f and a bow of at most 22 256ths; a parabola follows it to 2.
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
  // Texels: 2^-32 textures times their size. Pixels: 256 square sixteenths.
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

TexelSource TexelSource::of(const Texture& texture, unsigned level) {
  return {&texture, texture.offset_of(level), static_cast<std::uint8_t>(level),
          static_cast<std::uint8_t>(texture.log2_width_of(level)),
          static_cast<std::uint8_t>(texture.log2_height_of(level))};
}

TexelSource GeneralSurface::texels_at(std::int32_t column) const {
  if (!textured) return {};
  const Texturing& texturing = group->texturing;
  if (texturing.mip_mapping == MipMapping::none) return TexelSource::of(*texturing.texture, 0);
  std::int32_t wanted = density.of_polygon;
  if (texturing.mip_mapping == MipMapping::span && plane.way != TexturePlane::Way::affine) {
    const std::int32_t middle = ((column + plane.origin) & ~15) + 8 - plane.origin;
    wanted = density.at(plane.w.at(middle));
  }
  return TexelSource::of(*texturing.texture, TexelDensity::level(wanted, texturing.texture->levels));
}

bool general_pixel_present(const GeneralSurface& surface, const TexelSource& texels, std::uint32_t u, std::uint32_t v) {
  if (!surface.textured || !uses_alpha(surface.group->texturing, TexelAlpha::cut_out)) return true;
  return nearest_texel(texels, u, v).alpha >= 8;
}

std::uint8_t general_opacity(const GeneralSurface& surface, const TexelSource& texels, std::uint32_t u,
                             std::uint32_t v) {
  if (!surface.textured || !uses_alpha(surface.group->texturing, TexelAlpha::blend)) return 255;
  return static_cast<std::uint8_t>(sample(surface.group->texturing, texels, u, v).alpha);
}

GeneralColour general_pixel(const GeneralSurface& surface, const TexelSource& texels, const GeneralPixel& pixel) {
  const auto channel = [](std::uint32_t value) { return signed_word(value >> 24); };
  Colour888 colour{channel(pixel.red), channel(pixel.green), channel(pixel.blue)};
  std::uint8_t opacity = 255;
  if (surface.textured) {
    const Texturing& texturing = surface.group->texturing;
    const Sample texel = sample(texturing, texels, pixel.u, pixel.v);
    colour = textured(texturing, texel, colour);
    if (uses_alpha(texturing, TexelAlpha::blend)) opacity = static_cast<std::uint8_t>(texel.alpha);
  }
  return {finished_rgb565(*surface.group->effects, colour, pixel.nearness, word(pixel.column), surface.row), opacity};
}

}  // namespace spanline
