#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "spanline/memory/arena.hpp"
#include "spanline/raster/linear_function.hpp"
#include "spanline/visibility/band_target.hpp"

namespace spanline {

/// Depth bounds for tiles, 32 columns of a line each (hierarchical z-buffering, lecture 002): what every pixel of a
/// tile is nearer than, and what none is nearer than. Runs of large polygons are rejected or accepted by them, a tile
/// at a time, without a look at the depth buffer.
///
/// `farthest` holds whatever is drawn, since pixels only come nearer: short runs need not keep it. `nearest` holds as
/// long as large polygons alone drew on the lines: others mark their lines as touched, once a polygon, and nothing is
/// accepted there any more.
template <class Depth>
class DepthBounds {
 public:
  using Word = typename Depth::Word;
  static constexpr std::uint32_t tile_columns = 32;

  [[nodiscard]] static constexpr std::uint32_t tiles_a_line(std::uint32_t width) {
    return (width + tile_columns - 1) / tile_columns;
  }
  /// Words that bounds of a band take.
  [[nodiscard]] static constexpr std::size_t words(std::uint32_t width, std::uint32_t lines) {
    return std::size_t{2} * tiles_a_line(width) * lines;
  }

  DepthBounds() = default;

  /// Takes the words of bands of up to `lines` lines.
  constexpr void take(Arena& arena, std::uint32_t width, std::uint32_t lines) {
    words_ = arena.take<Word>(words(width, lines));
    tiles_ = tiles_a_line(width);
    while (lines > 32u << touched_shift_) ++touched_shift_;
  }

  /// For a band whose depths have been cleared.
  void clear() {
    std::fill(words_.begin(), words_.end(), Depth::clear);
    touched_ = 0;
  }

  /// Lines [first, first + count) of the band are drawn without care for `nearest`.
  void touch(std::int32_t first, std::int32_t count) {
    const std::uint32_t low = word(first) >> touched_shift_, high = word(first + count - 1) >> touched_shift_;
    touched_ |= (~std::uint32_t{0} << low) & (~std::uint32_t{0} >> (31 - high));
  }

  /// Cuts the run [first, end) of columns at tiles and draws what may be seen of it: `draw(column, count, z,
  /// accepted)` is called with the first column and the plane word of each piece. `line` counts from the band's first;
  /// `z` is the plane word at the run's first column and `dz` its step.
  /// `solid`: every pixel that is nearer gets written; surfaces with holes leave what lies behind, and `farthest` as it
  /// is.
  template <class Draw>
  void draw(std::int32_t line, std::uint32_t first, std::uint32_t end, std::uint32_t width, std::uint32_t z,
            std::uint32_t dz, bool solid, Draw draw_piece) {
    const bool may_accept = (touched_ >> (word(line) >> touched_shift_) & 1) == 0;
    Word* bounds = words_.data() + 2 * (word(line) * tiles_ + first / tile_columns);
    for (std::uint32_t column = first; column < end; bounds += 2) {
      const std::uint32_t tile_end = std::min(column / tile_columns * tile_columns + tile_columns, width);
      const std::uint32_t stop = std::min(tile_end, end), count = stop - column;
      const std::uint32_t left = Depth::stored(z), right = Depth::stored(z + dz * (count - 1));
      const bool falls = Depth::hides(right, static_cast<Word>(left));
      const std::uint32_t near = falls ? right : left, far = falls ? left : right;
      Word &farthest = bounds[0], &nearest = bounds[1];
      if (Depth::hides(near, farthest)) {
        draw_piece(column, count, z, may_accept && Depth::hides(far, nearest));
        if (Depth::hides(near, nearest)) nearest = static_cast<Word>(near);
        const bool whole = solid && column % tile_columns == 0 && stop == tile_end;
        if (whole && Depth::hides(far, farthest)) farthest = static_cast<Word>(far);
      }
      z += dz * count;
      column = stop;
    }
  }

 private:
  std::span<Word> words_{};  ///< line by line, tile by tile: farthest, nearest
  std::uint32_t tiles_ = 0;
  int touched_shift_ = 0;      ///< lines a bit of `touched_`, as a power of two
  std::uint32_t touched_ = 0;  ///< groups of lines where `nearest` may be wrong
};

/// A band whose depths have bounds.
template <class Depth, class Pixel>
struct BoundedBandTarget : BandTarget<Depth, Pixel> {
  DepthBounds<Depth>* bounds;
};

/// In the place of bounds where a program has none: no memory, no work.
struct NoDepthBounds {
  constexpr void take(Arena&, std::uint32_t, std::uint32_t) {}
  void clear() {}
};

}  // namespace spanline
