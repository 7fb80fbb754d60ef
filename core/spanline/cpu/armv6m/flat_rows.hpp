#pragma once
#include <cstddef>
#include <cstdint>

#include "spanline/cpu/armv6m/rows.hpp"

#if defined(__ARM_ARCH_6M__)
namespace spanline::armv6m {

/// The stack frame of flat rows: steps that are added to the state at each row, in the order in which a row loads them,
/// and what the triangle's second part needs.
struct FlatRowSteps {
  std::uint32_t left, right;  ///< steps of the edges a row, columns, 26 or 24 fraction bits
  std::uint32_t width_bytes;  ///< bytes of a row in either buffer
  std::uint32_t z;
  std::int32_t rows_after;  ///< rows of the second part that are still to be drawn
  const ActiveTriangle* triangle;
};
static_assert(sizeof(FlatRowSteps) == 24 && offsetof(FlatRowSteps, rows_after) == 16);

// clang-format off
// Draws one pixel at a byte offset: 7 instructions, 14 bytes. r0 depth, r1 pixels, r2 plane word, r3 its step, r6 pixel
// value.
#define SPANLINE_PIXEL(offset)                                                 \
  "ldrh r4, [r0, #" #offset "]\n\t"                                            \
  "lsrs r5, r2, #16\n\t"                                                       \
  "cmp r4, r5\n\t"                                                             \
  "bls 1f\n\t"                                                                 \
  "strh r5, [r0, #" #offset "]\n\t"                                            \
  "strh r6, [r1, #" #offset "]\n\t"                                            \
  "1: subs r2, r2, r3\n\t"

#define SPANLINE_PIXELS_16                                                     \
  SPANLINE_PIXEL(30) SPANLINE_PIXEL(28) SPANLINE_PIXEL(26) SPANLINE_PIXEL(24)  \
  SPANLINE_PIXEL(22) SPANLINE_PIXEL(20) SPANLINE_PIXEL(18) SPANLINE_PIXEL(16)  \
  SPANLINE_PIXEL(14) SPANLINE_PIXEL(12) SPANLINE_PIXEL(10) SPANLINE_PIXEL(8)   \
  SPANLINE_PIXEL(6) SPANLINE_PIXEL(4) SPANLINE_PIXEL(2) SPANLINE_PIXEL(0)

// Loads the state of a triangle: r8 and r9 left and right column, r10 plane word of column 0, r11 address of its depth,
// r12 the same for the row after the part, r7 bytes from a depth to its pixel, r3 and r6 as above, the stack pointer at
// FlatRowSteps. Jumps to 2 if the first part is empty.
#define SPANLINE_ENTER_FLAT_ROWS                                               \
  SPANLINE_ENTER_ROWS(24)                                                      \
  "mov r14, r1\n\t"                                                            \
  "ldr r4, [sp, #60]\n\t"  /* rows_after */                                    \
  "str r4, [sp, #16]\n\t"                                                      \
  "str r0, [sp, #20]\n\t"                                                      \
  "movs r7, r5\n\t"                                                            \
  "ldmia r0!, {r1, r3, r4}\n\t"                                                \
  "mov r10, r1\n\t"                                                            \
  "str r4, [sp, #12]\n\t"                                                      \
  "adds r0, #20\n\t"                                                           \
  "ldmia r0!, {r1, r2, r4, r5}\n\t"                                            \
  "mov r8, r1\n\t"                                                             \
  "mov r9, r2\n\t"                                                             \
  "mov r0, sp\n\t"                                                             \
  "stmia r0!, {r4, r5, r6}\n\t"                                                \
  "mov r6, r14\n\t"                                                            \
  "cmp r11, r12\n\t"                                                           \
  "beq 2f\n\t"

#define SPANLINE_NEXT_ROW                                                      \
  "mov r1, sp\n\t"                                                             \
  "ldmia r1!, {r0, r2, r4, r5}\n\t"                                            \
  "add r8, r0\n\t"                                                             \
  "add r9, r2\n\t"                                                             \
  "add r11, r4\n\t"                                                            \
  "add r10, r5\n\t"                                                            \
  "cmp r11, r12\n\t"                                                           \
  "beq 5f\n\t"

// Finds the row's run [r0, r4); r5 is its negated length. Jumps to `next` if the run is empty. Leaves the plane word of
// the last pixel in r2.
#define SPANLINE_FIND_RUN(fraction_bits, next)                                 \
  "mov r0, r8\n\t"                                                             \
  "lsrs r0, r0, #" #fraction_bits "\n\t"                                       \
  "mov r4, r9\n\t"                                                             \
  "lsrs r4, r4, #" #fraction_bits "\n\t"                                       \
  "subs r5, r0, r4\n\t"                                                        \
  "bhs " #next "\n\t"                                                          \
  "subs r2, r4, #1\n\t"                                                        \
  "muls r2, r3\n\t"                                                            \
  "add r2, r10\n\t"                                                            \
  "lsls r0, r0, #1\n\t"                                                        \
  "add r0, r11\n\t"

// Jumps to the code of the last −r5 pixels before label 3, which lies `distance` bytes before where the jump counts from.
#define SPANLINE_ENTER_PIXELS(distance)                                        \
  "movs r4, #14\n\t"                                                           \
  "muls r5, r4\n\t"                                                            \
  SPANLINE_JUMP_FROM_3(distance)

/// Draws the rows of a small triangle in one pixel value, `rows` before its knee and `rows_after` after it, against a
/// 16-bit depth buffer in which smaller is nearer. It does what FixedRows does in C++, with every quantity of the loop
/// in a register. Runs have at most 21 pixels and go from right to left, by a jump into straight-line code.
[[gnu::naked, gnu::noinline]] inline void flat_rows_short(const ActiveTriangle* /*triangle*/, std::uint32_t /*pixel*/,
                                                          const BandTargetWords* /*target*/, std::int32_t /*rows*/,
                                                          std::int32_t /*rows_after*/) {
  __asm__ volatile(SPANLINE_ENTER_FLAT_ROWS
                   "b 4f\n"
                   "2: b 5f\n\t"
                   SPANLINE_PIXEL(40) SPANLINE_PIXEL(38) SPANLINE_PIXEL(36) SPANLINE_PIXEL(34) SPANLINE_PIXEL(32)
                   SPANLINE_PIXELS_16
                   "3:\n\t"
                   SPANLINE_NEXT_ROW
                   "4:\n\t"
                   SPANLINE_FIND_RUN(26, 3b)
                   "adds r1, r0, r7\n\t"
                   SPANLINE_ENTER_PIXELS(50)
                   "5:\n\t"
                   SPANLINE_SECOND_PART(16, 20, r8, r9)
                   SPANLINE_LEAVE_ROWS(24));
}

/// The same for a medium triangle, whose rows may have any length. They are drawn in blocks of 16 pixels; the rightmost
/// block has the remaining 1 … 16.
[[gnu::naked, gnu::noinline]] inline void flat_rows_long(const ActiveTriangle* /*triangle*/, std::uint32_t /*pixel*/,
                                                         const BandTargetWords* /*target*/, std::int32_t /*rows*/,
                                                         std::int32_t /*rows_after*/) {
  // r14 bytes from a depth to its pixel; r7 number of blocks left of the current one.
  __asm__ volatile(SPANLINE_ENTER_FLAT_ROWS
                   "mov r14, r7\n\t"
                   "b 4f\n"
                   "2: mov r14, r7\n\t"
                   "b 5f\n"
                   "8:\n\t"
                   SPANLINE_PIXELS_16
                   "3: subs r7, #1\n\t"
                   "bmi 2f\n\t"
                   "subs r0, #32\n\t"
                   "subs r1, #32\n\t"
                   "b 8b\n"
                   "2:\n\t"
                   SPANLINE_NEXT_ROW
                   "4:\n\t"
                   SPANLINE_FIND_RUN(24, 2b)
                   "mvns r4, r5\n\t"  // whole blocks before the run's right end, which has 1 … 16 pixels
                   "lsrs r7, r4, #4\n\t"
                   "lsls r1, r7, #4\n\t"
                   "adds r5, r5, r1\n\t"
                   "lsls r1, r1, #1\n\t"
                   "adds r0, r0, r1\n\t"
                   "mov r1, r14\n\t"
                   "add r1, r0\n\t"
                   SPANLINE_ENTER_PIXELS(74)
                   "5:\n\t"
                   SPANLINE_SECOND_PART(16, 20, r8, r9)
                   SPANLINE_LEAVE_ROWS(24));
}

#undef SPANLINE_PIXELS_16
#undef SPANLINE_ENTER_FLAT_ROWS
#undef SPANLINE_NEXT_ROW
#undef SPANLINE_FIND_RUN
#undef SPANLINE_ENTER_PIXELS
#undef SPANLINE_PIXEL

// clang-format on

}  // namespace spanline::armv6m
#endif
