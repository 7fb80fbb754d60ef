#pragma once
#include <cstdint>

#include "spanline/cpu/texture_block_maker.hpp"
#include "spanline/shade/texture/texture_plane.hpp"

namespace spanline {

/// The blocks of a run, for runs whose blocks need no check one by one: affine ones, and those in perspective if every
/// block can be drawn as a parabola. w, u and v are linear along the run, so one check at both ends covers all blocks
/// between.
class CertainBlocks {
 public:
  /// Checks the run and makes its first blocks.
  CertainBlocks(const TexturePlane& plane, std::int32_t column, std::uint32_t count);
  [[nodiscard]] bool certain() const { return certain_; }
  /// Columns from the start of the first block to the start of the run.
  [[nodiscard]] std::uint32_t into_block() const { return into_block_; }
  /// The blocks made last, at least one.
  [[nodiscard]] const TextureBlock* blocks() const { return blocks_; }
  [[nodiscard]] std::uint32_t count() const { return count_; }
  /// Makes the next blocks; false if there are none.
  [[nodiscard]] bool next() { return left_ != 0 && take_next(); }

 private:
  static constexpr std::uint32_t most = 21;  ///< blocks made at a time: 320 columns

  bool take_next();
  void take();
  void take_affine();
  void normalise(int zeros, std::uint32_t w, std::uint32_t u, std::uint32_t v);
  void normalise_behind(std::uint32_t blocks);

  bool certain_, affine_;
  std::uint32_t into_block_;
  std::uint32_t count_, left_;  ///< number of blocks made last, and of those still to be made
  std::uint32_t w_, u_,
      v_;  ///< perspective: at the end of the first block. Affine: coordinates at the start of the next block
  std::uint32_t fall_, du_, dv_;  ///< decrease of w and steps of u and v. Perspective: a block. Affine: a column
  std::uint32_t made_ = 0;        ///< number of blocks that precede those made last
  TextureBlockMaker maker_;
  TextureBlock blocks_[most];
};

}  // namespace spanline
