#pragma once
#include <cstdint>

namespace spanline {

/// What a vertex carries for texturing, beside its place on screen.
struct TextureVertex {
  std::uint32_t nearness;  ///< 1/z, scaled alike over an instance: [1, 2^31]; the same for all in an orthographic view
  std::int32_t s, t;       ///< texture coordinates, 2^-20 textures

  /// Between two vertices in space, before projection; t_share in Q31 of [0, 1]. The nearness is not mixed: it follows
  /// from the point.
  [[nodiscard]] static constexpr std::int32_t mix(std::int32_t from, std::int32_t to, std::uint32_t share) {
    const std::int64_t difference = static_cast<std::int64_t>(to) - from;
    return from + static_cast<std::int32_t>((difference * share) >> 31);
  }
};

}  // namespace spanline
