#pragma once
#include <cstdint>

#include "spanline/cpu/texture_block.hpp"

namespace spanline {

/// Where texture coordinates stand, and steps to the right. Inside a block the steps change every 4 columns.
struct TextureSteps : TextureBlock {
  void forward() {
    u += du;
    v += dv;
  }
  void back() {
    u -= du;
    v -= dv;
  }
  /// From one piece of a block to the next.
  void next_piece() { next_piece(*this); }
  /// The same, of a block that is kept elsewhere.
  void next_piece(const TextureBlock& block) {
    du += block.ddu;
    dv += block.ddv;
  }
  /// To the start of a block.
  void restart(const TextureBlock& block) {
    u = block.u;
    v = block.v;
    du = block.du;
    dv = block.dv;
  }
  /// To another column of the block at whose start it stands.
  void skip(std::uint32_t columns, const TextureBlock& block) {
    // The step of piece p has gained p times: 4 columns of each before this one, and what is left of this.
    const std::uint32_t pieces = columns >> 2, gains = pieces * (columns - 2 * pieces - 2);
    u += du * columns + block.ddu * gains;
    v += dv * columns + block.ddv * gains;
    du += block.ddu * pieces;
    dv += block.ddv * pieces;
  }
};

}  // namespace spanline
