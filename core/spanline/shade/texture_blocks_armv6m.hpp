#pragma once
#include <cstddef>
#include <cstdint>

#if defined(__ARM_ARCH_6M__)
namespace spanline::armv6m {

/// The loop of CertainBlocks::take, with what it steps in registers: its compilers move a quarter of it to the stack
/// and back.
struct BlockMaker {
  std::uint32_t w, u, v;         ///< at the end of the next block
  std::uint32_t from_u, from_v;  ///< coordinates at the end of the block that came last
  std::int32_t zeros;            ///< leading zeros of w, or one more or fewer
  void* out;                     ///< the next block, a TextureBlock
  std::uint32_t rise, du, dv;    ///< of w, u and v: a block
  std::uint32_t shift_u, shift_v;
  const void* end;       ///< behind the last block
  std::uintptr_t seeds;  ///< of TextureReciprocal: where an entry 256 before its first would lie

  /// Makes the blocks, at least one.
  [[gnu::always_inline]] void make();
};
static_assert(offsetof(BlockMaker, rise) == 28 && offsetof(BlockMaker, end) == 48);

// clang-format off
// One axis: r0 the block, r1 seed, r2 zeros, r3 correction, r4 bow.
#define SPANLINE_AXIS(part, from, shift, step, at_step, at_bend, at_start)     \
  "mov r5, " part "\n\t"                                                       \
  "lsls r5, r2\n\t"                                                            \
  "lsrs r5, r5, #10\n\t"                                                       \
  "muls r5, r1\n\t"                                                            \
  "lsrs r6, r5, #16\n\t"                                                       \
  "muls r6, r3\n\t"                                                            \
  "asrs r6, r6, #8\n\t"                                                        \
  "adds r5, r5, r6\n\t"                                                        \
  "ldr r6, [sp, #" #shift "]\n\t"                                              \
  "lsrs r5, r6\n\t"                                                            \
  "ldr r6, [sp, #" #step "]\n\t"                                               \
  "add " part ", r6\n\t"                                                       \
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
  "str r5, [r0, #" #at_step "]\n\t"                                            \
  "asrs r5, r7, #4\n\t"                                                        \
  "str r5, [r0, #" #at_bend "]\n\t"                                            \
  "asrs r5, r7, #6\n\t"                                                        \
  "subs r6, r6, r5\n\t"                                                        \
  "str r6, [r0, #" #at_start "]\n\t"

inline void BlockMaker::make() {
  register BlockMaker* self __asm__("r0") = this;
  // r8 w, r9 and r10 u and v, r11 and r12 where they come from. On the stack: rise, steps, shifts, end, seeds, self.
  __asm__ volatile(".syntax unified\n\t"
                   "ldmia r0!, {r1, r2, r3, r4, r5}\n\t"
                   "mov r8, r1\n\t"
                   "mov r9, r2\n\t"
                   "mov r10, r3\n\t"
                   "mov r11, r4\n\t"
                   "mov r12, r5\n\t"
                   "ldmia r0!, {r1, r7}\n\t"
                   "ldr r2, [r0, #20]\n\t"
                   "ldr r3, [r0, #24]\n\t"
                   "mov r4, r0\n\t"
                   "push {r2, r3, r4}\n\t"
                   "ldmia r0!, {r2, r3, r4, r5, r6}\n\t"
                   "push {r2, r3, r4, r5, r6}\n\t"
                   "movs r0, r7\n\t"
                   "movs r2, r1\n"
                   "1: mov r5, r8\n\t"
                   "lsls r5, r2\n\t"
                   "bcs 2f\n\t"
                   "bpl 3f\n\t"
                   "lsrs r6, r5, #23\n\t"
                   "lsls r6, r6, #1\n\t"
                   "ldr r7, [sp, #24]\n\t"
                   "ldrh r1, [r7, r6]\n\t"
                   "lsrs r5, r5, #9\n\t"
                   "muls r5, r1\n\t"
                   "lsls r5, r5, #1\n\t"
                   "asrs r5, r5, #8\n\t"
                   "movs r3, #16\n\t"
                   "subs r3, r3, r5\n\t"
                   "ldr r4, [sp]\n\t"
                   "add r8, r4\n\t"
                   "rsbs r4, r4, #0\n\t"
                   "lsls r4, r2\n\t"
                   "asrs r4, r4, #16\n\t"
                   "muls r4, r1\n\t"
                   "asrs r4, r4, #8\n\t"
                   "movs r5, r4\n\t"
                   "muls r5, r5\n\t"
                   "asrs r5, r5, #17\n\t"
                   "subs r4, r4, r5\n\t"
                   "asrs r4, r4, #2\n\t"
                   SPANLINE_AXIS("r9", "r11", 12, 4, 0, 8, 16)
                   SPANLINE_AXIS("r10", "r12", 16, 8, 4, 12, 20)
                   "adds r0, #24\n\t"
                   "ldr r5, [sp, #20]\n\t"
                   "cmp r0, r5\n\t"
                   "bne 1b\n\t"
                   "b 4f\n"
                   "2: subs r2, #1\n\t"  // w has grown by a bit
                   "b 1b\n"
                   "3: adds r2, #1\n\t"  // or lost one
                   "b 1b\n"
                   "4: ldr r0, [sp, #28]\n\t"
                   "subs r0, #28\n\t"
                   "movs r6, r2\n\t"
                   "mov r1, r8\n\t"
                   "mov r2, r9\n\t"
                   "mov r3, r10\n\t"
                   "mov r4, r11\n\t"
                   "mov r5, r12\n\t"
                   "stmia r0!, {r1, r2, r3, r4, r5, r6}\n\t"
                   "add sp, #32\n\t"
                   : "+r"(self)
                   :
                   : "r1", "r2", "r3", "r4", "r5", "r6", "r7", "r8", "r9", "r10", "r11", "r12", "lr", "cc", "memory");
}

#undef SPANLINE_AXIS

// clang-format on

}  // namespace spanline::armv6m
#endif
