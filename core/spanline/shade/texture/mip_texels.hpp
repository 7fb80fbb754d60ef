#pragma once
#include <cstdint>

#include "spanline/cpu/texture_block.hpp"
#include "spanline/math/bits.hpp"
#include "spanline/model/material.hpp"
#include "spanline/pixel/spread_565.hpp"
#include "spanline/shade/texture/mip_level.hpp"
#include "spanline/shade/texture/nearest_texels.hpp"
#include "spanline/shade/texture/texture_plane.hpp"

namespace spanline {

/// Reads texels of an RGB565 texture that repeats both ways, at any mip level: the nearest texel, or a bilinear mix of
/// four. u and v are texels of level 0 with 16 fraction bits.
///
/// Bilinear distances are rounded to 32nds of a texel. The four weights, products of two distances, are rounded to
/// 32nds whose sum is 32. All channels are weighted at once, and their sum is rounded once.
template <TextureFilter Filter>
class MipTexels {
 public:
  static constexpr TextureFilter filter = Filter;
  static constexpr bool has_holes = false, in_bytes = false, has_levels = true;
  static constexpr int fraction_u = 16;
  [[nodiscard]] static constexpr int fraction_v(unsigned) { return 16; }

  [[nodiscard]] static bool serves(const Texture& texture) {
    return NearestTexels<TexelFormat::rgb565>::serves(texture);
  }
  [[nodiscard]] static MipTexels of(const Texturing& texturing, const TexelDensity& density) {
    MipTexels texels;
    texels.texture_ = texturing.texture;
    texels.density_ = density;
    texels.by_span_ = texturing.mip_mapping == MipMapping::span;
    texels.take(texturing.mip_mapping == MipMapping::none ? 0 : texels.level_of(density.of_polygon));
    return texels;
  }
  /// Selects the mip level for a column of the plane.
  void start(const TexturePlane& plane, std::int32_t column) {
    if (!by_span_ || plane.way == TexturePlane::Way::affine) return;
    plane_ = &plane;
    group_ = TexelDensity::group_of(plane, column);
    take_level_of_group();
  }
  /// Selects the mip level for the next 16 screen columns.
  void next_block() {
    if (plane_ == nullptr) return;
    group_ += TexelDensity::group_columns;
    take_level_of_group();
  }

  /// Adjusts the coordinates at the start of a block for `at`: bilinear distances count from the centre of a texel, and
  /// half a distance step is added for rounding.
  void place(TextureBlock& at) const {
    at.u -= to_centre_;
    at.v -= to_centre_;
  }
  /// The RGB565 colour at (u, v).
  [[nodiscard]] std::uint32_t at(std::uint32_t u, std::uint32_t v) const {
    u >>= shift_;
    v >>= shift_;
    const auto texel = [this](std::uint32_t row, std::uint32_t column) {
      return table_[(row << log2_width_) + column];
    };
    if constexpr (Filter == TextureFilter::nearest) {
      return texel(v & mask_v_, u & mask_u_);
    } else {
      constexpr std::uint32_t one = 1u << distance_bits, half = one / 2;
      const std::uint32_t left = (u >> distance_bits) & mask_u_, right = (left + 1) & mask_u_,
                          above = (v >> distance_bits) & mask_v_, below = (above + 1) & mask_v_;
      const std::uint32_t across = u & (one - 1), down = v & (one - 1);
      const std::uint32_t of_last = (across * down + half) >> distance_bits;
      const auto part = [&](std::uint32_t row, std::uint32_t column, std::uint32_t weight) {
        return spread_565::from(texel(row, column)) * weight;
      };
      const std::uint32_t sum = part(above, left, one - across - down + of_last) +
                                part(above, right, across - of_last) + part(below, left, down - of_last) +
                                part(below, right, of_last);
      constexpr std::uint32_t halves = half << 21 | half << 11 | half;
      return spread_565::joined((sum + halves) >> distance_bits & spread_565::mask);
    }
  }
  [[nodiscard]] static bool present(std::uint32_t) { return true; }

 private:
  static constexpr unsigned distance_bits = Filter == TextureFilter::bilinear ? 5 : 0;  ///< fraction bits of a texel

  [[nodiscard]] unsigned level_of(std::int32_t density) const { return TexelDensity::level(density, texture_->levels); }
  void take_level_of_group() {
    const unsigned level = level_of(density_.of_group(*plane_, group_));
    if (level != level_) take(level);
  }
  void take(unsigned level) {
    level_ = static_cast<std::uint8_t>(level);
    log2_width_ = static_cast<std::uint8_t>(texture_->log2_width_of(level));
    table_ = texture_->words.data() + texture_->offset_of(level);
    mask_u_ = (1u << log2_width_) - 1;
    mask_v_ = (1u << texture_->log2_height_of(level)) - 1;
    shift_ = static_cast<std::uint8_t>(16 + level - distance_bits);
    to_centre_ = (((1u << distance_bits) - 1) << shift_) >> 1;
  }

  const std::uint16_t* table_ = nullptr;
  std::uint32_t mask_u_ = 0, mask_v_ = 0, to_centre_ = 0;
  std::uint8_t shift_ = 0, log2_width_ = 0, level_ = 0;
  bool by_span_ = false;
  const Texture* texture_ = nullptr;
  const TexturePlane* plane_ = nullptr;  ///< null if one level serves the whole row
  std::int32_t group_ = 0;               ///< screen column at which the current 16 columns begin
  TexelDensity density_{};
};

}  // namespace spanline
