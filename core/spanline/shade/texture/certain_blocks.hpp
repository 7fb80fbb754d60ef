#pragma once
#include <cstdint>

#include "spanline/cpu/texture_block_maker.hpp"
#include "spanline/shade/texture/texture_plane.hpp"

namespace spanline {

/// The blocks of a run, where they can be had without a question to each: affine ones, and those in perspective if
/// all are drawn as parabolas. The words of the plane are linear, so what holds for the run's first and last block
/// holds for those between.
class CertainBlocks {
 public:
  /// With the first blocks at hand.
  CertainBlocks(const TexturePlane& plane, std::int32_t column, std::uint32_t count);
  [[nodiscard]] bool certain() const { return certain_; }
  /// Columns from the first block's start to the run.
  [[nodiscard]] std::uint32_t into_block() const { return into_block_; }
  /// Those at hand, at least one.
  [[nodiscard]] const TextureBlock* blocks() const { return blocks_; }
  [[nodiscard]] std::uint32_t count() const { return count_; }
  /// Goes on to the next ones; false if there are none.
  [[nodiscard]] bool next() { return left_ != 0 && take_next(); }

 private:
  static constexpr std::uint32_t most = 21;  ///< at a time: 320 columns

  bool take_next();
  void take();
  void take_affine();
  void normalise(int zeros, std::uint32_t w, std::uint32_t u, std::uint32_t v);
  void normalise_behind(std::uint32_t blocks);

  bool certain_, affine_;
  std::uint32_t into_block_;
  std::uint32_t count_, left_;    ///< blocks at hand, and behind them
  std::uint32_t w_, u_, v_;       ///< at the end of the first block. Affine: coordinates at the start of the next
  std::uint32_t fall_, du_, dv_;  ///< of w, and steps of u and v, a block. Affine: a column
  std::uint32_t made_ = 0;        ///< blocks before those at hand
  TextureBlockMaker maker_;
  TextureBlock blocks_[most];
};

}  // namespace spanline
