#pragma once
#include <cstdint>

#include "spanline/math/bits.hpp"
#include "spanline/shade/spread_565.hpp"
#include "spanline/shade/texels.hpp"

namespace spanline {

/// The four nearest texels of an RGB565 texture that repeats both ways, weighed by their distance: coordinates as
/// RepeatedTexels has them.
///
/// Distances are rounded to 32nds of a texel, and the four weights, products of two distances, to 32nds whose sum is
/// 32; the sum is rounded once. All channels are weighed at once.
struct BilinearTexels {
  static constexpr TextureFilter filter = TextureFilter::bilinear;
  static constexpr bool has_holes = false, in_bytes = false;
  static constexpr int fraction_u = 16;
  [[nodiscard]] static constexpr int fraction_v(unsigned log2_width) {
    return RepeatedTexels<TexelFormat::rgb565>::fraction_v(log2_width);
  }

  const std::uint16_t* table;
  std::uint32_t mask_u, mask_v;
  std::uint32_t to_centre_v;
  std::uint32_t shift_v;  ///< to 32nds

  [[nodiscard]] static bool serves(const Texture& texture) {
    return RepeatedTexels<TexelFormat::rgb565>::serves(texture);
  }
  [[nodiscard]] static BilinearTexels of(const TexelLevel& level) {
    const auto log2_width = static_cast<unsigned>(31 - leading_zeros_32(level.mask_u + 1));
    const std::uint32_t shift = word(fraction_v(log2_width) - distance_bits);
    return {level.words, level.mask_u, level.mask_v, to_centre(shift), shift};
  }
  /// RGB565.
  [[nodiscard]] std::uint32_t at(std::uint32_t u, std::uint32_t v) const {
    constexpr std::uint32_t distance = (1u << distance_bits) - 1, shift_u = fraction_u - distance_bits;
    u -= to_centre(shift_u);
    v -= to_centre_v;
    const std::uint32_t left = (u >> 16) & mask_u, right = (left + 1) & mask_u;
    const std::uint32_t above = (v >> 12) & mask_v, below = (above + mask_u + 1) & mask_v;
    const std::uint32_t across = (u >> shift_u) & distance, down = (v >> shift_v) & distance;
    const std::uint32_t of_last = (across * down + 16) >> distance_bits;
    const auto texel = [this](std::uint32_t index) { return spread_565::from(table[index]); };
    constexpr std::uint32_t half = 16u << 21 | 16u << 11 | 16;
    const std::uint32_t sum = texel(above + left) * (32 - across - down + of_last) +
                              texel(above + right) * (across - of_last) + texel(below + left) * (down - of_last) +
                              texel(below + right) * of_last;
    return spread_565::joined((sum + half) >> 5 & spread_565::mask);
  }
  [[nodiscard]] static bool present(std::uint32_t) { return true; }

 private:
  static constexpr int distance_bits = 5;
  /// Half a texel less the half that rounds, where a unit of distance has `shift` bits below it.
  [[nodiscard]] static constexpr std::uint32_t to_centre(std::uint32_t shift) {
    return (((1u << distance_bits) - 1) << shift) >> 1;
  }
};

}  // namespace spanline
