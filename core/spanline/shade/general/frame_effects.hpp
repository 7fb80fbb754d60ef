#pragma once
#include <array>
#include <cstdint>

#include "spanline/math/bits.hpp"
#include "spanline/model/camera.hpp"
#include "spanline/model/fog.hpp"
#include "spanline/raster/linear_function.hpp"

namespace spanline {

/// Fog as a table over nearness, a quantity that is linear on the screen: near/z in perspective, the remaining share of
/// the depth range in orthographic views. Nearness is 1 at the near plane. Each halving of nearness has 32 entries, so
/// distances are resolved to 1/64.
class FogTable {
 public:
  static constexpr unsigned halvings = 16, steps = 32;

  void fill(const Fog& fog, const Camera& camera);

  /// The fog's share of a pixel, 255ths, at a nearness in Q32.
  [[nodiscard]] std::uint32_t at(std::uint32_t nearness) const {
    const std::uint32_t value = nearness | least;
    const int zeros = leading_zeros_32(value);
    return shares_[word(zeros) * steps + ((value << zeros) >> 26) - steps];
  }

  /// The nearness of a depth in Q24, as 24 bits that stay clear of both ends of the range, so that interpolation cannot
  /// leave it.
  [[nodiscard]] std::int32_t nearness(std::uint32_t depth) const;

 private:
  static constexpr std::uint32_t least = 1u << (32 - halvings);
  std::array<std::uint8_t, halvings * steps> shares_{};
  std::uint32_t slope_ = 0;  ///< decrease of nearness over the whole depth range, Q32
};

/// Effects that a frame applies to every pixel, in shaders that support them.
struct FrameEffects {
  FogTable fog;
  Rgb888 fog_colour{};
  bool fogged = false;
  bool dither = false;

  [[nodiscard]] bool any() const { return fogged || dither; }
};

/// Nearness as a linear function of screen position on a triangle, for fog.
template <class Gradients>
void fit_nearness(const FogTable& fog, const Gradients& gradients, LinearFunction& nearness) {
  const auto corners = gradients.corners();
  const auto of = [&](unsigned i) { return fog.nearness(corners[i]->depth_word >> 8); };
  gradients.fit_fine({of(0), of(1), of(2)}, 24, nearness);
}

/// Ordered dither (Bayer's 4 × 4 matrix): what is added to a channel before it is rounded down, in 255ths of a step.
/// The mean over the matrix is one half.
inline constexpr std::array<std::uint8_t, 16> dither_thresholds = [] {
  constexpr std::uint8_t bayer[16] = {0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};
  std::array<std::uint8_t, 16> table{};
  for (unsigned i = 0; i < 16; ++i) table[i] = static_cast<std::uint8_t>(((2 * bayer[i] + 1) * 255 + 16) / 32);
  return table;
}();

}  // namespace spanline
