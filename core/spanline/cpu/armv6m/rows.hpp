#pragma once
#include <cstddef>
#include <cstdint>

#include "spanline/raster/active_triangle.hpp"

/// Code that the row kernels in assembly share (flat_rows.hpp, ramp_rows.hpp). Thumb-1 has eight registers for
/// arithmetic, and these kernels move less between them and the stack than compiled code does.
#if defined(__ARM_ARCH_6M__)
namespace spanline::armv6m {

/// The words of a BandTarget whose depths and pixels have 16 bits.
struct BandTargetWords {
  std::uint16_t *depth, *pixels;
  std::int32_t width, first_row;
};
static_assert(offsetof(ActiveTriangle, origin) == 12 && offsetof(ActiveTriangle, row) == 16 &&
              offsetof(ActiveTriangle, flags) == 28 && offsetof(ActiveTriangle, fixed) == 32 &&
              sizeof(LinearFunction) == 12 && offsetof(FixedEdges, third) == 16);

}  // namespace spanline::armv6m

// clang-format off

// Takes the arguments triangle, r1, target, rows and, on the stack, rows_after. Output: r0 triangle; r4 and r11 address
// of the depth at the triangle's column 0 in the first row; r5 bytes from a depth to its pixel; r6 bytes of a row; r12
// that depth's address in the row after the first part. The stack pointer is lowered to a frame of `room` bytes.
#define SPANLINE_ENTER_ROWS(room)                                              \
  ".syntax unified\n\t"                                                        \
  "push {r4, r5, r6, r7, lr}\n\t"                                              \
  "mov r4, r8\n\t"                                                             \
  "mov r5, r9\n\t"                                                             \
  "mov r6, r10\n\t"                                                            \
  "mov r7, r11\n\t"                                                            \
  "push {r4, r5, r6, r7}\n\t"                                                  \
  "sub sp, #" #room "\n\t"                                                     \
  "ldmia r2!, {r4, r5, r6, r7}\n\t"                                            \
  "subs r5, r5, r4\n\t"                                                        \
  "ldr r2, [r0, #16]\n\t"                                                      \
  "subs r2, r2, r7\n\t"                                                        \
  "muls r2, r6\n\t"                                                            \
  "ldr r7, [r0, #12]\n\t"                                                      \
  "adds r2, r2, r7\n\t"                                                        \
  "lsls r2, r2, #1\n\t"                                                        \
  "adds r4, r4, r2\n\t"                                                        \
  "mov r11, r4\n\t"                                                            \
  "lsls r6, r6, #1\n\t"                                                        \
  "muls r3, r6\n\t"                                                            \
  "adds r3, r3, r4\n\t"                                                        \
  "mov r12, r3\n\t"

// Jumps to 4 for the second part if it has rows, otherwise to 9. The stack frame holds the row steps of the left and
// right column, the bytes of a row, and at the offsets given the rows of the second part and the triangle. The columns
// are in the registers given.
#define SPANLINE_SECOND_PART(rows_at, triangle_at, left, right)                \
  "ldr r0, [sp, #" #rows_at "]\n\t"                                            \
  "cmp r0, #0\n\t"                                                             \
  "beq 9f\n\t"                                                                 \
  "ldr r4, [sp, #8]\n\t"                                                       \
  "muls r4, r0\n\t"                                                            \
  "add r12, r4\n\t"                                                            \
  "movs r0, #0\n\t"                                                            \
  "str r0, [sp, #" #rows_at "]\n\t"                                            \
  "ldr r1, [sp, #" #triangle_at "]\n\t"                                        \
  "ldr r0, [r1, #28]\n\t"                                                      \
  "lsls r0, r0, #27\n\t"  /* past the knee already */                                   \
  "bmi 4b\n\t"                                                                 \
  "ldr r4, [r1, #48]\n\t"                                                      \
  "ldr r5, [r1, #52]\n\t"                                                      \
  "lsls r0, r0, #2\n\t"   /* the third edge is on the right */                 \
  "bmi 7f\n\t"                                                                 \
  "mov " #left ", r4\n\t"                                                      \
  "str r5, [sp]\n\t"                                                           \
  "b 4b\n"                                                                     \
  "7: mov " #right ", r4\n\t"                                                  \
  "str r5, [sp, #4]\n\t"                                                       \
  "b 4b\n"

// A jump r5 bytes from label 3: `distance` bytes lie between it and where the jump begins to count. clang's assembler
// computes nothing from labels, so that the number is written out, and gcc's holds it against them.
#if defined(__clang__)
#define SPANLINE_REQUIRE_DISTANCE(distance)
#else
#define SPANLINE_REQUIRE_DISTANCE(distance)                                    \
  ".if (6b + 4 - 3b) != " #distance "\n\t"                                     \
  ".error \"the distance is another\"\n\t"                                     \
  ".endif\n\t"
#endif
#define SPANLINE_JUMP_FROM_3(distance)                                         \
  "subs r5, #" #distance "\n\t"                                                \
  "6: add pc, r5\n\t"                                                          \
  SPANLINE_REQUIRE_DISTANCE(distance)

#define SPANLINE_LEAVE_ROWS(room)                                              \
  "9: add sp, #" #room "\n\t"                                                  \
  "pop {r4, r5, r6, r7}\n\t"                                                   \
  "mov r8, r4\n\t"                                                             \
  "mov r9, r5\n\t"                                                             \
  "mov r10, r6\n\t"                                                            \
  "mov r11, r7\n\t"                                                            \
  "pop {r4, r5, r6, r7, pc}\n"

// clang-format on
#endif
