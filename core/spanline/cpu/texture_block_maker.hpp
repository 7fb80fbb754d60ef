#pragma once
#include <cstddef>
#include <cstdint>

namespace spanline {

/// A block of 16 columns in four pieces, in each of which u and v are linear: steps of a column in its
/// first piece, what they gain from one piece to the next, and coordinates at its start. Loops in assembly know its
/// layout, which is the order in which they are made.
struct TextureBlock {
  std::uint32_t du, ddu, dv, ddv, u, v;
};

/// The loop of CertainBlocks over the blocks whose w has its highest bit in the same place: w, u and v and their
/// steps are normalised, shifted to the left together until that is bit 31.
///
/// It steps more than compilers keep in registers, so that it is in assembly for the cores that have an own file here.
struct BlockMaker {
  std::uint32_t w, u, v;         ///< at the end of the next block
  std::uint32_t from_u, from_v;  ///< coordinates at the end of the block that came last
  TextureBlock* out;             ///< the next block
  std::uint32_t shift_u, shift_v;
  std::uint32_t du, dv;     ///< steps of u and v, a block
  std::uint32_t fall;       ///< of w, a block: at most a quarter of it
  const TextureBlock* end;  ///< behind the last block
  const std::uint16_t* seeds;
  std::int32_t upper_fall;  ///< fall / 2^16, rounded down

  /// Makes at least one block, until w or the blocks end. w need not be right afterwards.
  [[gnu::always_inline]] void make();
};
static_assert(sizeof(void*) != 4 || (offsetof(BlockMaker, from_u) == 12 && offsetof(BlockMaker, out) == 20 &&
                                     offsetof(BlockMaker, du) == 32 && offsetof(BlockMaker, seeds) == 48));
static_assert(offsetof(TextureBlock, dv) == 8 && offsetof(TextureBlock, u) == 16 && sizeof(TextureBlock) == 24);

}  // namespace spanline
