#pragma once
#include <cstddef>
#include <cstdint>

#include "spanline/cpu/texture_block.hpp"

namespace spanline {

/// The state of make_texture_blocks: the values at the end of the next block, and their steps a block. w, u, v and
/// their steps are normalised: shifted left together until bit 31 of w is set.
struct TextureBlockMaker {
  std::uint32_t w, u, v;         ///< at the end of the next block
  std::uint32_t from_u, from_v;  ///< texture coordinates at the end of the previous block
  TextureBlock* out;             ///< where the next block goes
  std::uint32_t shift_u, shift_v;
  std::uint32_t du, dv;     ///< steps of u and v, a block
  std::uint32_t fall;       ///< decrease of w a block, at most a quarter of w
  const TextureBlock* end;  ///< past the last block
  const std::uint16_t* seeds;
  std::int32_t upper_fall;  ///< fall / 2^16, rounded down
};
static_assert(sizeof(void*) != 4 ||
              (offsetof(TextureBlockMaker, from_u) == 12 && offsetof(TextureBlockMaker, out) == 20 &&
               offsetof(TextureBlockMaker, du) == 32 && offsetof(TextureBlockMaker, seeds) == 48));

}  // namespace spanline
