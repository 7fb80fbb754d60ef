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

template <RunBlocks Blocks, class Pixel>
[[gnu::noinline]] void fill_blocks(Pixel* pixels, std::uint32_t count, Blocks blocks) {
  for (;;) {
    const std::uint32_t piece = blocks.rest() < count ? blocks.rest() : count;
    auto source = blocks.source();
    fill_stepped(pixels, piece, source);
    pixels += piece;
    count -= piece;
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
  if constexpr (SurfaceInBlocks<Surface>) {
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
