#pragma once
/// @file
/// Depth bounds of tiles, after Greene, Kass and Miller, "Hierarchical Z-Buffer Visibility" (1993), and lecture 002;
/// here with one level and with near bounds as well.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "spanline/memory/arena.hpp"
#include "spanline/raster/linear_function.hpp"
#include "spanline/visibility/band_target.hpp"

namespace spanline {

/// Depth bounds for tiles, each of 32 columns of one line. No pixel of a tile is farther than its `farthest` bound, and
/// none is nearer than its `nearest` bound. Runs of large polygons are rejected or accepted a tile at a time by the
/// bounds, without reading the depth buffer.
///
/// The bound `farthest` stays valid whatever is drawn, since pixels only become nearer, so small polygons need not
/// update it. The bound `nearest` is valid only on lines where large polygons alone have drawn. Other polygons mark
/// their lines as touched, and on touched lines no run is accepted.
template <class Depth>
class DepthBounds {
 public:
  using Word = typename Depth::Word;
  static constexpr std::uint32_t tile_columns = 32;

  [[nodiscard]] static constexpr std::uint32_t tiles_a_line(std::uint32_t width) {
    return (width + tile_columns - 1) / tile_columns;
  }
  /// Number of words that the bounds of a band take.
  [[nodiscard]] static constexpr std::size_t words(std::uint32_t width, std::uint32_t lines) {
    return std::size_t{2} * tiles_a_line(width) * lines;
  }

  DepthBounds() = default;

  /// Takes memory for bands of up to `lines` lines.
  constexpr void take(Arena& arena, std::uint32_t width, std::uint32_t lines) {
    words_ = arena.take<Word>(words(width, lines));
    tiles_ = tiles_a_line(width);
    while (lines > 32u << touched_shift_) ++touched_shift_;
  }

  /// Resets the bounds, for a band whose depths have been cleared.
  void clear() {
    std::fill(words_.begin(), words_.end(), Depth::clear);
    touched_ = 0;
  }

  /// Marks lines [first, first + count) of the band as drawn without an update of `nearest`.
  void touch(std::int32_t first, std::int32_t count) {
    const std::uint32_t low = word(first) >> touched_shift_, high = word(first + count - 1) >> touched_shift_;
    touched_ |= (~std::uint32_t{0} << low) & (~std::uint32_t{0} >> (31 - high));
  }

  /// Cuts the run of columns [first, end) at tiles and draws the pieces that may be visible: `draw_piece(column, count,
  /// z, accepted)` gets each piece's first column, its number of pixels and its plane word there; `accepted` says that
  /// it needs no depth test. `line` counts from the first line of the band. `z` is the plane word at the run's first
  /// column and `dz` its step a column. `solid` says that every nearer pixel is written; surfaces with holes must not
  /// move `farthest`.
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
  std::span<Word> words_{};    ///< the bounds `farthest` and `nearest` of each tile, tile by tile and line by line
  std::uint32_t tiles_ = 0;    ///< tiles a line
  int touched_shift_ = 0;      ///< log2 of the lines that share a bit of `touched_`
  std::uint32_t touched_ = 0;  ///< bit i: the bounds `nearest` may be wrong on the i-th group of lines
};

/// A band of the picture with depth bounds.
template <class Depth, class Pixel>
struct BoundedBandTarget : BandTarget<Depth, Pixel> {
  DepthBounds<Depth>* bounds;
};

/// Takes the place of DepthBounds in programs without bounds. It takes neither memory nor time.
struct NoDepthBounds {
  constexpr void take(Arena&, std::uint32_t, std::uint32_t) {}
  void clear() {}
};

}  // namespace spanline
