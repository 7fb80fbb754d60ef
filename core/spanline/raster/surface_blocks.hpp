#pragma once
#include <concepts>
#include <cstdint>

#include "spanline/raster/span.hpp"

namespace spanline {

/// A run of a surface in blocks, in place of one source. The run is cut at screen columns that depend on the surface
/// and not on the run, so that a pixel is the same wherever its run begins. `rest_of_block` is the number of pixels
/// from the current column on that one source gives: to the end of a block of 16 columns or, where the attributes are
/// linear, to the end of the row. `next` moves to the block after that. A block has pieces of 4 pixels, of which `rest`
/// are left in the first; `next_piece` of the source moves from one piece to the next.
template <class B>
concept RunBlocks = requires(B blocks, const B& view) {
  { view.rest() } -> std::convertible_to<std::uint32_t>;
  { view.rest_of_block() } -> std::convertible_to<std::uint32_t>;
  { view.source() } -> PixelSource;
  view.source().next_piece();
  blocks.next();
};

/// A surface whose attributes are not linear over the screen (perspective textures). A run of it is drawn in pieces in
/// which they are linear.
template <class S>
concept SurfaceInBlocks = requires(const S& surface, std::int32_t column) {
  { surface.blocks(column) } -> RunBlocks;
};

/// Calls visit(source) for each of `count` ≥ 1 pixels, from the current column of `blocks` on.
template <RunBlocks Blocks, class Visit>
[[gnu::always_inline]] inline void for_each_pixel(Blocks blocks, std::uint32_t count, Visit visit) {
  constexpr std::uint32_t columns_a_piece = 4;  // in every piece after the first
  for (;;) {
    std::uint32_t left = blocks.rest_of_block() < count ? blocks.rest_of_block() : count, piece = blocks.rest();
    count -= left;
    auto source = blocks.source();
    for (;;) {
      if (piece > left) piece = left;
      left -= piece;
      for (; piece != 0; --piece) {
        visit(source);
        source.forward();
      }
      if (left == 0) break;
      source.next_piece();
      piece = columns_a_piece;
    }
    if (count == 0) return;
    blocks.next();
  }
}

/// A surface whose blocks of 16 columns can be computed in batches. `certain(column, count)` tells whether the blocks
/// of a run can, and computes the first batch. A source from `source(column)` draws from such blocks: `restart(block)`
/// sets it to a block's start, `restart(block, into)` to a column inside the block; `next_piece(block)` moves to the
/// block's next piece, and `next_block()` to the next block. `fill_blocks` draws whole blocks without a depth test.
template <class S>
concept SurfaceInCertainBlocks = SurfaceInBlocks<S> && requires(const S& surface, std::int32_t column) {
  { surface.certain(column, 1u).certain() } -> std::convertible_to<bool>;
  { surface.source(column) } -> PixelSource;
};

/// Visits the blocks of a run of `count` ≥ 1 pixels. Calls part(column, block, into, pixels) for a block of which the
/// run covers only `pixels` columns, `into` columns after the block's start; calls whole(column, blocks, count) for
/// `count` whole blocks. Returns false and does nothing if the surface cannot compute the blocks in batches.
template <SurfaceInCertainBlocks Surface, class Part, class Whole>
[[gnu::always_inline]] inline bool for_certain_blocks(const Surface& surface, std::int32_t column, std::uint32_t count,
                                                      Part part, Whole whole) {
  auto certain = surface.certain(column, count);
  if (!certain.certain()) return false;
  constexpr std::uint32_t block_columns = 16;
  std::uint32_t into = certain.into_block();
  const auto* next = certain.blocks();
  do {
    std::uint32_t wholes = certain.count();
    next = certain.blocks();
    if (into != 0) {
      const std::uint32_t pixels = block_columns - into < count ? block_columns - into : count;
      part(column, *next++, into, pixels);
      column += static_cast<std::int32_t>(pixels);
      count -= pixels;
      --wholes;
      into = 0;
    }
    if (wholes * block_columns > count) --wholes;
    if (wholes == 0) continue;
    whole(column, next, wholes);
    column += static_cast<std::int32_t>(wholes * block_columns);
    count -= wholes * block_columns;
    next += wholes;
  } while (certain.next());
  if (count != 0) part(column, *next, 0, count);
  return true;
}

}  // namespace spanline
