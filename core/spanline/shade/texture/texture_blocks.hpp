#pragma once
#include <array>
#include <cstdint>

#include "spanline/cpu/texture_steps.hpp"
#include "spanline/math/bits.hpp"
#include "spanline/shade/texture/texture_plane.hpp"

namespace spanline {

/// Walks the texture coordinates along a row in pieces on which u and v are linear. It handles every kind of plane and
/// any run.
class TextureBlocks {
 public:
  static constexpr std::int32_t block_columns = 16, piece_columns = 4;
  using Coordinates = TextureSteps;

  TextureBlocks(const TexturePlane& plane, std::int32_t column);

  /// Pixels left in the piece, and pixels left in the block, whose pieces one source serves by `next_piece`.
  [[nodiscard]] std::uint32_t rest() const { return rest_; }
  [[nodiscard]] std::uint32_t rest_of_block() const {
    return curved_ ? word(block_columns - ((column_ + plane_.origin) & (block_columns - 1))) : rest_;
  }
  [[nodiscard]] const TextureSteps& coordinates() const { return at_; }
  [[nodiscard]] std::int32_t column() const { return column_; }

  /// Moves past the rest of the block.
  void next() { next(rest_of_block()); }
  /// Moves `length` pixels on: exactly `rest_of_block`, or on affine polygons any number up to it.
  void next(std::uint32_t length);

 private:
  static constexpr std::uint32_t whole_row = 4096;  // longer than any run

  /// The state at the end of a block.
  struct Node {
    std::uint32_t w;
    std::uint32_t u, v;  ///< texture coordinates
    bool valid;          ///< w is positive, and u/w and v/w are in [0, 1]
  };
  void divide(Node& node, std::uint32_t u, std::uint32_t v) const;
  [[nodiscard]] Node node_at(std::int32_t column) const;
  void divide();
  void next_division();
  void begin_block(std::int32_t column);
  [[nodiscard]] bool chords_fit(std::int32_t column, std::int32_t bow) const;
  [[nodiscard]] bool chords_fit(std::int32_t column, std::int32_t bow, const LinearFunction& function, int shift) const;

  const TexturePlane& plane_;
  std::int32_t column_;
  std::uint32_t rest_ = 1;
  bool curved_ = false;
  TextureSteps at_{};
  Node last_{};  ///< end of the current block
};

}  // namespace spanline
