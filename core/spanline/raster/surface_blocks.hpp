#pragma once
#include <concepts>
#include <cstdint>

#include "spanline/raster/span.hpp"

namespace spanline {

/// What a surface of blocks gives in the place of one source: a run cut at screen columns that belong to the surface
/// and not to the run, so that a pixel is the same wherever its run begins. It stands at a column; `rest_of_block` is
/// how many pixels one source serves from there, to the end of 16 columns or, where the attributes are linear, of the
/// row; `next` goes on behind them. Inside the block are pieces of 4
/// pixels, of which `rest` are left in the first; from one to the next the source is told to `next_piece`.
template <class B>
concept RunBlocks = requires(B blocks, const B& view) {
  { view.rest() } -> std::convertible_to<std::uint32_t>;
  { view.rest_of_block() } -> std::convertible_to<std::uint32_t>;
  { view.source() } -> PixelSource;
  view.source().next_piece();
  blocks.next();
};

/// A surface whose attributes are not linear over the screen (perspective textures): a run is drawn in pieces, each of
/// which is.
template <class S>
concept SurfaceInBlocks = requires(const S& surface, std::int32_t column) {
  { surface.blocks(column) } -> RunBlocks;
};

/// Calls visit(source) for each of the `count` ≥ 1 pixels from where `blocks` stands.
template <RunBlocks Blocks, class Visit>
[[gnu::always_inline]] inline void for_each_pixel(Blocks blocks, std::uint32_t count, Visit visit) {
  constexpr std::uint32_t columns_a_piece = 4;  // behind the first of a block
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

/// A surface whose blocks of 16 columns can be had some at a time: `certain(column, count)` says whether those of a run
/// can, and has the first at hand. `source(column)` then wants a block: it takes one up with `restart(block)`, where it
/// stands at the block's start, and with `restart(block, into)` at a column of it; goes from piece to piece by
/// `next_piece(block)`; and is told of the `next_block()`. `fill_blocks` draws whole ones without a depth test.
template <class S>
concept SurfaceInCertainBlocks = SurfaceInBlocks<S> && requires(const S& surface, std::int32_t column) {
  { surface.certain(column, 1u).certain() } -> std::convertible_to<bool>;
  { surface.source(column) } -> PixelSource;
};

/// Goes through the blocks of a run of `count` ≥ 1 pixels: part(column, block, into, pixels) for those that the run
/// cuts, `into` columns of which lie before it; whole(column, blocks, count) for whole ones. False, with nothing done,
/// where the surface cannot give them.
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
