#pragma once
#include <cstddef>
#include <cstdint>

namespace spanline {

/// A block of 16 columns of a texture in four pieces of 4 columns, in each of which u and v are linear: steps of a
/// column in its first piece, what they gain from one piece to the next, and coordinates at its start. Kernels in
/// assembly know this layout.
struct TextureBlock {
  std::uint32_t du, ddu, dv, ddv, u, v;
};
static_assert(offsetof(TextureBlock, dv) == 8 && offsetof(TextureBlock, u) == 16 && sizeof(TextureBlock) == 24);

}  // namespace spanline
