#pragma once
#include <cstddef>
#include <cstdint>

#if defined(__ARM_ARCH_6M__)
namespace spanline::armv6m {

/// The rows of a small or medium triangle between two bends, against a 16-bit depth buffer, smaller is nearer, in
/// pixels of 16 bits: what TriangleRows does in C++, with every quantity of the loop in a register. Thumb-1 has eight
/// registers for arithmetic; compilers move more between them and the stack than this does.
struct FlatRows {
  std::uint32_t left, right;  ///< columns of the row, 26 fraction bits or 24
  std::uint32_t z;            ///< plane word at column 0 of the row
  std::uint16_t* depth;       ///< the row's column 0
  std::uintptr_t distance;    ///< bytes from a depth to its pixel
  std::uint32_t dz;           ///< of a column
  std::uint32_t pixel;
  std::int32_t rows;  ///< ≥ 1
  std::uint32_t left_step, right_step, dz_row;
  std::uint32_t width_bytes;  ///< of a row

  /// Draws the rows of a small triangle, 21 pixels at most, and stands on the one behind them.
  [[gnu::always_inline]] void draw_short();
  /// The same for a medium triangle: rows of any length.
  [[gnu::always_inline]] void draw_long();
};
static_assert(offsetof(FlatRows, distance) == 16 && offsetof(FlatRows, rows) == 28 &&
              offsetof(FlatRows, left_step) == 32);

// clang-format off
// A pixel at a byte offset: r0 depth, r1 pixels, r2 plane word, r3 its step, r6 the pixel. Seven instructions, 14
// bytes.
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

// r8 and r9 columns, r10 plane word of column 0, r11 its depth, r12 distance, r3 and r6 as above.
#define SPANLINE_LOAD_ROW                                                      \
  ".syntax unified\n\t"                                                        \
  "ldmia r0!, {r1, r2, r4, r5}\n\t"                                            \
  "mov r8, r1\n\t"                                                             \
  "mov r9, r2\n\t"                                                             \
  "mov r10, r4\n\t"                                                            \
  "mov r11, r5\n\t"                                                            \
  "ldmia r0!, {r1, r3, r6}\n\t"                                                \
  "mov r12, r1\n\t"

// From r1, which points at the steps.
#define SPANLINE_NEXT_ROW                                                      \
  "ldmia r1!, {r0, r2, r4, r5}\n\t"                                            \
  "add r8, r0\n\t"                                                             \
  "add r9, r2\n\t"                                                             \
  "add r10, r4\n\t"                                                            \
  "add r11, r5\n\t"

// The run [r0, r2) of the row, r5 its length; goes on at label 3 where it is empty. Leaves the last pixel's plane word
// in r2.
#define SPANLINE_FIND_RUN(fraction_bits)                                       \
  "mov r0, r8\n\t"                                                             \
  "lsrs r0, r0, #" #fraction_bits "\n\t"                                       \
  "mov r2, r9\n\t"                                                             \
  "lsrs r2, r2, #" #fraction_bits "\n\t"                                       \
  "subs r5, r2, r0\n\t"                                                        \
  "bls 3b\n\t"                                                                 \
  "subs r2, #1\n\t"                                                            \
  "muls r2, r3\n\t"                                                            \
  "add r2, r10\n\t"                                                            \
  "lsls r0, r0, #1\n\t"                                                        \
  "add r0, r11\n\t"

// Jumps r5 pixels back from label 3 (r4 is free), with r1 at the pixel of r0.
#define SPANLINE_ENTER_PIXELS                                                  \
  "mov r1, r0\n\t"                                                             \
  "add r1, r12\n\t"                                                            \
  "movs r4, #14\n\t"                                                           \
  "muls r5, r4\n\t"                                                            \
  "ldr r4, 6f\n\t"                                                             \
  "subs r4, r4, r5\n\t"                                                        \
  "mov pc, r4\n\t"                                                             \
  ".align 2\n"                                                                 \
  "6: .word 3b\n"

// r0 points behind left, right, z and depth.
#define SPANLINE_STORE_ROW                                                     \
  "subs r0, #16\n\t"                                                           \
  "mov r1, r8\n\t"                                                             \
  "mov r2, r9\n\t"                                                             \
  "mov r4, r10\n\t"                                                            \
  "mov r5, r11\n\t"                                                            \
  "stmia r0!, {r1, r2, r4, r5}\n\t"

#define SPANLINE_CLOBBERS                                                      \
  "r1", "r2", "r3", "r4", "r5", "r6", "r7", "r8", "r9", "r10", "r11", "r12", "lr", "cc", "memory"

inline void FlatRows::draw_short() {
  register FlatRows* self __asm__("r0") = this;
  // r7 rows left, r14 the steps.
  __asm__ volatile(SPANLINE_LOAD_ROW
                   "ldmia r0!, {r7}\n\t"
                   "mov lr, r0\n\t"
                   "b 4f\n\t"
                   // Right to left, entered at the run's last pixel.
                   SPANLINE_PIXEL(40) SPANLINE_PIXEL(38) SPANLINE_PIXEL(36) SPANLINE_PIXEL(34) SPANLINE_PIXEL(32)
                   SPANLINE_PIXELS_16
                   "3: mov r1, lr\n\t"
                   SPANLINE_NEXT_ROW
                   "subs r7, #1\n\t"
                   "beq 5f\n\t"
                   "4:\n\t"
                   SPANLINE_FIND_RUN(26)
                   SPANLINE_ENTER_PIXELS
                   "5: mov r0, lr\n\t"
                   "subs r0, #16\n\t"
                   SPANLINE_STORE_ROW
                   : "+r"(self)
                   :
                   : SPANLINE_CLOBBERS);
}

inline void FlatRows::draw_long() {
  register FlatRows* self __asm__("r0") = this;
  // r7 blocks of 16 pixels left of the run, r14 the rows left and behind them the steps.
  __asm__ volatile(SPANLINE_LOAD_ROW
                   "mov lr, r0\n\t"
                   "b 4f\n\t"
                   "2:\n\t"
                   SPANLINE_PIXELS_16
                   "3: subs r7, #1\n\t"
                   "bmi 7f\n\t"
                   "subs r0, #32\n\t"
                   "subs r1, #32\n\t"
                   "b 2b\n\t"
                   "7: mov r1, lr\n\t"
                   "ldr r7, [r1]\n\t"
                   "subs r7, #1\n\t"
                   "stmia r1!, {r7}\n\t"
                   SPANLINE_NEXT_ROW
                   "cmp r7, #0\n\t"
                   "beq 5f\n\t"
                   "4: movs r7, #0\n\t"  // an empty run has no blocks
                   SPANLINE_FIND_RUN(24)
                   "subs r4, r5, #1\n\t"  // whole blocks before the run's right end, which has 1 … 16 pixels
                   "lsrs r7, r4, #4\n\t"
                   "lsls r1, r7, #4\n\t"
                   "subs r5, r5, r1\n\t"
                   "lsls r1, r1, #1\n\t"
                   "adds r0, r0, r1\n\t"
                   SPANLINE_ENTER_PIXELS
                   "5: mov r0, lr\n\t"
                   "subs r0, #12\n\t"
                   SPANLINE_STORE_ROW
                   : "+r"(self)
                   :
                   : SPANLINE_CLOBBERS);
}

#undef SPANLINE_PIXELS_16
#undef SPANLINE_LOAD_ROW
#undef SPANLINE_NEXT_ROW
#undef SPANLINE_FIND_RUN
#undef SPANLINE_ENTER_PIXELS
#undef SPANLINE_STORE_ROW
#undef SPANLINE_CLOBBERS
#undef SPANLINE_PIXEL

// clang-format on

}  // namespace spanline::armv6m
#endif
