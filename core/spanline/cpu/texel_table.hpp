#pragma once
#include <concepts>
#include <cstdint>

#include "spanline/raster/surface_blocks.hpp"

namespace spanline {

/// A table whose words are pixels. The pixel at texture coordinates (u, v) has the index ((u >> 16) & mask_u) + ((v >>
/// 12) & mask_v).
struct TexelTable {
  const std::uint16_t* words;
  std::uint32_t mask_u, mask_v;
};

/// A surface whose pixels are words of a table, at coordinates that its blocks (TextureBlock) give, so that kernels can
/// draw it without its source.
template <class S>
concept TableSurface = SurfaceInCertainBlocks<S> && requires(const S& surface) {
  { surface.texel_table() } -> std::same_as<TexelTable>;
};

}  // namespace spanline
