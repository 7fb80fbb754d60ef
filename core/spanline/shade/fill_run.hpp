#pragma once
#include <cstddef>
#include <cstdint>

#include "spanline/raster/span.hpp"
#include "spanline/shade/fill_constant.hpp"

namespace spanline {

namespace fill_detail {

template <PixelSource Source, class Pixel>
[[gnu::always_inline]] inline void put(Pixel* pixel, const Source& source) {
  if constexpr (SourceWithHoles<Source>) {
    if (!source.present()) return;
  }
  *pixel = source.get();
}

template <PixelSource Source, class Pixel>
[[gnu::always_inline]] inline void fill_stepped(Pixel* pixels, std::uint32_t count, Source& source) {
  for (; count >= 4; count -= 4) {
#pragma GCC unroll 4
    for (std::size_t i = 0; i < 4; ++i) {
      put(pixels + i, source);
      source.forward();
    }
    pixels += 4;
  }
  for (; count != 0; --count) {
    put(pixels++, source);
    source.forward();
  }
}

template <PixelSource Source, class Pixel>
[[gnu::noinline]] void fill_stepped_run(Pixel* pixels, std::uint32_t count, Source source) {
  fill_stepped(pixels, count, source);
}

/// Whole blocks are straight code.
template <class Source, class Certain, class Pixel>
[[gnu::always_inline]] inline void fill_whole_blocks(Pixel* pixels, Source source, Certain& certain) {
  for (std::uint32_t left = certain.count();;) {
#pragma GCC unroll 4
    for (std::size_t piece = 0; piece < 4; ++piece) {
#pragma GCC unroll 4
      for (std::size_t i = 0; i < 4; ++i) {
        put(pixels + 4 * piece + i, source);
        source.forward();
      }
      if (piece != 3) source.bend();
    }
    if (--left == 0) return;
    pixels += 16;
    source.restart(certain.next());
  }
}

template <RunBlocks Blocks, class Pixel>
[[gnu::noinline]] void fill_blocks(Pixel* pixels, std::uint32_t count, Blocks blocks) {
  for (;;) {
    if constexpr (WholeBlocks<Blocks>) {
      if (count >= 16 && blocks.at_block()) {
        auto certain = blocks.certain(count / 16);
        if (certain.count() != 0) {
          fill_whole_blocks(pixels, blocks.source(), certain);
          pixels += 16 * certain.count();
          count -= 16 * certain.count();
          if (count == 0) return;
          blocks.leave(certain);
          continue;
        }
      }
    }
    const std::uint32_t in_block = blocks.rest_of_block() < count ? blocks.rest_of_block() : count;
    count -= in_block;
    auto source = blocks.source();
    std::uint32_t left = in_block, piece = blocks.rest();
    for (;;) {
      if (piece > left) piece = left;
      left -= piece;
      for (; piece != 0; --piece) {
        put(pixels++, source);
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

}  // namespace fill_detail

/// Fills a run of pixels that a polygon owns, without a depth test: what span algorithms do. Input: the surface on the
/// run's row; the run's first column, as the surface counts columns; its length ≥ 1; where its first pixel
/// lies in memory.
template <class Surface, class Pixel>
[[gnu::always_inline]] inline void fill_run(const Surface& surface, std::int32_t column, std::uint32_t count,
                                            Pixel* pixels) {
  if constexpr (requires { surface.lay(column, count, pixels); }) {
    surface.lay(column, count, pixels);
  } else if constexpr (SurfaceInBlocks<Surface>) {
    fill_detail::fill_blocks(pixels, count, surface.blocks(column));
  } else {
    const auto source = surface.source(column);
    if constexpr (decltype(source)::constant)
      fill_constant(source.get(), count, pixels);
    else
      fill_detail::fill_stepped_run(pixels, count, source);
  }
}

}  // namespace spanline
