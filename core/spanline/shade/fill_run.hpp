#pragma once
#include <cstddef>
#include <cstdint>

#include "spanline/cpu/fill_constant.hpp"
#include "spanline/raster/span.hpp"
#include "spanline/raster/surface_blocks.hpp"

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

/// Fills pixels of one block. `piece` pixels of its current piece are left; `next_piece` moves the source on to the
/// following piece.
template <class Source, class Pixel, class NextPiece>
[[gnu::always_inline]] inline void fill_pieces(Pixel* pixels, Source source, std::uint32_t piece, std::uint32_t count,
                                               NextPiece next_piece) {
  for (;;) {
    put(pixels++, source);
    if (--count == 0) return;
    source.forward();
    if (--piece != 0) continue;
    next_piece(source);
    piece = 4;
  }
}

template <RunBlocks Blocks, class Pixel>
[[gnu::noinline]] void fill_blocks(Pixel* pixels, std::uint32_t count, Blocks blocks) {
  for (;;) {
    const std::uint32_t in_block = blocks.rest_of_block() < count ? blocks.rest_of_block() : count;
    count -= in_block;
    fill_pieces(pixels, blocks.source(), blocks.rest(), in_block, [](auto& source) { source.next_piece(); });
    if (count == 0) return;
    pixels += in_block;
    blocks.next();
  }
}

template <class Surface, class Steps, class Pixel>
[[gnu::noinline]] void fill_part(Pixel* pixels, std::uint32_t count, const Surface& surface, std::int32_t column,
                                 const Steps& block, std::uint32_t into) {
  auto source = surface.source(column);
  source.restart(block, into);
  fill_pieces(pixels, source, 4 - (into & 3), count, [&](auto& s) { s.next_piece(block); });
}

/// Fills whole blocks by straight-line code.
template <class Surface, class Steps, class Pixel>
[[gnu::noinline]] void fill_whole_blocks(Pixel* pixels, std::uint32_t count, const Surface& surface,
                                         std::int32_t column, const Steps* blocks) {
  auto source = surface.source(column);
  for (const Steps* const end = blocks + count;;) {
    const Steps block = *blocks;  // a copy, so that the compiler can keep it in registers
    source.restart(block);
#pragma GCC unroll 4
    for (std::size_t piece = 0; piece < 4; ++piece) {
#pragma GCC unroll 4
      for (std::size_t i = 0; i < 4; ++i) {
        put(pixels + 4 * piece + i, source);
        source.forward();
      }
      if (piece != 3) source.next_piece(block);
    }
    if (++blocks == end) return;
    source.next_block();
    pixels += 16;
  }
}

template <SurfaceInCertainBlocks Surface, class Pixel>
[[gnu::noinline]] void fill_certain_blocks(Pixel* pixels, std::uint32_t count, const Surface& surface,
                                           std::int32_t first) {
  const auto at = [=](std::int32_t column) { return pixels + (column - first); };
  if (for_certain_blocks(
          surface, first, count,
          [&](std::int32_t column, const auto& block, std::uint32_t into, std::uint32_t in_block)
              __attribute__((always_inline)) { fill_part(at(column), in_block, surface, column, block, into); },
          [&](std::int32_t column, const auto* blocks, std::uint32_t some)
              __attribute__((always_inline)) { fill_whole_blocks(at(column), some, surface, column, blocks); }))
    return;
  fill_blocks(pixels, count, surface.blocks(first));
}

}  // namespace fill_detail

/// Fills a run of pixels that a polygon owns, without a depth test, as span algorithms do. Input: the surface, stepped
/// to the run's row; the run's first column, counted as the surface counts columns; its length ≥ 1; the address of its
/// first pixel.
template <class Surface, class Pixel>
[[gnu::always_inline]] inline void fill_run(const Surface& surface, std::int32_t column, std::uint32_t count,
                                            Pixel* pixels) {
  if constexpr (requires { surface.lay(column, count, pixels); }) {
    surface.lay(column, count, pixels);
  } else if constexpr (SurfaceInCertainBlocks<Surface>) {
    fill_detail::fill_certain_blocks(pixels, count, surface, column);
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
