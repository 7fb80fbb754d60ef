#pragma once
#include <concepts>
#include <cstddef>
#include <cstdint>

#include "spanline/raster/span.hpp"
#include "spanline/shade/fill_constant.hpp"

namespace spanline {

/// What a surface of blocks gives in the place of one source: pieces of a run, cut at screen columns that belong to the
/// surface and not to the run, so that a pixel is the same wherever its run begins. It stands at a column; `rest` is
/// how many pixels of the piece are left there, `source` a plain source for them, and `next` goes on to the piece
/// behind it.
template <class B>
concept RunBlocks = requires(B blocks, const B& view) {
  { view.rest() } -> std::convertible_to<std::uint32_t>;
  { view.source() } -> PixelSource;
  blocks.next();
};

/// A surface whose attributes are not linear over the screen (perspective textures): a run is drawn in pieces, each of
/// which is.
template <class S>
concept SurfaceInBlocks = requires(const S& surface, std::int32_t column) {
  { surface.blocks(column) } -> RunBlocks;
};

namespace fill_detail {

template <PixelSource Source, class Pixel>
[[gnu::always_inline]] inline void fill_stepped(Pixel* pixels, std::uint32_t count, Source& source) {
  for (; count >= 4; count -= 4) {
#pragma GCC unroll 4
    for (std::size_t i = 0; i < 4; ++i) {
      pixels[i] = source.get();
      source.forward();
    }
    pixels += 4;
  }
  for (; count != 0; --count) {
    *pixels++ = source.get();
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
