#pragma once
#include <cstddef>
#include <cstdint>

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
      if constexpr (requires { blocks.next_block(); }) {
        if (count >= 16 && blocks.at_block()) {
          block(depth, pixels, z, dz, wrap(blocks.source()));
          depth += 16;
          pixels += 16;
          z += 16 * dz;
          count -= 16;
          if (count == 0) return;
          blocks.next_block();
          continue;
        }
      }
      const std::uint32_t piece = blocks.rest() < count ? blocks.rest() : count;
      auto source = wrap(blocks.source());
      for (std::size_t i = 0; i < piece; ++i) {
        Run::pixel(depth, pixels, i, z, source);
        z += dz;
        source.forward();
      }
      depth += piece;
      pixels += piece;
      count -= piece;
      if (count == 0) return;
      blocks.next();
    }
  }

 private:
  template <class Source>
  [[gnu::always_inline]] static inline void block(Word* depth, Pixel* pixels, std::uint32_t z, std::uint32_t dz,
                                                  Source source) {
#pragma GCC unroll 4
    for (std::size_t piece = 0; piece < 4; ++piece) {
#pragma GCC unroll 4
      for (std::size_t i = 0; i < 4; ++i) {
        Run::pixel(depth, pixels, 4 * piece + i, z, source);
        z += dz;
        source.forward();
      }
      source.bend();
    }
  }
};

}  // namespace spanline
