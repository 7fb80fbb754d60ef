#pragma once
/// @file
/// Vertices in screen coordinates. The outcodes are those of D. Cohen and I. Sutherland (Newman and Sproull,
/// "Principles of Interactive Computer Graphics", 1979), with further bits for depth and guard band.
#include <cstdint>

namespace spanline {

/// Bits that say where a vertex lies outside the viewport, the depth range or the guard band.
enum Outcode : std::uint8_t {
  outcode_left = 1,
  outcode_right = 2,
  outcode_top = 4,
  outcode_bottom = 8,
  outcode_near = 16,   ///< nearer than the near plane; the screen position is meaningless
  outcode_far = 32,    ///< farther than the far plane
  outcode_guard = 64,  ///< outside the guard band; the screen position is meaningless
  outcode_clip = outcode_near | outcode_far | outcode_guard,
};

/// A vertex on screen, 8 bytes. Coordinates are Q12.4 pixels, biased by 2,048 pixels so that they are unsigned (Thumb-1
/// has no signed half-word load with an offset). The centre of pixel i lies at 16·i + 8 sixteenths.
struct ScreenVertex {
  static constexpr std::int32_t bias = 32768;         ///< sixteenths
  static constexpr std::int32_t guard_pixels = 2047;  ///< |x|, |y| ≤ 2047 pixels

  std::uint16_t x;           ///< screen x + bias, sixteenths of a pixel
  std::uint16_t y;           ///< screen y + bias, sixteenths of a pixel; rows count downwards
  std::uint32_t depth_word;  ///< depth in the top 16 or 24 bits, smaller is nearer; outcode in the low 8 bits

  /// A vertex from coordinates in sixteenths of a pixel, inside the guard band, and a depth of `bits` bits.
  [[nodiscard]] static constexpr ScreenVertex make(std::int32_t x_sixteenths, std::int32_t y_sixteenths,
                                                   std::uint32_t depth, int bits, std::uint8_t outcode = 0) {
    return {static_cast<std::uint16_t>(x_sixteenths + bias), static_cast<std::uint16_t>(y_sixteenths + bias),
            (depth << (32 - bits)) | outcode};
  }
  [[nodiscard]] constexpr std::uint8_t outcode() const { return static_cast<std::uint8_t>(depth_word); }
  [[nodiscard]] constexpr std::int32_t x_sixteenths() const { return x - bias; }
  [[nodiscard]] constexpr std::int32_t y_sixteenths() const { return y - bias; }
  template <class Depth>
  [[nodiscard]] constexpr std::int32_t depth() const {
    return static_cast<std::int32_t>(depth_word >> (32 - Depth::bits));
  }
};

/// The first row whose centre is at or below a biased y, which is the first row of an edge that starts there. Rows are
/// biased by 2,048, too.
[[nodiscard]] constexpr std::int32_t row_at(std::int32_t y_biased) { return (y_biased + 7) >> 4; }
inline constexpr std::int32_t row_bias = ScreenVertex::bias / 16;

}  // namespace spanline
