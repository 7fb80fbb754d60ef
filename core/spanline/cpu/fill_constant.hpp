#pragma once
#include <cstddef>
#include <cstdint>

#include "spanline/cpu/armv6m/fill_thirty_twos.hpp"
#include "spanline/cpu/form.hpp"

namespace spanline {

namespace fill {

inline constexpr std::uint32_t longest_short_run = 8, longest_medium_run = 32;

/// Fills 1 … 8 pixels by a jump into straight-line code. Most spans of a typical model are that short.
template <class Pixel>
[[gnu::always_inline]] inline void short_run(Pixel value, std::uint32_t count, Pixel* pixels) {
  if (count < 1 || count > longest_short_run) __builtin_unreachable();  // otherwise the compiler tests the range
  switch (count) {
    case 8:
      pixels[7] = value;
      [[fallthrough]];
    case 7:
      pixels[6] = value;
      [[fallthrough]];
    case 6:
      pixels[5] = value;
      [[fallthrough]];
    case 5:
      pixels[4] = value;
      [[fallthrough]];
    case 4:
      pixels[3] = value;
      [[fallthrough]];
    case 3:
      pixels[2] = value;
      [[fallthrough]];
    case 2:
      pixels[1] = value;
      [[fallthrough]];
    case 1:
      pixels[0] = value;
      break;
    default:
      __builtin_unreachable();
  }
}

/// Fills up to 32 pixels of 16 bits at a word-aligned address, two pixels a store.
template <class Pixel>
[[gnu::always_inline]] inline void words(Pixel value, std::uint32_t two, std::uint32_t count, Pixel* pixels) {
  const auto put_two = [&](std::ptrdiff_t at) __attribute__((always_inline)) {
    __builtin_memcpy(static_cast<Pixel*>(__builtin_assume_aligned(pixels, 4)) + at, &two, 4);
  };
  for (; count >= 8; count -= 8, pixels += 8) {
#pragma GCC unroll 4
    for (std::ptrdiff_t at = 0; at < 8; at += 2) put_two(at);
  }
  if ((count & 4) != 0) {
    put_two(0);
    put_two(2);
    pixels += 4;
  }
  if ((count & 2) != 0) {
    put_two(0);
    pixels += 2;
  }
  if ((count & 1) != 0) *pixels = value;
}

/// Fills `count` ≥ 1 times 32 pixels at a word-aligned address. Output: the address of the next pixel.
template <Form form = Form::fastest, class Pixel>
[[gnu::always_inline]] inline Pixel* thirty_twos(std::uint32_t two, std::uint32_t count, Pixel* pixels) {
#if defined(__arm__)
  if constexpr (form == Form::fastest) return armv6m::fill_thirty_twos(two, count, pixels);
#endif
  for (; count > 0; --count, pixels += 32) {
#pragma GCC unroll 16
    for (std::ptrdiff_t at = 0; at < 32; at += 2)
      __builtin_memcpy(static_cast<Pixel*>(__builtin_assume_aligned(pixels, 4)) + at, &two, 4);
  }
  return pixels;
}

template <class Pixel>
inline bool at_word(const Pixel* pixels) {
  return (reinterpret_cast<std::uintptr_t>(pixels) & 2) == 0;
}

/// Fills 9 … 32 pixels of 16 bits.
template <class Pixel>
[[gnu::noinline]] void medium_run(Pixel value, std::uint32_t count, Pixel* pixels) {
  if (!at_word(pixels)) {
    *pixels++ = value;
    --count;
  }
  words(value, value * 0x10001u, count, pixels);
}

/// Fills more than 32 pixels of 16 bits.
template <Form form, class Pixel>
[[gnu::noinline]] void long_run(Pixel value, std::uint32_t count, Pixel* pixels) {
  if (!at_word(pixels)) {
    *pixels++ = value;
    --count;
  }
  const std::uint32_t two = value * 0x10001u;
  pixels = thirty_twos<form>(two, count >> 5, pixels);
  words(value, two, count & 31, pixels);
}

}  // namespace fill

/// Fills `count` ≥ 1 pixels with one value.
template <Form form = Form::fastest, class Pixel>
[[gnu::always_inline]] inline void fill_constant(Pixel value, std::uint32_t count, Pixel* pixels) {
  if constexpr (sizeof(Pixel) == 2) {
    if (count <= fill::longest_short_run)
      fill::short_run(value, count, pixels);
    else if (count <= fill::longest_medium_run)
      fill::medium_run(value, count, pixels);
    else
      fill::long_run<form>(value, count, pixels);
  } else {
    for (; count > 0; --count) *pixels++ = value;
  }
}

}  // namespace spanline
