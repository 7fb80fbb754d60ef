#pragma once
#include <cstddef>
#include <cstdint>

#if defined(__ARM_ARCH_6M__)
namespace spanline::armv6m {

/// The rows of a small triangle between two bends whose pixels come from a ramp of 64 by an interpolated intensity;
/// otherwise as FlatRows.
struct RampRows {
  std::uint32_t left, right;     ///< columns of the row, 26 fraction bits
  std::uint16_t* depth;          ///< the row's column 0
  std::uintptr_t distance;       ///< bytes from a depth to its pixel
  std::uint32_t intensity_back;  ///< intensity step of a column to the left
  const std::uint16_t* ramp;
  std::uint32_t dz;            ///< of a column
  std::int32_t rows;           ///< ≥ 1
  std::uint32_t z, intensity;  ///< at column 0 of the row
  std::uint32_t dz_row, intensity_row;
  std::uint32_t left_step, right_step;
  std::uint32_t width_bytes;  ///< of a row

  /// Draws the rows, 21 pixels at most, and stands on the one behind them.
  [[gnu::always_inline]] void draw();
};
static_assert(offsetof(RampRows, rows) == 28 && offsetof(RampRows, z) == 32 && offsetof(RampRows, left_step) == 48);

// clang-format off
// A pixel at a byte offset: r0 depth, r1 pixels, r2 plane word, r7 its step, r3 intensity, r8 its step back, r6 the
// ramp. Eleven instructions, 22 bytes.
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

inline void RampRows::draw() {
  register RampRows* self __asm__("r0") = this;
  // r9 and r10 columns, r11 depth of column 0, r12 distance, r14 the rows left and what is behind them.
  __asm__ volatile(
      ".syntax unified\n\t"
      "ldmia r0!, {r1, r2, r4, r5}\n\t"
      "mov r9, r1\n\t"
      "mov r10, r2\n\t"
      "mov r11, r4\n\t"
      "mov r12, r5\n\t"
      "ldmia r0!, {r1, r6, r7}\n\t"
      "mov r8, r1\n\t"
      "mov lr, r0\n\t"
      "b 4f\n\t"
      // Right to left, entered at the run's last pixel.
      SPANLINE_PIXEL(40) SPANLINE_PIXEL(38) SPANLINE_PIXEL(36) SPANLINE_PIXEL(34) SPANLINE_PIXEL(32)
      SPANLINE_PIXEL(30) SPANLINE_PIXEL(28) SPANLINE_PIXEL(26) SPANLINE_PIXEL(24) SPANLINE_PIXEL(22)
      SPANLINE_PIXEL(20) SPANLINE_PIXEL(18) SPANLINE_PIXEL(16) SPANLINE_PIXEL(14) SPANLINE_PIXEL(12)
      SPANLINE_PIXEL(10) SPANLINE_PIXEL(8) SPANLINE_PIXEL(6) SPANLINE_PIXEL(4) SPANLINE_PIXEL(2) SPANLINE_PIXEL(0)
      "3: mov r1, lr\n\t"  // the next row
      "ldmia r1!, {r0, r2, r3, r4, r5}\n\t"
      "subs r0, #1\n\t"
      "adds r2, r2, r4\n\t"
      "adds r3, r3, r5\n\t"
      "mov r4, lr\n\t"
      "stmia r4!, {r0, r2, r3}\n\t"
      "ldmia r1!, {r2, r3, r4}\n\t"
      "add r9, r2\n\t"
      "add r10, r3\n\t"
      "add r11, r4\n\t"
      "cmp r0, #0\n\t"
      "beq 5f\n\t"
      "4: mov r0, r9\n\t"  // the run [r0, r2) of this row
      "lsrs r0, r0, #26\n\t"
      "mov r2, r10\n\t"
      "lsrs r2, r2, #26\n\t"
      "subs r5, r2, r0\n\t"
      "bls 3b\n\t"
      "subs r4, r2, #1\n\t"
      "mov r1, lr\n\t"
      "ldr r2, [r1, #4]\n\t"
      "ldr r3, [r1, #8]\n\t"
      "mov r1, r8\n\t"
      "muls r1, r4\n\t"
      "subs r3, r3, r1\n\t"
      "muls r4, r7\n\t"
      "adds r2, r2, r4\n\t"
      "lsls r0, r0, #1\n\t"
      "add r0, r11\n\t"
      "mov r1, r0\n\t"
      "add r1, r12\n\t"
      "movs r4, #22\n\t"
      "muls r5, r4\n\t"
      "ldr r4, 6f\n\t"
      "subs r4, r4, r5\n\t"
      "mov pc, r4\n\t"
      ".align 2\n"
      "6: .word 3b\n"
      "5: mov r0, lr\n\t"
      "subs r0, #28\n\t"
      "mov r1, r9\n\t"
      "mov r2, r10\n\t"
      "mov r4, r11\n\t"
      "stmia r0!, {r1, r2, r4}\n\t"
      : "+r"(self)
      :
      : "r1", "r2", "r3", "r4", "r5", "r6", "r7", "r8", "r9", "r10", "r11", "r12", "lr", "cc", "memory");
}

#undef SPANLINE_PIXEL

// clang-format on

}  // namespace spanline::armv6m
#endif
