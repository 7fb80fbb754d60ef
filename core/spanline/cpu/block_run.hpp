#pragma once
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "spanline/cpu/armv6m/texel_blocks.hpp"
#include "spanline/cpu/depth_run.hpp"
#include "spanline/cpu/form.hpp"
#include "spanline/cpu/packed_depths.hpp"
#include "spanline/raster/span.hpp"
#include "spanline/raster/surface_blocks.hpp"

namespace spanline {

/// Draws runs against a depth buffer for surfaces that consist of blocks of four pieces of 4 pixels. If the surface can
/// give several whole blocks at once, they are drawn by straight-line code; everything else is drawn piece by piece.
template <class Depth, class Pixel, Form form = Form::fastest>
struct BlockRun {
  using Word = typename Depth::Word;
  using Run = DepthRun<Depth, Pixel, form>;

  /// Draws `count` ≥ 1 pixels from `first` on; `z` is the plane word of the first. `wrap` may replace a source by one
  /// that wraps it, for statistics.
  template <SurfaceInBlocks Surface, class Wrap>
  [[gnu::noinline]] static void run(Word* depth, Pixel* pixels, std::uint32_t count, std::uint32_t z, std::uint32_t dz,
                                    const Surface& surface, std::int32_t first, Wrap wrap) {
    if constexpr (SurfaceInCertainBlocks<Surface> && !wraps<Surface, Wrap>) {
#if defined(__ARM_ARCH_6M__)
      if constexpr (form == Form::fastest && TableSurface<Surface> && sizeof(Word) == 2 && Depth::smaller) {
        if (armv6m::texel_run<BlockRun>(depth, pixels, count, z, dz, surface, first)) return;
        piecewise({depth, pixels, z, dz}, count, surface, first, wrap);
        return;
      }
#endif
      if (for_certain_blocks(
              surface, first, count,
              [&](std::int32_t column, const auto& block, std::uint32_t into, std::uint32_t in_block)
                  __attribute__((always_inline)) {
                    part(depth, pixels, z, dz, surface, column, block, into, in_block);
                    depth += in_block;
                    pixels += in_block;
                    z += in_block * dz;
                  },
              [&](std::int32_t column, const auto* blocks, std::uint32_t some) __attribute__((always_inline)) {
                whole_blocks(depth, pixels, z, dz, surface, column, blocks, some);
                depth += 16 * some;
                pixels += 16 * some;
                z += 16 * some * dz;
              }))
        return;
    }
    piecewise({depth, pixels, z, dz}, count, surface, first, wrap);
  }

  /// Draws `count` pixels of one block from `column` on; the block starts at `column` − `into`.
  template <class Surface, class Steps>
  [[gnu::noinline]] static void part(Word* depth, Pixel* pixels, std::uint32_t z, std::uint32_t dz,
                                     const Surface& surface, std::int32_t column, const Steps& block,
                                     std::uint32_t into, std::uint32_t count) {
    auto source = surface.source(column);
    source.restart(block, into);
    pieces({depth, pixels, z, dz}, source, 4 - (into & 3), count, [&](auto& s) { s.next_piece(block); });
  }
  /// Draws whole blocks.
  template <class Surface, class Steps>
  [[gnu::noinline]] static void whole_blocks(Word* depth, Pixel* pixels, std::uint32_t z, std::uint32_t dz,
                                             const Surface& surface, std::int32_t column, const Steps* blocks,
                                             std::uint32_t count) {
    Place at{depth, pixels, z, dz};
    for (const Steps* const end = blocks + count;;) {
      if constexpr (untouched_pays<Surface>) {
        const Steps* const first = blocks;
        for (; blocks != end && untouched(at.depth); ++blocks, at.depth += 16) put_depths(at);
        if (const auto some = static_cast<std::uint32_t>(blocks - first); some != 0) {
          surface.fill_blocks(column, first, some, at.pixels);
          column += static_cast<std::int32_t>(16 * some);
          at.pixels += 16 * some;
        }
        if (blocks == end) return;
      }
      const Steps* const next = tested_blocks(at, surface, column, blocks, end);
      if (next == end) return;
      const auto done = static_cast<std::uint32_t>(next - blocks) * 16;
      column += static_cast<std::int32_t>(done);
      at = {at.depth + done, at.pixels + done, at.z + done * at.dz, at.dz};
      blocks = next;
    }
  }

 private:
  /// The current position of a run: depth, pixel, and the plane word with its step.
  struct Place {
    Word* depth;
    Pixel* pixels;
    std::uint32_t z, dz;
  };

  template <class Surface, class Wrap>
  static constexpr bool wraps = [] {
    using Source = decltype(std::declval<const Surface&>().blocks(0).source());
    return !std::is_same_v<decltype(std::declval<Wrap>()(std::declval<Source>())), Source>;
  }();

  /// Draws pixels of one block. `piece` pixels of its current piece are left; `next_piece` moves the source on to the
  /// following piece.
  template <class Source, class NextPiece>
  [[gnu::always_inline]] static inline void pieces(Place at, Source source, std::uint32_t piece, std::uint32_t count,
                                                   NextPiece next_piece) {
    for (;;) {
      Run::pixel(at.depth++, at.pixels++, 0, at.z, source);
      if (--count == 0) return;
      at.z += at.dz;
      source.forward();
      if (--piece != 0) continue;
      next_piece(source);
      piece = 4;
    }
  }

  template <SurfaceInBlocks Surface, class Wrap>
  [[gnu::noinline]] static void piecewise(Place at, std::uint32_t count, const Surface& surface, std::int32_t first,
                                          Wrap wrap) {
    auto blocks = surface.blocks(first);
    for (;;) {
      const std::uint32_t in_block = blocks.rest_of_block() < count ? blocks.rest_of_block() : count;
      count -= in_block;
      pieces(at, wrap(blocks.source()), blocks.rest(), in_block, [](auto& source) { source.next_piece(); });
      if (count == 0) return;
      at = {at.depth + in_block, at.pixels + in_block, at.z + in_block * at.dz, at.dz};
      blocks.next();
    }
  }

  /// Draws blocks with a depth test, until a block comes in which nothing has been drawn. Returns the first block not
  /// drawn.
  template <class Surface, class Steps>
  [[gnu::noinline]] static const Steps* tested_blocks(Place at, const Surface& surface, std::int32_t column,
                                                      const Steps* blocks, const Steps* end) {
    auto source = surface.source(column);
    for (;;) {
      source.restart(*blocks);
#pragma GCC unroll 4
      for (std::size_t piece = 0; piece < 4; ++piece) {
#pragma GCC unroll 4
        for (std::size_t i = 0; i < 4; ++i) {
          Run::pixel(at.depth, at.pixels, 4 * piece + i, at.z, source);
          at.z += at.dz;
          source.forward();
        }
        if (piece != 3) source.next_piece(*blocks);
      }
      if (++blocks == end) return blocks;
      at.depth += 16;
      at.pixels += 16;
      if (untouched_pays<Surface> && at.depth[0] == Depth::clear && untouched(at.depth)) return blocks;
      source.next_block();
    }
  }

  /// Whether it pays to look for untouched blocks. With 32-bit depths the depth test costs no more than looking.
  template <class Surface>
  static constexpr bool untouched_pays = sizeof(Word) == 2 &&
                                         !SourceWithHoles<decltype(std::declval<const Surface&>().source(0))>;
  /// Whether nothing has been drawn in a block: all its depths are still clear, so any depth passes the test and none
  /// needs a comparison.
  [[gnu::always_inline]] static inline bool untouched(const Word* depth) {
    using Two [[gnu::may_alias]] = std::uint32_t;
    constexpr std::size_t words = 16 * sizeof(Word) / sizeof(Two);
    constexpr Two clear = Depth::smaller ? ~Two{0} : Two{0};
    if (!aligned(depth)) return false;
    const Two* const block = reinterpret_cast<const Two*>(depth);
    Two all = block[0];
#pragma GCC unroll 16
    for (std::size_t i = 1; i < words; ++i) all = Depth::smaller ? all & block[i] : all | block[i];
    return all == clear;
  }
  [[gnu::always_inline]] static inline bool aligned(const void* place) {
    return (reinterpret_cast<std::uintptr_t>(place) & 3) == 0;
  }
  static_assert(Depth::clear == static_cast<Word>(Depth::smaller ? ~Word{0} : Word{0}));

  /// Writes the depths of a block and steps the plane word to the next block.
  [[gnu::always_inline]] static inline void put_depths(Place& at) {
    if constexpr (in_pairs) {
#pragma GCC unroll 8
      for (std::size_t i = 0; i < 16; i += 2) {
        const std::uint32_t right = at.z + at.dz;
        put_pair(at.depth + i, packed_depths(at.z, right));
        at.z = right + at.dz;
      }
    } else {
#pragma GCC unroll 16
      for (std::size_t i = 0; i < 16; ++i) {
        at.depth[i] = static_cast<Word>(Depth::stored(at.z));
        at.z += at.dz;
      }
    }
  }
  static constexpr bool in_pairs = form == Form::fastest && packing_pays && sizeof(Word) == 2;

  [[gnu::always_inline]] static inline void put_pair(void* place, std::uint32_t pair) {
    using Two [[gnu::may_alias]] = std::uint32_t;
    *static_cast<Two*>(place) = pair;
  }
};

}  // namespace spanline
