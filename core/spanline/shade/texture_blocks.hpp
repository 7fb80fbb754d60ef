#pragma once
#include <array>
#include <cstdint>

#include "spanline/math/bits.hpp"
#include "spanline/shade/block_maker.hpp"
#include "spanline/shade/texture_plane.hpp"

namespace spanline {

namespace detail {
/// 2^31 / d at the middle of each of 256 intervals of d in [2^22, 2^23): 9 bits.
inline constexpr std::array<std::uint16_t, 256> texture_reciprocal_seed = [] {
  std::array<std::uint16_t, 256> table{};
  for (std::uint32_t i = 0; i < 256; ++i) {
    const std::uint32_t doubled_middle = 2 * (256 + i) + 1;
    table[i] = static_cast<std::uint16_t>(((1u << 19) + doubled_middle) / (2 * doubled_middle));
  }
  return table;
}();
}  // namespace detail

/// The division of a perspective texture: 1/w as a seed of 9 bits and a correction of first order, by products of 32
/// bits alone, which are the same one instruction on every core. All words are normalised: shifted to the left together
/// until the top bit of w is set.
struct TextureReciprocal {
  std::uint32_t seed;       ///< 2^40 / w, good to 2^-9
  std::int32_t correction;  ///< what seed · w lacks of 1, in Q24; and the mean of what the second order would add

  [[nodiscard]] static TextureReciprocal of(std::uint32_t w) {
    constexpr std::int32_t mean_square = 16;
    const std::uint32_t seed = detail::texture_reciprocal_seed[(w >> 23) & 255];
    return {seed, mean_square - (signed_word((w >> 9) * seed << 1) >> 8)};
  }
  /// part/w in Q30, for part in [0, w]: within 2^-18 of itself, and 2^-21.
  [[nodiscard]] std::uint32_t share(std::uint32_t part) const {
    const std::uint32_t first = (part >> 10) * seed;
#if defined(__ARM_FEATURE_DSP)
    std::uint32_t sum;  // the upper half of `first` times 32 bits, without the lowest 16, and `first`
    __asm__("smlawt %0, %1, %2, %2" : "=r"(sum) : "r"(correction * 256), "r"(first));
    return sum;
#else
    return first + word((signed_word(first >> 16) * correction) >> 8);
#endif
  }
  /// How far a parabola in the place of the hyperbola bows back where w has fallen by `fall` · 2^16 to what it is, at
  /// most a quarter of it: at the middle it leaves the chord by (distance of the ends) · (w − w0) / (2 (w0 + w)), which
  /// is share/4 · (1 + share/2 + …) for the share of the difference in w. Q16, good to a thousandth of the distance.
  [[nodiscard]] std::int32_t bow(std::int32_t fall) const {
    const std::int32_t share = fall * signed_word(seed) >> 8;
    return (share - (share * share >> 17)) >> 2;
  }
};

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
  void bend() { bend(*this); }
  /// The same, of a block that is kept elsewhere.
  void bend(const TextureBlock& block) {
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
    // Piece p is p bends steeper than the first: 4 columns of each before this one, and what is left of this.
    const std::uint32_t pieces = columns >> 2, bent = pieces * (columns - 2 * pieces - 2);
    u += du * columns + block.ddu * bent;
    v += dv * columns + block.ddv * bent;
    du += block.ddu * pieces;
    dv += block.ddv * pieces;
  }
};

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
  BlockMaker maker_;
  TextureBlock blocks_[most];
};

/// Walks the texture coordinates of a row, piece by piece: in each u and v are linear. It serves every run.
class TextureBlocks {
 public:
  static constexpr std::int32_t block_columns = 16, piece_columns = 4;
  using Coordinates = TextureSteps;

  TextureBlocks(const TexturePlane& plane, std::int32_t column);

  /// Pixels left in the piece, and to the end of the pieces that one source serves with `bend` between them.
  [[nodiscard]] std::uint32_t rest() const { return rest_; }
  [[nodiscard]] std::uint32_t rest_of_block() const {
    return curved_ ? word(block_columns - ((column_ + plane_.origin) & (block_columns - 1))) : rest_;
  }
  [[nodiscard]] const TextureSteps& coordinates() const { return at_; }
  [[nodiscard]] std::int32_t column() const { return column_; }

  /// Behind `rest_of_block` pixels.
  void next() { next(rest_of_block()); }
  /// Behind as many pixels; at most `rest_of_block`, and fewer of affine polygons alone.
  void next(std::uint32_t length);

 private:
  static constexpr std::uint32_t whole_row = 4096;  // longer than any run

  /// The end of a block.
  struct Node {
    std::uint32_t w;
    std::uint32_t u, v;  ///< texture coordinates
    bool valid;          ///< w positive, u/w and v/w in [0, 1]
  };
  void divide(Node& node, std::uint32_t u, std::uint32_t v) const;
  [[nodiscard]] Node node_at(std::int32_t column) const;
  void divide();
  void next_division();
  void begin_block(std::int32_t column);

  const TexturePlane& plane_;
  std::int32_t column_;
  std::uint32_t rest_ = 1;
  bool curved_ = false;
  TextureSteps at_{};
  Node last_{};  ///< the end of the block
};

}  // namespace spanline
