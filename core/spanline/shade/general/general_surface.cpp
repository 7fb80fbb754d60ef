#include "spanline/shade/general/general_surface.hpp"

#include <algorithm>
#include <array>

#include "spanline/model/texel_reader.hpp"
#include "spanline/shade/general/colour_888.hpp"

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

/// 255/alpha, Q8, by alpha in [0, 255]; 0 for alpha 0.
constexpr std::array<std::uint16_t, 256> straightening = [] {
  std::array<std::uint16_t, 256> table{};
  for (std::uint32_t alpha = 1; alpha < 256; ++alpha)
    table[alpha] = static_cast<std::uint16_t>((255 * 256 + alpha / 2) / alpha);
  return table;
}();

/// Bilinear filter: four texels weighted by their distances in 256ths, first along columns, then along rows. Where
/// alpha says whether a texel is present, colours are weighted by alpha too; otherwise the colour of absent texels
/// would show at the edges of present ones.
Sample bilinear(const TexelSource& source, std::uint32_t u, std::uint32_t v, bool by_alpha) {
  // From the centres of texels; modulo 2^32, because the words of repeated textures wrap.
  constexpr std::uint32_t half = 1 << 15;
  const std::int32_t x = signed_word(word(signed_word(u) >> source.level) - half),
                     y = signed_word(word(signed_word(v) >> source.level) - half);
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

/// Whether the alpha of texels is used in the way `alpha` names: texels have any, and no decal uses it to mix colours.
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

}  // namespace

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
  if (texturing.mip_mapping == MipMapping::span && plane.way != TexturePlane::Way::affine)
    wanted = density.of_group(plane, TexelDensity::group_of(plane, column));
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
