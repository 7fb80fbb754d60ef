#pragma once
#include <cstddef>
#include <cstdint>

#include "spanline/cpu/dsp/paired_depths.hpp"
#include "spanline/cpu/form.hpp"
#include "spanline/raster/span.hpp"

namespace spanline {

/// Draws runs of pixels against a depth buffer: the inner loops of the z-buffers.
///
/// A pixel source (shade/) gives the current pixel; these loops do not depend on how. `z` is the plane word at the
/// first pixel and `dz` its step a column.
template <class Depth, class Pixel, Form form = Form::fastest>
struct DepthRun {
  using Word = typename Depth::Word;
  static constexpr std::uint32_t short_limit = 21;  ///< longest row of a small triangle, pixels

  /// Draws one pixel if it is nearer.
  template <PixelSource Source>
  [[gnu::always_inline]] static inline void pixel(Word* depth, Pixel* pixels, std::size_t i, std::uint32_t z,
                                                  const Source& source) {
    const std::uint32_t candidate = Depth::stored(z);
    if (__builtin_expect(Depth::hides(candidate, depth[i]), true)) {
      keep_branch();
      if constexpr (SourceWithHoles<Source>) {
        if (!source.present()) return;
      }
      depth[i] = static_cast<Word>(candidate);
      pixels[i] = source.get();
    }
  }

  /// Draws 1 … 21 pixels from right to left by a jump into straight-line code, which needs no loop and no remainder.
  /// `z` and `source` are those of the last pixel.
  template <PixelSource Source>
  [[gnu::always_inline]] static inline void short_run(Word* depth, Pixel* pixels, std::uint32_t count, std::uint32_t z,
                                                      std::uint32_t dz, Source source) {
    const auto step = [&](std::size_t i) __attribute__((always_inline)) {
      pixel(depth, pixels, i, z, source);
      z -= dz;
      source.back();
    };
    if (count - 1 >= short_limit) __builtin_unreachable();  // otherwise the compiler tests the range in every row
    switch (count) {
      case 21:
        step(20);
        [[fallthrough]];
      case 20:
        step(19);
        [[fallthrough]];
      case 19:
        step(18);
        [[fallthrough]];
      case 18:
        step(17);
        [[fallthrough]];
      case 17:
        step(16);
        [[fallthrough]];
      case 16:
        step(15);
        [[fallthrough]];
      case 15:
        step(14);
        [[fallthrough]];
      case 14:
        step(13);
        [[fallthrough]];
      case 13:
        step(12);
        [[fallthrough]];
      case 12:
        step(11);
        [[fallthrough]];
      case 11:
        step(10);
        [[fallthrough]];
      case 10:
        step(9);
        [[fallthrough]];
      case 9:
        step(8);
        [[fallthrough]];
      case 8:
        step(7);
        [[fallthrough]];
      case 7:
        step(6);
        [[fallthrough]];
      case 6:
        step(5);
        [[fallthrough]];
      case 5:
        step(4);
        [[fallthrough]];
      case 4:
        step(3);
        [[fallthrough]];
      case 3:
        step(2);
        [[fallthrough]];
      case 2:
        step(1);
        [[fallthrough]];
      case 1:
        step(0);
        break;
      default:
        __builtin_unreachable();
    }
  }

  /// Draws any number of pixels ≥ 1; `z` and `source` are those of the first.
  template <PixelSource Source>
  [[gnu::noinline]] static void long_run(Word* depth, Pixel* pixels, std::uint32_t count, std::uint32_t z,
                                         std::uint32_t dz, Source source) {
    if constexpr (Source::constant) {
      if (dz == 0) return constant_run(depth, pixels, count, z, source.get());
    }
    if constexpr (pairs_fit<Source>) {
      paired(depth, pixels, count, z, dz, source);
    } else {
      for (; count > unrolled; count -= unrolled) {
#pragma GCC unroll 16
        for (std::size_t i = 0; i < unrolled; ++i) {
          pixel(depth, pixels, i, z, source);
          z += dz;
          source.forward();
        }
        depth += unrolled;
        pixels += unrolled;
      }
    }
    if (count != 0) short_run_from_left(depth, pixels, count, z, dz, source);
  }

  /// Draws a run by whichever of the two suits its length.
  template <PixelSource Source>
  static inline void run(Word* depth, Pixel* pixels, std::uint32_t count, std::uint32_t z, std::uint32_t dz,
                         Source source) {
    if (count <= short_limit)
      short_run_from_left(depth, pixels, count, z, dz, source);
    else
      long_run(depth, pixels, count, z, dz, source);
  }

  /// Draws pixels that are known to be nearer than the depth buffer, without a comparison. `z` and `source` are those
  /// of the first pixel.
  template <PixelSource Source>
  [[gnu::noinline]] static void accepted_run(Word* depth, Pixel* pixels, std::uint32_t count, std::uint32_t z,
                                             std::uint32_t dz, Source source) {
    const auto put = [&](std::size_t i) __attribute__((always_inline)) {
      depth[i] = static_cast<Word>(Depth::stored(z));
      pixels[i] = source.get();
      z += dz;
      source.forward();
    };
    for (; count >= 8; count -= 8) {
#pragma GCC unroll 8
      for (std::size_t i = 0; i < 8; ++i) put(i);
      depth += 8;
      pixels += 8;
    }
    for (std::size_t i = 0; i < count; ++i) put(i);
  }

  /// Draws a run of constant depth and constant pixel.
  static inline void constant_run(Word* depth, Pixel* pixels, std::uint32_t count, std::uint32_t z, Pixel colour) {
    const std::uint32_t candidate = Depth::stored(z);
    const auto put = [&](std::size_t i) __attribute__((always_inline)) {
      if (__builtin_expect(Depth::hides(candidate, depth[i]), true)) {
        keep_branch();
        depth[i] = static_cast<Word>(candidate);
        pixels[i] = colour;
      }
    };
    for (; count >= unrolled; count -= unrolled) {
#pragma GCC unroll 16
      for (std::size_t i = 0; i < unrolled; ++i) put(i);
      depth += unrolled;
      pixels += unrolled;
    }
    for (; count != 0; --count) {
      put(0);
      ++depth;
      ++pixels;
    }
  }

 private:
  static constexpr std::uint32_t unrolled = 16;  ///< pixels in the body of an unrolled loop

  /// Forces a branch around the stores of a rejected pixel. Thumb-2 compilers would otherwise predicate the stores, and
  /// then a rejected pixel would cost as much as a written one.
  static inline void keep_branch() {
#if defined(__thumb2__)
    __asm__ volatile("");
#endif
  }

  template <PixelSource Source>
  static inline void short_run_from_left(Word* depth, Pixel* pixels, std::uint32_t count, std::uint32_t z,
                                         std::uint32_t dz, Source& source) {
    if constexpr (Source::constant) {
      short_run(depth, pixels, count, z + dz * (count - 1), dz, source);
    } else {
      for (std::size_t i = 0; i < count; ++i) {
        pixel(depth, pixels, i, z, source);
        z += dz;
        source.forward();
      }
    }
  }

#if defined(__ARM_FEATURE_SIMD32)
  /// Whether two pixels can be tested at once.
  template <PixelSource Source>
  static constexpr bool pairs_fit = form == Form::fastest&& Source::constant && sizeof(Word) == 2 &&
                                    sizeof(Pixel) == 2 && Depth::smaller;

  /// Draws whole groups of eight pixels and advances the arguments to the rest of the run.
  template <PixelSource Source>
  [[gnu::always_inline]] static inline void paired(Word*& depth, Pixel*& pixels, std::uint32_t& count, std::uint32_t& z,
                                                   std::uint32_t dz, const Source& source) {
    if (reinterpret_cast<std::uintptr_t>(depth) & 2) {
      pixel(depth, pixels, 0, z, source);
      z += dz;
      ++depth;
      ++pixels;
      --count;
    }
    dsp::paired_depths(depth, pixels, count, z, dz, source.get());
  }
#else
  template <PixelSource Source>
  static constexpr bool pairs_fit = false;
#endif
};

}  // namespace spanline
