#pragma once
/// @file
/// Bumps and embossing, for renderers with `ReliefShader`.
///
/// ```cpp
/// #include <spanline/model/material.hpp>
///
/// static constexpr std::uint8_t heights[] = {0, 255, 255, 0};
/// static constexpr HeightMap studs{.log2_width = 1, .log2_height = 1, .heights = heights};
/// constexpr Material bumpy{.relief = {.heights = &studs, .depth = Fixed<16>::from_ratio(1, 2)}};
/// static_assert(studs.valid());
/// ```
#include <cstddef>
#include <cstdint>
#include <span>

#include "spanline/math/fixed.hpp"
#include "spanline/math/trigonometry.hpp"

namespace spanline {

/// Heights of a surface: 2^log2_width × 2^log2_height bytes, row by row from the top, repeated both ways.
struct HeightMap {
  static constexpr unsigned max_log2_size = 11;  ///< of a side
  std::uint8_t log2_width = 0;                   ///< 0 … max_log2_size; 0 by default, a single texel
  std::uint8_t log2_height = 0;                  ///< 0 … max_log2_size; 0 by default
  std::span<const std::uint8_t> heights{};       ///< 0 … 255, 255 is the greatest height

  /// Whether the sides are in their ranges and the table is long enough.
  [[nodiscard]] constexpr bool valid() const {
    return log2_width <= max_log2_size && log2_height <= max_log2_size &&
           heights.size() >= std::size_t{1} << (log2_width + log2_height);
  }
};

/// How heights change the normal by which the surface is lit (lecture 004).
enum class ReliefKind : std::uint8_t {
  bump,    ///< by the slope of the heights (Blinn 1978)
  emboss,  ///< by a fixed angle towards or away from the light, at steps of the heights
};

/// A relief that changes only the light: outlines and depths stay those of the polygons.
///
/// With texture coordinates u, v in texels of the map, and unit vectors T and B along s and t on the surface:
///
///     bump:    light = ambient + max(0, (N − p·T − q·B)·L / √(1 + p² + q²)),
///              p = depth · (h(u + 1, v) − h(u − 1, v)) / 2 and q alike along v, both within ±2
///     emboss:  the step is h(u, v) less h a texel on towards the light; where it is more than 1/32 either way,
///              N turns by `turn` towards L or away from it
///
/// with h in [0, 1]. L is the sum of the frame's directional lights, so several lights act as the one to which they add
/// up.
struct Relief {
  const HeightMap* heights = nullptr;  ///< null: none; must stay until the frame is drawn
  ReliefKind kind = ReliefKind::bump;  ///< bump by default
  /// Bump: the height that 255 stands for, texels, Q16.16, (0, 64]; 1 by default.
  Fixed<16> depth = Fixed<16>::from_int(1);
  Angle turn = Angle::from_degrees(40);  ///< emboss: (0°, 90°); 40° by default
};

}  // namespace spanline
