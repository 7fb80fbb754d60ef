#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "spanline/raster/linear_function.hpp"
#include "spanline/raster/screen_vertex.hpp"
#include "spanline/raster/span.hpp"
#include "spanline/raster/vertex_shade.hpp"
#include "spanline/shade/shading_group.hpp"

namespace spanline {

/// Gouraud shading: the intensity or the colour at the vertices is interpolated linearly over the screen.
namespace gouraud {

inline constexpr int ramp_bits = 6;
inline constexpr std::uint32_t ramp_size = 1u << ramp_bits;

/// The shade of a vertex that has no colour of its own.
[[nodiscard]] constexpr std::uint32_t shade_of(Intensity intensity) {
  return std::clamp<std::uint32_t>(intensity, vertex_shade::lowest_intensity, vertex_shade::highest_intensity);
}

namespace detail {
/// Scales a lit channel, colour · intensity / 256 in [0, 65279], to [0, greatest], and keeps it `off` away from both
/// ends, so that interpolation cannot overflow.
[[nodiscard]] constexpr std::uint32_t rounded(std::uint32_t lit, std::uint32_t greatest, std::uint32_t off) {
  return std::clamp<std::uint32_t>((lit * greatest + 32640) / 65280, off, greatest - off);
}
}  // namespace detail

/// The shade of a vertex with a colour: the colour under the light, channels rounded to nearest.
[[nodiscard]] constexpr std::uint32_t shade_of(Rgb888 colour, Intensity intensity) {
  const auto channel = [intensity](std::uint32_t c, std::uint32_t greatest, std::uint32_t off) {
    return detail::rounded((c * intensity) >> 8, greatest, off);
  };
  return vertex_shade::pack(channel(colour.red, 2047, 2), channel(colour.green, 2047, 2),
                            channel(colour.blue, 1023, 1));
}

/// The shade of a vertex with a colour and a highlight, which is added.
[[nodiscard]] constexpr std::uint32_t shade_of(Rgb888 colour, Intensity intensity, Rgb888 specular,
                                               Intensity highlight) {
  const auto channel = [=](std::uint32_t c, std::uint32_t s, std::uint32_t greatest, std::uint32_t off) {
    const std::uint32_t lit = (c * intensity + s * highlight) >> 8;
    return detail::rounded(lit < 65279 ? lit : 65279, greatest, off);
  };
  return vertex_shade::pack(channel(colour.red, specular.red, 2047, 2), channel(colour.green, specular.green, 2047, 2),
                            channel(colour.blue, specular.blue, 1023, 1));
}

}  // namespace gouraud

/// Fills a ramp: entry i is the colour under intensity i/63.
template <class Format>
void fill_ramp(LitColour colour, std::uint16_t* ramp) {
  for (std::uint32_t i = 0; i < gouraud::ramp_size; ++i)
    ramp[i] = Format::lit(colour, (i * 65535 + 31) / (gouraud::ramp_size - 1));
}

/// Gouraud shading of one colour: the interpolated intensity selects the pixel from a ramp.
template <class Format>
struct GouraudShader {
  using Pixel = typename Format::Pixel;
  static constexpr bool interpolates = true;

  struct Source {
    static constexpr bool constant = false;
    std::uint32_t intensity, step;
    const Pixel* ramp;
    [[nodiscard]] Pixel get() const { return ramp[intensity >> (32 - gouraud::ramp_bits)]; }
    void forward() { intensity += step; }
    void back() { intensity -= step; }
  };

  struct Surface {
    static constexpr int ramp_bits = gouraud::ramp_bits;  // required by the concept RampSurface
    LinearFunction intensity;
    const Pixel* ramp;
    void next_row() { intensity.next_row(); }
    void skip_rows(std::int32_t rows) { intensity.skip_rows(rows); }
    [[nodiscard]] Source source(std::int32_t column) const { return {intensity.at(column), intensity.dx, ramp}; }
  };

  /// Inlined, so that the reciprocal of the triangle's area stays in registers between the triangle's set-up and this.
  template <class Gradients>
  [[gnu::always_inline]] static inline void make(Surface& surface, const ShadingGroup& group,
                                                 const Gradients& gradients) {
    surface.ramp = group.ramp;
    gradients.fit(
        [&](const ScreenVertex* v) { return static_cast<std::int32_t>(group.vertex_shades[gradients.index(v)]); },
        surface.intensity);
  }
};

/// Gouraud shading with vertex colours: three channels are interpolated.
template <class Format>
struct GouraudColourShader {
  using Pixel = typename Format::Pixel;
  static constexpr bool interpolates = true;

  struct Source {
    static constexpr bool constant = false;
    std::uint32_t red, green, blue, red_step, green_step, blue_step;
    [[nodiscard]] Pixel get() const { return Format::pack(red >> 27, green >> 26, blue >> 27); }
    void forward() {
      red += red_step;
      green += green_step;
      blue += blue_step;
    }
    void back() {
      red -= red_step;
      green -= green_step;
      blue -= blue_step;
    }
  };

  struct Surface {
    LinearFunction red, green, blue;
    void next_row() {
      red.next_row();
      green.next_row();
      blue.next_row();
    }
    void skip_rows(std::int32_t rows) {
      red.skip_rows(rows);
      green.skip_rows(rows);
      blue.skip_rows(rows);
    }
    [[nodiscard]] Source source(std::int32_t column) const {
      return {red.at(column), green.at(column), blue.at(column), red.dx, green.dx, blue.dx};
    }
  };

  template <class Gradients>
  static void make(Surface& surface, const ShadingGroup& group, const Gradients& gradients) {
    const auto shade = [&](const ScreenVertex* v) { return group.vertex_shades[gradients.index(v)]; };
    gradients.fit([&](const ScreenVertex* v) { return vertex_shade::red_16(shade(v)); }, surface.red);
    gradients.fit([&](const ScreenVertex* v) { return vertex_shade::green_16(shade(v)); }, surface.green);
    gradients.fit([&](const ScreenVertex* v) { return vertex_shade::blue_16(shade(v)); }, surface.blue);
  }
};

}  // namespace spanline
