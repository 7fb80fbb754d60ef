#pragma once
#include <cstdint>

#include "spanline/cpu/texture_block.hpp"

namespace spanline {

/// The current texture coordinates and their steps a column. Inside a block the steps change every 4 columns.
struct TextureSteps : TextureBlock {
  void forward() {
    u += du;
    v += dv;
  }
  void back() {
    u -= du;
    v -= dv;
  }
  /// Moves from one piece of a block to the next.
  void next_piece() { next_piece(*this); }
  /// The same for a block that is stored elsewhere.
  void next_piece(const TextureBlock& block) {
    du += block.ddu;
    dv += block.ddv;
  }
  /// Moves to the start of a block.
  void restart(const TextureBlock& block) {
    u = block.u;
    v = block.v;
    du = block.du;
    dv = block.dv;
  }
  /// Moves from the start of a block to another of its columns.
  void skip(std::uint32_t columns, const TextureBlock& block) {
    // The step of piece p has been incremented p times. The sum counts 4 columns of each earlier piece and the columns
    // of this one.
    const std::uint32_t pieces = columns >> 2, gains = pieces * (columns - 2 * pieces - 2);
    u += du * columns + block.ddu * gains;
    v += dv * columns + block.ddv * gains;
    du += block.ddu * pieces;
    dv += block.ddv * pieces;
  }
};

}  // namespace spanline
