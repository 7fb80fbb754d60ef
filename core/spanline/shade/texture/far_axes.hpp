#pragma once
#include <array>
#include <cstdint>

#include "spanline/model/texture.hpp"
#include "spanline/raster/texture_vertex.hpp"

namespace spanline {

/// Axes on which a clamped texture's coordinates leave the range of 16.16 texels, 2^15 either way. Words may wrap where
/// a texture repeats; where it is clamped it would appear anew beyond its edge. Along these axes a division of its own
/// gives each pixel a word of 8 fraction bits, which holds all coordinates that there are, and 16.16 texels from it.
struct FarAxes {
  bool u, v;

  [[nodiscard]] static FarAxes of(const Texture& texture, const std::array<TextureVertex, 3>& corners);
  [[nodiscard]] bool any() const { return u || v; }
  [[nodiscard]] static int fraction(bool far) { return far ? 8 : 16; }
  /// 16.16 texels of a word of 8 fraction bits, exact within 2^14 texels. What lies beyond them is as far beyond the
  /// texture's edge, and shown alike.
  [[nodiscard]] static std::uint32_t near(std::uint32_t coordinate);
};

}  // namespace spanline
