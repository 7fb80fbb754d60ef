#pragma once
#include "spanline/cpu/texture_block_maker.hpp"

#if defined(__thumb2__)
namespace spanline::thumb2 {

// clang-format off
// Sets the chords of one axis: r0 bow, r6 block.
#define SPANLINE_CHORDS(from, to, at)                                          \
  "sub r1, " to ", " from "\n\t"        /* the distance */                     \
  "asrs r4, r1, #12\n\t"                                                       \
  "muls r4, r0, r4\n\t"                                                        \
  "sub " from ", " from ", r4, asr #9\n\t"                                     \
  "asrs r5, r4, #4\n\t"                                                        \
  "add r5, r5, r5, lsl #1\n\t"                                                 \
  "subs r1, r1, r5\n\t"                                                        \
  "asrs r1, r1, #4\n\t"                                                        \
  "asrs r4, r4, #7\n\t"                                                        \
  "strd r1, r4, " at "\n\t"

// Computes a share: part · seed with its first-order correction, which is in r1.
#if defined(__ARM_FEATURE_DSP)
#define SPANLINE_SCALE_CORRECTION "lsls r1, r1, #8\n\t"
#define SPANLINE_CORRECT(to) "smlawt " to ", r1, " to ", " to "\n\t"
#else
#define SPANLINE_SCALE_CORRECTION
#define SPANLINE_CORRECT(to)                                                   \
  "lsr r4, " to ", #16\n\t"                                                    \
  "muls r4, r1, r4\n\t"                                                        \
  "add " to ", " to ", r4, asr #8\n\t"
#endif

// Makes one block. The end of a block is the start of the next, so two blocks in a row use the registers in turn and no
// moves are needed.
#define SPANLINE_MAKE(from_u, from_v, to_u, to_v, end)                         \
  "ldrd r1, r5, [sp]\n\t"                                                      \
  "ubfx r0, r8, #23, #8\n\t"                                                   \
  "ldrh r0, [r1, r0, lsl #1]\n\t"                                              \
  "lsr r1, r8, #9\n\t"                                                         \
  "muls r1, r0, r1\n\t"                                                        \
  "sbfx r1, r1, #7, #24\n\t"                                                   \
  "rsb r1, r1, #16\n\t"                                                        \
  SPANLINE_SCALE_CORRECTION                                                    \
  "lsr " to_u ", r9, #10\n\t"                                                  \
  "mul " to_u ", r0, " to_u "\n\t"                                             \
  SPANLINE_CORRECT(to_u)                                                       \
  "lsr " to_u ", " to_u ", r7\n\t"                                             \
  "lsr " to_v ", r10, #10\n\t"                                                 \
  "mul " to_v ", r0, " to_v "\n\t"                                             \
  SPANLINE_CORRECT(to_v)                                                       \
  "lsr " to_v ", " to_v ", lr\n\t"                                             \
  "muls r0, r5, r0\n\t"                                                        \
  "asrs r0, r0, #8\n\t"                                                        \
  "mul r1, r0, r0\n\t"                                                         \
  "sub r0, r0, r1, asr #17\n\t"                                                \
  "asrs r0, r0, #2\n\t"                                                        \
  SPANLINE_CHORDS(from_u, to_u, "[r6], #24")                                   \
  SPANLINE_CHORDS(from_v, to_v, "[r6, #-16]")                                  \
  "strd " from_u ", " from_v ", [r6, #-8]\n\t"                                 \
  "ldrd r0, r1, [sp, #8]\n\t"                                                  \
  "add r9, r0\n\t"                                                             \
  "add r10, r1\n\t"                                                            \
  "ldrd r0, r1, [sp, #16]\n\t"                                                 \
  "cmp r6, r1\n\t"                                                             \
  "beq " end "\n\t"                                                            \
  "subs r8, r8, r0\n\t"

/// The same as portable::make_texture_blocks.
[[gnu::always_inline]] inline void make_texture_blocks(TextureBlockMaker& maker) {
  register TextureBlockMaker* self __asm__("r0") = &maker;
  // r8, r9, r10 w, u and v; r7 and r14 shifts; on the stack: seeds, upper fall, steps, fall, end, and the caller's r7,
  // which compilers may use as the frame pointer and do not allow to be clobbered.
  __asm__ volatile(".syntax unified\n\t"
                   "mov r4, r7\n\t"
                   "ldmia r0!, {r8, r9, r10, r11, r12}\n\t"
                   "ldmia r0!, {r6, r7, lr}\n\t"
                   "subs r5, r0, #32\n\t"
                   "ldmia r0, {r0, r1, r2, r3}\n\t"
                   "push {r0, r1, r2, r3, r4, r5}\n\t"
                   "ldrd r4, r5, [r5, #48]\n\t"
                   "push {r4, r5}\n"
                   "1:\n\t"
                   SPANLINE_MAKE("r11", "r12", "r2", "r3", "2f")
                   "bpl 2f\n\t"
                   SPANLINE_MAKE("r2", "r3", "r11", "r12", "3f")
                   "bmi 1b\n\t"
                   "b 3f\n"
                   "2: mov r11, r2\n\t"
                   "mov r12, r3\n"
                   "3: ldrd r7, r0, [sp, #24]\n\t"
                   "strd r11, r12, [r0, #12]\n\t"
                   "str r6, [r0, #20]\n\t"
                   "add sp, #32\n\t"
                   : "+r"(self)
                   :
                   : "r1", "r2", "r3", "r4", "r5", "r6", "r8", "r9", "r10", "r11", "r12", "lr", "cc", "memory");
}

#undef SPANLINE_CHORDS
#undef SPANLINE_SCALE_CORRECTION
#undef SPANLINE_CORRECT
#undef SPANLINE_MAKE
// clang-format on

}  // namespace spanline::thumb2
#endif
