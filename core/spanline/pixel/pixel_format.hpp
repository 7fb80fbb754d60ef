#pragma once
#include <bit>
#include <cstdint>

#include "spanline/model/colour.hpp"

namespace spanline {

/// A surface colour prepared for lighting: each channel is scaled by 31/255 or 63/255 and stored in Q8.8. One product
/// with an intensity and one shift then give the rounded 5- or 6-bit channel.
struct LitColour {
  std::uint16_t red, green, blue;

  /// Weights are round(256·256·31/255) and round(256·256·63/255).
  [[nodiscard]] static constexpr LitColour from(Rgb888 c) {
    return {static_cast<std::uint16_t>((c.red * 7967u) >> 8), static_cast<std::uint16_t>((c.green * 16191u) >> 8),
            static_cast<std::uint16_t>((c.blue * 7967u) >> 8)};
  }
};

/// The light that a white surface reflects to the eye, 1/65536, [0, 65535].
using Intensity = std::uint32_t;

/// 16-bit pixels, red in bits 15…11, green in 10…5, blue in 4…0. `Swapped` stores them high byte first in memory on a
/// little-endian core, the order in which display controllers take them from an 8-bit bus.
template <bool Swapped>
struct PackedRgb565 {
  using Pixel = std::uint16_t;

  /// Packs channels of 5, 6 and 5 bits.
  [[nodiscard]] static constexpr Pixel pack(std::uint32_t red, std::uint32_t green, std::uint32_t blue) {
    const std::uint32_t word = red << 11 | green << 5 | blue;
    return static_cast<Pixel>(Swapped ? (word << 8 | word >> 8) : word);
  }
  /// The pixel of a colour under an intensity; channels are rounded to nearest.
  [[nodiscard]] static constexpr Pixel lit(LitColour colour, Intensity intensity) {
    constexpr std::uint32_t half = 1u << 23;
    return pack((colour.red * intensity + half) >> 24, (colour.green * intensity + half) >> 24,
                (colour.blue * intensity + half) >> 24);
  }
  /// The pixel of a colour in full light.
  [[nodiscard]] static constexpr Pixel from(Rgb888 colour) { return lit(LitColour::from(colour), 65535); }
  /// The pixel of an RGB565 word in plain byte order. It is its own inverse.
  [[nodiscard]] static constexpr Pixel from_rgb565(std::uint16_t word) {
    return static_cast<Pixel>(Swapped ? (word << 8 | word >> 8) : word);
  }
};

using Rgb565 = PackedRgb565<false>;
using Rgb565Swapped = PackedRgb565<true>;

/// An item buffer: each pixel holds 1 + the id of the triangle that owns it, or 0 for the background.
struct PolygonIds {
  using Pixel = std::uint32_t;
  [[nodiscard]] static constexpr Pixel from(Rgb888) { return 0; }
};

}  // namespace spanline
