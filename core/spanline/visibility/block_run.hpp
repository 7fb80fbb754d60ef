#pragma once
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "spanline/raster/span.hpp"
#include "spanline/visibility/depth_run.hpp"

namespace spanline {

/// Runs against a depth buffer for surfaces that are drawn in pieces. Whole blocks of four pieces of 4 pixels, where
/// the surface has them, are straight code; anything else goes piece by piece.
template <class Depth, class Pixel>
struct BlockRun {
  using Word = typename Depth::Word;
  using Run = DepthRun<Depth, Pixel>;

  /// `count` pixels ≥ 1; `z` and `blocks` stand at the first. `wrap` may put a source into another (statistics).
  template <RunBlocks Blocks, class Wrap>
  [[gnu::noinline]] static void run(Word* depth, Pixel* pixels, std::uint32_t count, std::uint32_t z, std::uint32_t dz,
                                    Blocks blocks, Wrap wrap) {
    for (;;) {
      if constexpr (WholeBlocks<Blocks> && std::is_same_v<decltype(wrap(blocks.source())), decltype(blocks.source())>) {
        if (count >= 16 && blocks.at_block()) {
          auto certain = blocks.certain(count / 16);
          if (certain.count() != 0) {
            whole_blocks(depth, pixels, z, dz, blocks.source(), certain);
            const std::uint32_t done = 16 * certain.count();
            depth += done;
            pixels += done;
            z += done * dz;
            count -= done;
            if (count == 0) return;
            blocks.leave(certain);
            continue;
          }
        }
      }
      const std::uint32_t in_block = blocks.rest_of_block() < count ? blocks.rest_of_block() : count;
      count -= in_block;
      auto source = wrap(blocks.source());
      std::uint32_t left = in_block, piece = blocks.rest();
      for (;;) {
        if (piece > left) piece = left;
        left -= piece;
        for (; piece != 0; --piece) {
          Run::pixel(depth++, pixels++, 0, z, source);
          z += dz;
          source.forward();
        }
        if (left == 0) break;
        source.bend();
        piece = 4;
      }
      if (count == 0) return;
      blocks.next();
    }
  }

 private:
  template <class Source, class Certain>
  [[gnu::always_inline]] static inline void whole_blocks(Word* depth, Pixel* pixels, std::uint32_t z, std::uint32_t dz,
                                                         Source source, Certain& certain) {
    for (std::uint32_t left = certain.count();;) {
      block(depth, pixels, z, dz, source);
      if (--left == 0) return;
      depth += 16;
      pixels += 16;
      source.restart(certain.next());
    }
  }
  /// Leaves `z` and `source` behind the block.
  template <class Source>
  [[gnu::always_inline]] static inline void block(Word* depth, Pixel* pixels, std::uint32_t& z, std::uint32_t dz,
                                                  Source& source) {
#pragma GCC unroll 4
    for (std::size_t piece = 0; piece < 4; ++piece) {
#pragma GCC unroll 4
      for (std::size_t i = 0; i < 4; ++i) {
        Run::pixel(depth, pixels, 4 * piece + i, z, source);
        z += dz;
        source.forward();
      }
      if (piece != 3) source.bend();
    }
  }
};

}  // namespace spanline
