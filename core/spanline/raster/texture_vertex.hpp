#pragma once
#include <cstdint>

#include "spanline/math/bits.hpp"

namespace spanline {

/// The data of a vertex for texturing, besides its screen vertex.
struct TextureVertex {
  std::uint32_t nearness;  ///< 1/z, with one scale for an instance, [1, 2^31]; constant in orthographic views
  std::int32_t s, t;       ///< texture coordinates, in units of 2^-20 textures

  /// A texture coordinate between those of two vertices, linear in space before projection; share is Q31 in [0, 1]. The
  /// two may be further apart than 2^31. The nearness is not interpolated, since it is computed from the new point.
  [[nodiscard]] static constexpr std::int32_t mix(std::int32_t from, std::int32_t to, std::uint32_t share) {
    const std::int64_t difference = (static_cast<std::int64_t>(to) - from) * share >> 31;
    return signed_word(word(from) + static_cast<std::uint32_t>(difference));
  }
};

}  // namespace spanline
