#pragma once
#include <cstddef>
#include <cstdint>

#if defined(__ARM_ARCH_6M__)
namespace spanline::armv6m {

/// Whole blocks of a texture against a 16-bit depth buffer, smaller is nearer, in pixels of 16 bits: what BlockRun does
/// in C++, with every quantity of the loops in a register.
///
/// Where nothing has been drawn in a block, its depths are written first and then its pixels: the two together want
/// more than the eight registers that Thumb-1 has for arithmetic.
struct TexelBlocks {
  std::uint16_t* depth;  ///< of the first pixel; aligned to 4 bytes
  std::uint16_t* pixels;
  std::uint32_t z;  ///< plane word at the first pixel
  const std::uint16_t* texels;
  std::uint32_t mask_u, mask_v;  ///< twice those of the table: bytes
  std::uint32_t dz;              ///< of a column
  const void* blocks;            ///< steps of u and v, their gains from piece to piece, u and v: 24 bytes each
  const void* end;               ///< behind the last

  /// Draws the blocks, at least one.
  [[gnu::always_inline]] void draw();
};
static_assert(offsetof(TexelBlocks, mask_u) == 16 && offsetof(TexelBlocks, end) == 32);

// clang-format off
// r0 depth, r1 pixels, r2 u, r3 v, r4 and r5 free, r6 and r7 masks, r8 plane word, r9 and r10 steps, r11 and r12 their
// gains, r14 the table. On the stack: dz, the blocks, their end.

// A depth at a byte offset; r2 the plane word and r3 its step.
#define SPANLINE_DEPTH(offset)                                                 \
  "lsrs r4, r2, #16\n\t"                                                       \
  "strh r4, [r0, #" #offset "]\n\t"                                            \
  "adds r2, r2, r3\n\t"

#define SPANLINE_TEXEL(offset)                                                 \
  "lsrs r4, r3, #11\n\t"                                                       \
  "ands r4, r7\n\t"                                                            \
  "lsrs r5, r2, #15\n\t"                                                       \
  "ands r5, r6\n\t"                                                            \
  "add r4, lr\n\t"                                                             \
  "ldrh r4, [r4, r5]\n\t"                                                      \
  "strh r4, [r1, #" #offset "]\n\t"

#define SPANLINE_STEP                                                          \
  "add r2, r9\n\t"                                                             \
  "add r3, r10\n\t"

#define SPANLINE_BEND                                                          \
  "add r9, r11\n\t"                                                            \
  "add r10, r12\n\t"

// The same where the depth passes.
#define SPANLINE_TESTED(offset)                                                \
  "mov r4, r8\n\t"                                                             \
  "lsrs r4, r4, #16\n\t"                                                       \
  "ldrh r5, [r0, #" #offset "]\n\t"                                            \
  "cmp r5, r4\n\t"                                                             \
  "bls 1f\n\t"                                                                 \
  "strh r4, [r0, #" #offset "]\n\t"                                            \
  SPANLINE_TEXEL(offset)                                                       \
  "1: ldr r4, [sp]\n\t"                                                        \
  "add r8, r4\n\t"

#define SPANLINE_DEPTHS_4(a, b, c, d)                                          \
  SPANLINE_DEPTH(a) SPANLINE_DEPTH(b) SPANLINE_DEPTH(c) SPANLINE_DEPTH(d)
#define SPANLINE_PIECE(PIXEL, a, b, c, d)                                      \
  PIXEL(a) SPANLINE_STEP PIXEL(b) SPANLINE_STEP PIXEL(c) SPANLINE_STEP PIXEL(d)
#define SPANLINE_BLOCK(PIXEL)                                                  \
  SPANLINE_PIECE(PIXEL, 0, 2, 4, 6) SPANLINE_STEP SPANLINE_BEND                \
  SPANLINE_PIECE(PIXEL, 8, 10, 12, 14) SPANLINE_STEP SPANLINE_BEND             \
  SPANLINE_PIECE(PIXEL, 16, 18, 20, 22) SPANLINE_STEP SPANLINE_BEND            \
  SPANLINE_PIECE(PIXEL, 24, 26, 28, 30)

#define SPANLINE_LOAD_BLOCK                                                    \
  "ldr r4, [sp, #4]\n\t"                                                       \
  "ldmia r4!, {r2, r3}\n\t"                                                    \
  "mov r9, r2\n\t"                                                             \
  "mov r10, r3\n\t"                                                            \
  "ldmia r4!, {r2, r3}\n\t"                                                    \
  "mov r11, r2\n\t"                                                            \
  "mov r12, r3\n\t"                                                            \
  "ldmia r4!, {r2, r3}\n\t"                                                    \
  "str r4, [sp, #4]\n\t"

inline void TexelBlocks::draw() {
  register TexelBlocks* self __asm__("r0") = this;
  __asm__ volatile(".syntax unified\n\t"
                   "ldmia r0!, {r1, r2, r3, r4}\n\t"
                   "mov r8, r3\n\t"
                   "mov lr, r4\n\t"
                   "ldmia r0!, {r6, r7}\n\t"
                   "ldmia r0!, {r3, r4, r5}\n\t"
                   "push {r3, r4, r5}\n\t"
                   "movs r0, r1\n\t"
                   "movs r1, r2\n"
                   // Whether all depths of the block are as they were cleared.
                   "2: movs r2, r0\n\t"
                   "ldmia r2!, {r3, r4, r5}\n\t"
                   "ands r3, r4\n\t"
                   "ands r3, r5\n\t"
                   "ldmia r2!, {r4, r5}\n\t"
                   "ands r3, r4\n\t"
                   "ands r3, r5\n\t"
                   "ldmia r2!, {r4, r5}\n\t"
                   "ands r3, r4\n\t"
                   "ands r3, r5\n\t"
                   "ldr r4, [r2]\n\t"
                   "ands r3, r4\n\t"
                   "adds r3, #1\n\t"
                   "beq 3f\n\t"
                   "b 5f\n"
                   "3: mov r2, r8\n\t"
                   "ldr r3, [sp]\n\t"
                   SPANLINE_DEPTHS_4(0, 2, 4, 6) SPANLINE_DEPTHS_4(8, 10, 12, 14)
                   SPANLINE_DEPTHS_4(16, 18, 20, 22) SPANLINE_DEPTHS_4(24, 26, 28, 30)
                   "mov r8, r2\n\t"
                   SPANLINE_LOAD_BLOCK
                   SPANLINE_BLOCK(SPANLINE_TEXEL)
                   "4: adds r0, #32\n\t"
                   "adds r1, #32\n\t"
                   "ldr r4, [sp, #4]\n\t"
                   "ldr r5, [sp, #8]\n\t"
                   "cmp r4, r5\n\t"
                   "beq 7f\n\t"
                   "b 2b\n"
                   "7: b 6f\n"
                   "5:\n\t"
                   SPANLINE_LOAD_BLOCK
                   SPANLINE_BLOCK(SPANLINE_TESTED)
                   "b 4b\n"
                   "6: add sp, #12\n\t"
                   : "+r"(self)
                   :
                   : "r1", "r2", "r3", "r4", "r5", "r6", "r7", "r8", "r9", "r10", "r11", "r12", "lr", "cc", "memory");
}

#undef SPANLINE_DEPTH
#undef SPANLINE_TEXEL
#undef SPANLINE_STEP
#undef SPANLINE_BEND
#undef SPANLINE_TESTED
#undef SPANLINE_DEPTHS_4
#undef SPANLINE_PIECE
#undef SPANLINE_BLOCK
#undef SPANLINE_LOAD_BLOCK

// clang-format on

}  // namespace spanline::armv6m
#endif
