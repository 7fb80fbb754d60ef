#pragma once
#include <cstddef>
#include <cstdint>

#include "spanline/cpu/armv6m/rows.hpp"

#if defined(__ARM_ARCH_6M__)
namespace spanline::armv6m {

/// The stack frame of ramp_rows: steps that are added to the state at each row, in the order in which a row loads them,
/// and what the triangle's second part needs.
struct RampRowSteps {
  std::uint32_t left, right;  ///< steps of the edges a row, columns, 26 fraction bits
  std::uint32_t width_bytes;  ///< bytes of a row in either buffer
  std::uint32_t z, intensity;
  std::uintptr_t distance;  ///< bytes from a depth to its pixel
  std::int32_t rows_after;  ///< rows of the second part that are still to be drawn
  const ActiveTriangle* triangle;
};
static_assert(sizeof(RampRowSteps) == 32 && offsetof(RampRowSteps, distance) == 20);

/// The words of a RampSurface, in its order.
struct RampSurfaceWords {
  LinearFunction intensity;
  const std::uint16_t* ramp;
};

// clang-format off
// Draws one pixel at a byte offset: 11 instructions, 22 bytes. r0 depth, r1 pixels, r2 plane word, r7 its step, r3
// intensity, r8 its step, which is subtracted, r6 ramp.
#define SPANLINE_PIXEL(offset)                                                 \
  "ldrh r4, [r0, #" #offset "]\n\t"                                            \
  "lsrs r5, r2, #16\n\t"                                                       \
  "cmp r4, r5\n\t"                                                             \
  "bls 1f\n\t"                                                                 \
  "strh r5, [r0, #" #offset "]\n\t"                                            \
  "lsrs r5, r3, #26\n\t"                                                       \
  "lsls r5, r5, #1\n\t"                                                        \
  "ldrh r5, [r6, r5]\n\t"                                                      \
  "strh r5, [r1, #" #offset "]\n\t"                                            \
  "1: subs r2, r2, r7\n\t"                                                     \
  "add r3, r8\n\t"

/// Draws the rows of a small triangle, `rows` before its knee and `rows_after` after it, against a 16-bit depth buffer
/// in which smaller is nearer. An interpolated intensity selects each pixel from a ramp of 64. It does what FixedRows
/// does in C++.
///
/// Runs have at most 21 pixels and go from right to left, by a jump into straight-line code. After a run, plane word
/// and intensity belong to the pixel left of it; two products take them to the right end of the next row. Arithmetic
/// modulo 2^32 makes the result the same as on any other way.
[[gnu::naked, gnu::noinline]] inline void ramp_rows(const ActiveTriangle* /*triangle*/,
                                                    const RampSurfaceWords* /*surface*/,
                                                    const BandTargetWords* /*target*/, std::int32_t /*rows*/,
                                                    std::int32_t /*rows_after*/) {
  // r9 and r10 left and right column, r11 address of the depth of column 0, r12 the same for the row after the part,
  // r14 first column of the run drawn last; the stack pointer is at RampRowSteps.
  __asm__ volatile(
      SPANLINE_ENTER_ROWS(32)
      "ldr r4, [sp, #68]\n\t"  // rows_after
      "str r4, [sp, #24]\n\t"
      "str r5, [sp, #20]\n\t"
      "str r0, [sp, #28]\n\t"
      "movs r7, r0\n\t"
      "adds r7, #32\n\t"
      "ldmia r7!, {r2, r3, r4, r5}\n\t"  // the edges
      "mov r9, r2\n\t"
      "mov r10, r3\n\t"
      "ldmia r0!, {r2, r3, r7}\n\t"  // plane word, its steps
      "mov r0, sp\n\t"
      "stmia r0!, {r4, r5, r6, r7}\n\t"
      "movs r7, r3\n\t"
      "ldmia r1!, {r3, r4, r5, r6}\n\t"  // intensity, its steps, ramp
      "str r5, [r0]\n\t"
      "negs r4, r4\n\t"
      "mov r8, r4\n\t"
      "movs r0, #1\n\t"  // at column 0, as behind a run from column 1 on
      "mov lr, r0\n\t"
      "cmp r11, r12\n\t"
      "beq 2f\n\t"
      "b 4f\n"
      "2: b 5f\n\t"
      SPANLINE_PIXEL(40) SPANLINE_PIXEL(38) SPANLINE_PIXEL(36) SPANLINE_PIXEL(34) SPANLINE_PIXEL(32)
      SPANLINE_PIXEL(30) SPANLINE_PIXEL(28) SPANLINE_PIXEL(26) SPANLINE_PIXEL(24) SPANLINE_PIXEL(22)
      SPANLINE_PIXEL(20) SPANLINE_PIXEL(18) SPANLINE_PIXEL(16) SPANLINE_PIXEL(14) SPANLINE_PIXEL(12)
      SPANLINE_PIXEL(10) SPANLINE_PIXEL(8) SPANLINE_PIXEL(6) SPANLINE_PIXEL(4) SPANLINE_PIXEL(2) SPANLINE_PIXEL(0)
      "3: mov r1, sp\n\t"  // the next row
      "ldmia r1!, {r0, r4, r5}\n\t"
      "add r9, r0\n\t"
      "add r10, r4\n\t"
      "add r11, r5\n\t"
      "ldmia r1!, {r4, r5}\n\t"
      "adds r2, r2, r4\n\t"
      "adds r3, r3, r5\n\t"
      "cmp r11, r12\n\t"
      "beq 5f\n\t"
      "4: mov r0, r9\n\t"  // the run [r0, r4) of this row
      "lsrs r0, r0, #26\n\t"
      "mov r4, r10\n\t"
      "lsrs r4, r4, #26\n\t"
      "subs r5, r0, r4\n\t"
      "bhs 3b\n\t"
      "mov r1, lr\n\t"
      "mov lr, r0\n\t"
      "subs r1, r4, r1\n\t"
      "movs r4, r1\n\t"
      "muls r4, r7\n\t"
      "adds r2, r2, r4\n\t"
      "mov r4, r8\n\t"
      "muls r4, r1\n\t"
      "subs r3, r3, r4\n\t"
      "lsls r0, r0, #1\n\t"
      "add r0, r11\n\t"
      "ldr r1, [sp, #20]\n\t"
      "adds r1, r1, r0\n\t"
      "movs r4, #22\n\t"  // 22 bytes a pixel back from label 3
      "muls r5, r4\n\t"
      SPANLINE_JUMP_FROM_3(68)
      "5:\n\t"
      SPANLINE_SECOND_PART(24, 28, r9, r10)
      SPANLINE_LEAVE_ROWS(32));
}

#undef SPANLINE_PIXEL

// clang-format on

}  // namespace spanline::armv6m
#endif
