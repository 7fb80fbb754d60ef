#pragma once
#include <cstdint>

#if defined(__arm__)
namespace spanline::armv6m {

/// Writes `count` ≥ 1 times 32 pixels of 16 bits to a word-aligned address; `two` holds the pixel twice. Output: the
/// address of the next pixel. Every Arm core can store four words by one instruction, which compilers do not use for
/// equal words.
template <class Pixel>
[[gnu::always_inline]] inline Pixel* fill_thirty_twos(std::uint32_t two, std::uint32_t count, Pixel* pixels) {
  register std::uint32_t a __asm__("r3") = two;
  register std::uint32_t b __asm__("r4") = two;
  register std::uint32_t c __asm__("r5") = two;
  register std::uint32_t d __asm__("r6") = two;
  __asm__ volatile(
      ".syntax unified\n"
      "0:\n"
      "stmia %[to]!, {r3, r4, r5, r6}\n"
      "stmia %[to]!, {r3, r4, r5, r6}\n"
      "stmia %[to]!, {r3, r4, r5, r6}\n"
      "stmia %[to]!, {r3, r4, r5, r6}\n"
      "subs %[count], #1\n"
      "bne 0b\n"
      : [to] "+l"(pixels), [count] "+l"(count)
      : "r"(a), "r"(b), "r"(c), "r"(d)
      : "cc", "memory");
  return pixels;
}

}  // namespace spanline::armv6m
#endif
