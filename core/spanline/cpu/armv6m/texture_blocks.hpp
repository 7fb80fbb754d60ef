#pragma once
#include "spanline/cpu/texture_block_maker.hpp"

#if defined(__ARM_ARCH_6M__)
namespace spanline::armv6m {

// clang-format off
// Makes one axis of a block: r0 block, r1 seed, r3 correction, r4 bow. Output: the coordinate at the block's start in
// `start`, and that at its end in `from`.
#define SPANLINE_AXIS(part, from, shift, STEP, start)                          \
  "mov r5, " part "\n\t"                                                       \
  "lsrs r5, r5, #10\n\t"                                                       \
  "muls r5, r1\n\t"                                                            \
  "lsrs r6, r5, #16\n\t"                                                       \
  "muls r6, r3\n\t"                                                            \
  "asrs r6, r6, #8\n\t"                                                        \
  "adds r5, r5, r6\n\t"                                                        \
  "ldr r6, [sp, #" #shift "]\n\t"                                              \
  "lsrs r5, r6\n\t"                                                            \
  STEP                                                                         \
  "mov r6, " from "\n\t"                                                       \
  "mov " from ", r5\n\t"                                                       \
  "subs r5, r5, r6\n\t"        /* the distance */                              \
  "asrs r7, r5, #12\n\t"                                                       \
  "muls r7, r4\n\t"                                                            \
  "asrs r7, r7, #4\n\t"                                                        \
  "subs r5, r5, r7\n\t"                                                        \
  "lsls r7, r7, #1\n\t"                                                        \
  "subs r5, r5, r7\n\t"                                                        \
  "asrs r5, r5, #4\n\t"                                                        \
  "asrs " start ", r7, #6\n\t"                                                 \
  "subs " start ", r6, " start "\n\t"                                          \
  "asrs r7, r7, #4\n\t"                                                        \
  "stmia r0!, {r5, r7}\n\t"

/// The same as portable::make_texture_blocks.
[[gnu::always_inline]] inline void make_texture_blocks(TextureBlockMaker& maker) {
  register TextureBlockMaker* self __asm__("r0") = &maker;
  // r8 w, r9 and r10 u and v, r11 and r12 the coordinates at the last block's end, r14 step of u. On the stack: the
  // shifts, the step of v, fall, end, the address 256 entries before the first seed, upper fall, the address of `out`,
  // and the caller's r7, which compilers may use as the frame pointer and do not allow to be clobbered.
  __asm__ volatile(".syntax unified\n\t"
                   "push {r7}\n\t"
                   "ldmia r0!, {r1, r2, r3, r4, r5}\n\t"
                   "mov r8, r1\n\t"
                   "mov r9, r2\n\t"
                   "mov r10, r3\n\t"
                   "mov r11, r4\n\t"
                   "mov r12, r5\n\t"
                   "movs r7, r0\n\t"
                   "ldr r4, [r7, #24]\n\t"
                   "ldr r5, [r7, #28]\n\t"
                   "ldr r6, [r7, #32]\n\t"
                   "movs r3, #2\n\t"
                   "lsls r3, r3, #8\n\t"
                   "subs r5, r5, r3\n\t"
                   "push {r4, r5, r6, r7}\n\t"
                   "ldmia r0!, {r1, r2, r3, r4, r5, r6}\n\t"
                   "mov lr, r4\n\t"
                   "push {r2, r3, r5, r6}\n\t"
                   "movs r0, r1\n\t"
                   "mov r5, r8\n"
                   "1: lsrs r6, r5, #23\n\t"    // 256 and more, because the top bit is set
                   "lsls r6, r6, #1\n\t"
                   "ldr r7, [sp, #20]\n\t"
                   "ldrh r1, [r7, r6]\n\t"
                   "lsrs r5, r5, #9\n\t"
                   "muls r5, r1\n\t"
                   "lsls r5, r5, #1\n\t"
                   "asrs r5, r5, #8\n\t"
                   "movs r3, #16\n\t"
                   "subs r3, r3, r5\n\t"
                   "ldr r4, [sp, #24]\n\t"
                   "muls r4, r1\n\t"
                   "asrs r4, r4, #8\n\t"
                   "movs r5, r4\n\t"
                   "muls r5, r5\n\t"
                   "asrs r5, r5, #17\n\t"
                   "subs r4, r4, r5\n\t"
                   "asrs r4, r4, #2\n\t"
                   SPANLINE_AXIS("r9", "r11", 0, "add r9, lr\n\t", "r2")
                   SPANLINE_AXIS("r10", "r12", 4, "ldr r6, [sp, #8]\n\tadd r10, r6\n\t", "r3")
                   "stmia r0!, {r2, r3}\n\t"
                   "ldr r5, [sp, #16]\n\t"
                   "cmp r0, r5\n\t"
                   "beq 2f\n\t"
                   "mov r5, r8\n\t"
                   "ldr r6, [sp, #12]\n\t"
                   "subs r5, r5, r6\n\t"
                   "mov r8, r5\n\t"
                   "bmi 1b\n"
                   "2: add sp, #28\n\t"
                   "pop {r1, r7}\n\t"
                   "str r0, [r1]\n\t"
                   "subs r1, #8\n\t"
                   "mov r2, r11\n\t"
                   "mov r3, r12\n\t"
                   "stmia r1!, {r2, r3}\n\t"
                   : "+r"(self)
                   :
                   : "r1", "r2", "r3", "r4", "r5", "r6", "r8", "r9", "r10", "r11", "r12", "lr", "cc", "memory");
}

#undef SPANLINE_AXIS
// clang-format on

}  // namespace spanline::armv6m
#endif
