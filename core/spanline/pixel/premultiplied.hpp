#pragma once
#include <cstdint>

#include "spanline/pixel/spread_565.hpp"

namespace spanline {

/// Coverage α of a transparent layer over RGB565, in 32nds, [0, 32].
using Alpha32 = std::uint32_t;
inline constexpr Alpha32 opaque_alpha = 32;

/// Converts an opacity of [0, 255] to coverage, rounded to nearest.
[[nodiscard]] constexpr Alpha32 alpha_32(std::uint32_t opacity) { return (opacity * 64 + 255) / 510; }

/// A colour with premultiplied alpha over RGB565 (Porter and Duff 1984; lecture 004). It stores A' = αA and α, so that
/// the same equation composes both colour, C' = B' + A' − αB', and coverage, γ = β + α − αβ.
///
/// Channels of A' are exact, in 32nds of an RGB565 step: red and blue in [0, 31·32], green in [0, 63·32]. They share
/// one word, green in bits 31…21, red in 20…11, blue in 9…0: the bits in which the product of an RGB565 word
/// (spread_565) with 32 − α has them. Over an opaque pixel the result is therefore exact for that α, and rounded to
/// nearest, halves up.
class Premultiplied565 {
 public:
  constexpr Premultiplied565() = default;  ///< fully transparent: it changes no pixel

  /// Premultiplies a straight colour by its coverage.
  [[nodiscard]] static constexpr Premultiplied565 from(std::uint32_t rgb565, Alpha32 alpha) {
    return {spread_565::from(rgb565) * alpha, alpha};
  }

  [[nodiscard]] constexpr Alpha32 alpha() const { return alpha_; }
  [[nodiscard]] constexpr std::uint32_t red() const { return (colour_ >> 11) & 1023; }  ///< 32nds of a step
  [[nodiscard]] constexpr std::uint32_t green() const { return colour_ >> 21; }
  [[nodiscard]] constexpr std::uint32_t blue() const { return colour_ & 1023; }

  /// This layer over an opaque pixel, RGB565.
  [[nodiscard]] constexpr std::uint32_t over(std::uint32_t rgb565) const {
    return spread_565::joined(((spread_565::from(rgb565) * keep() + rounded()) >> 5) & spread_565::mask);
  }
  /// This layer over another layer, as one layer that equals both. Colour and coverage are rounded to 32nds.
  [[nodiscard]] constexpr Premultiplied565 over(Premultiplied565 below) const {
    const auto composed = [this](std::uint32_t above, std::uint32_t under) {
      return above + ((under * keep() + 16) >> 5);
    };
    return {
        composed(green(), below.green()) << 21 | composed(red(), below.red()) << 11 | composed(blue(), below.blue()),
        composed(alpha_, below.alpha_)};
  }

  /// Constants of a loop over pixels: keep() is 32 − α, rounded() is A' with ½ added to each channel.
  [[nodiscard]] constexpr std::uint32_t keep() const { return opaque_alpha - alpha_; }
  [[nodiscard]] constexpr std::uint32_t rounded() const { return colour_ + 0x02008010u; }

  friend constexpr bool operator==(Premultiplied565, Premultiplied565) = default;

 private:
  constexpr Premultiplied565(std::uint32_t colour, Alpha32 alpha) : colour_(colour), alpha_(alpha) {}

  std::uint32_t colour_ = 0;
  Alpha32 alpha_ = 0;
};

/// A premultiplied colour without coverage, α = 0, for glows: C' = B' + A'. Channels saturate.
[[nodiscard]] constexpr std::uint32_t added_565(std::uint32_t below, std::uint32_t glow) {
  const std::uint32_t sum = spread_565::from(below) + spread_565::from(glow);
  const std::uint32_t red_blue = sum & 0x00010020, green = sum & 0x08000000;  // carries: the bit above each channel
  // A carry minus the channel's lowest bit sets all bits of the channel.
  const std::uint32_t full = (red_blue - (red_blue >> 5)) | (green - (green >> 6));
  return spread_565::joined((sum | full) & spread_565::mask);
}

/// Lays one premultiplied pixel over `count` ≥ 1 pixels of a line.
template <class Format>
[[gnu::noinline]] void blend_constant(Premultiplied565 layer, std::uint32_t count, typename Format::Pixel* pixels) {
  const std::uint32_t keep = layer.keep(), source = layer.rounded();
  const auto put = [ keep, source ](typename Format::Pixel & pixel) __attribute__((always_inline)) {
    const std::uint32_t below = spread_565::from(Format::from_rgb565(pixel));  // from_rgb565 is its own inverse
    pixel = Format::from_rgb565(
        static_cast<std::uint16_t>(spread_565::joined(((below * keep + source) >> 5) & spread_565::mask)));
  };
  for (; count >= 4; count -= 4, pixels += 4) {
#pragma GCC unroll 4
    for (int i = 0; i < 4; ++i) put(pixels[i]);
  }
  for (; count != 0; --count) put(*pixels++);
}

}  // namespace spanline
