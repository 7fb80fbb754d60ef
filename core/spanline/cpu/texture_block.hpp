#pragma once
#include <cstddef>
#include <cstdint>

namespace spanline {

/// A block of 16 columns of a texture: four pieces of 4 columns, on each of which u and v are linear. It holds the
/// steps a column in the first piece, the increments of the steps from piece to piece, and the coordinates at the
/// start. Kernels in assembly depend on this layout.
struct TextureBlock {
  std::uint32_t du, ddu, dv, ddv, u, v;
};
static_assert(offsetof(TextureBlock, dv) == 8 && offsetof(TextureBlock, u) == 16 && sizeof(TextureBlock) == 24);

}  // namespace spanline
