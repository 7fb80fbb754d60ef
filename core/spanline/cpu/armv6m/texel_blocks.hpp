#pragma once
#include <cstddef>
#include <cstdint>

#include "spanline/cpu/texel_table.hpp"
#include "spanline/cpu/texture_steps.hpp"

#if defined(__ARM_ARCH_6M__)
namespace spanline::armv6m {

/// Draws blocks of a texture in 16-bit pixels against a 16-bit depth buffer in which smaller is nearer. It does what
/// BlockRun does in C++, with every quantity of the loops in a register.
///
/// In a whole block in which nothing has been drawn, first the depths are written and then the pixels: both loops
/// together would need more than the eight registers that Thumb-1 has for arithmetic.
struct TexelRun {
  std::uint16_t* depth;  ///< of the next pixel; aligned to 4 bytes for whole blocks
  std::uint16_t* pixels;
  std::uint32_t z;  ///< plane word at the next pixel
  const std::uint16_t* texels;
  std::uint32_t dz;              ///< step of the plane word a column
  std::uint32_t mask_u, mask_v;  ///< masks of the table, doubled to count bytes

  /// What to draw. `whole`: at least one block, up to the depth at `end`. `part`: a part of a block, by the steps of u
  /// and v, their increments, u and v at the pixel where the part begins, and the entry into the straight-line code.
  union {
    struct {
      const void* blocks;  ///< of TextureBlock, 24 bytes each
      std::uint16_t* end;
    } whole;
    struct {
      std::uint32_t du, dv, ddu, ddv, u, v, entry;
    } part;
  };

  /// Draws whole blocks and moves past them.
  [[gnu::always_inline]] void draw_blocks(const void* blocks, std::uint32_t count);
  /// Draws a block's last 1 … 15 pixels and moves past them.
  [[gnu::always_inline]] void draw_rightwards(const TextureBlock& block, std::uint32_t into);
  /// Draws a block's first 1 … 15 pixels from right to left. This must end a run, because the position is not kept.
  [[gnu::always_inline]] void draw_leftwards(const TextureBlock& block, std::uint32_t count);

 private:
  /// Offset of the code of pixel `number` in the straight-line code: 17 instructions a pixel, and two between pieces.
  static constexpr std::uint32_t entry_at(std::uint32_t number) { return 35 * number - (number & 3); }
  [[gnu::always_inline]] void draw_whole_blocks();
  [[gnu::always_inline]] void draw_part_rightwards();
  [[gnu::always_inline]] void draw_part_leftwards();
};
static_assert(offsetof(TexelRun, dz) == 16 && offsetof(TexelRun, part) == 28);

// clang-format off
// r0 depth, r1 pixels, r2 u, r3 v, r4 and r5 free, r6 and r7 masks, r8 plane word, r9 and r10 steps of u and v, r11 and
// r12 their increments, r14 table. On the stack: dz, the blocks, their end, the run, and the caller's r7, which
// compilers may use as the frame pointer and do not allow to be clobbered.

// Writes a depth at a byte offset; r2 plane word, r3 its step.
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

#define SPANLINE_NEXT_PIECE                                                          \
  "add r9, r11\n\t"                                                            \
  "add r10, r12\n\t"

// Draws a pixel at a byte offset if its depth passes the test.
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
  SPANLINE_PIECE(PIXEL, 0, 2, 4, 6) SPANLINE_STEP SPANLINE_NEXT_PIECE                \
  SPANLINE_PIECE(PIXEL, 8, 10, 12, 14) SPANLINE_STEP SPANLINE_NEXT_PIECE             \
  SPANLINE_PIECE(PIXEL, 16, 18, 20, 22) SPANLINE_STEP SPANLINE_NEXT_PIECE            \
  SPANLINE_PIECE(PIXEL, 24, 26, 28, 30)

#define SPANLINE_LOAD_BLOCK                                                    \
  "ldr r4, [sp, #4]\n\t"                                                       \
  "ldmia r4!, {r2, r3}\n\t"                                                    \
  "mov r9, r2\n\t"                                                             \
  "mov r11, r3\n\t"                                                            \
  "ldmia r4!, {r2, r3}\n\t"                                                    \
  "mov r10, r2\n\t"                                                            \
  "mov r12, r3\n\t"                                                            \
  "ldmia r4!, {r2, r3}\n\t"                                                    \
  "str r4, [sp, #4]\n\t"

inline void TexelRun::draw_whole_blocks() {
  register TexelRun* self __asm__("r0") = this;
  __asm__ volatile(".syntax unified\n\t"
                   "push {r0, r7}\n\t"
                   "ldmia r0!, {r1, r2, r3, r4}\n\t"
                   "mov r8, r3\n\t"
                   "mov lr, r4\n\t"
                   "ldmia r0!, {r3, r6, r7}\n\t"
                   "ldmia r0!, {r4, r5}\n\t"
                   "push {r3, r4, r5}\n\t"
                   "movs r0, r1\n\t"
                   "movs r1, r2\n"
                   // Tests whether all depths of the block are still clear.
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
                   "ldr r5, [sp, #8]\n\t"
                   "cmp r1, r5\n\t"
                   "beq 7f\n\t"
                   "b 2b\n"
                   "7: b 6f\n"
                   "5:\n\t"
                   SPANLINE_LOAD_BLOCK
                   SPANLINE_BLOCK(SPANLINE_TESTED)
                   "b 4b\n"
                   "6: add sp, #12\n\t"
                   "pop {r2, r7}\n\t"
                   "mov r3, r8\n\t"
                   "stmia r2!, {r0, r1, r3}\n\t"
                   : "+r"(self)
                   :
                   : "r1", "r2", "r3", "r4", "r5", "r6", "r8", "r9", "r10", "r11", "r12", "lr", "cc", "memory");
}

// Draws a block from right to left. A step between pieces uses the steps of the piece that it enters.
#define SPANLINE_BLOCK_LEFTWARDS(PIXEL)                                        \
  SPANLINE_PIECE(PIXEL, 30, 28, 26, 24) SPANLINE_NEXT_PIECE SPANLINE_STEP            \
  SPANLINE_PIECE(PIXEL, 22, 20, 18, 16) SPANLINE_NEXT_PIECE SPANLINE_STEP            \
  SPANLINE_PIECE(PIXEL, 14, 12, 10, 8) SPANLINE_NEXT_PIECE SPANLINE_STEP             \
  SPANLINE_PIECE(PIXEL, 6, 4, 2, 0)

// Registers are as above. On the stack: dz, the address 16 bytes into the run, and the caller's r7.
#define SPANLINE_ENTER_BLOCK(BLOCK, WRITE_BACK)                                \
  register TexelRun* self __asm__("r0") = this;                                \
  __asm__ volatile(".syntax unified\n\t"                                       \
                   "ldmia r0!, {r1, r2, r3, r4}\n\t"                           \
                   "mov r8, r3\n\t"                                            \
                   "mov lr, r4\n\t"                                            \
                   "push {r0, r7}\n\t"                                         \
                   "ldmia r0!, {r3, r6, r7}\n\t"                               \
                   "push {r3}\n\t"                                             \
                   "ldmia r0!, {r3, r4}\n\t"                                   \
                   "mov r9, r3\n\t"                                            \
                   "mov r10, r4\n\t"                                           \
                   "ldmia r0!, {r3, r4}\n\t"                                   \
                   "mov r11, r3\n\t"                                           \
                   "mov r12, r4\n\t"                                           \
                   "ldmia r0!, {r3, r4, r5}\n\t"                               \
                   "movs r0, r1\n\t"                                           \
                   "movs r1, r2\n\t"                                           \
                   "movs r2, r3\n\t"                                           \
                   "movs r3, r4\n\t"                                           \
                   "add pc, r5\n\t"                                            \
                   "nop\n\t"                                                   \
                   BLOCK(SPANLINE_TESTED)                                      \
                   "pop {r4, r5, r7}\n\t"                                      \
                   WRITE_BACK                                                  \
                   : "+r"(self)                                                \
                   :                                                           \
                   : "r1", "r2", "r3", "r4", "r5", "r6", "r8", "r9", "r10", "r11", "r12", "lr", "cc", "memory")

inline void TexelRun::draw_part_rightwards() {
  SPANLINE_ENTER_BLOCK(SPANLINE_BLOCK,
                       "subs r5, #16\n\t"
                       "adds r0, #32\n\t"
                       "adds r1, #32\n\t"
                       "mov r3, r8\n\t"
                       "stmia r5!, {r0, r1, r3}\n\t");
}
inline void TexelRun::draw_part_leftwards() { SPANLINE_ENTER_BLOCK(SPANLINE_BLOCK_LEFTWARDS, ""); }

#undef SPANLINE_DEPTH
#undef SPANLINE_TEXEL
#undef SPANLINE_STEP
#undef SPANLINE_NEXT_PIECE
#undef SPANLINE_TESTED
#undef SPANLINE_DEPTHS_4
#undef SPANLINE_PIECE
#undef SPANLINE_BLOCK
#undef SPANLINE_BLOCK_LEFTWARDS
#undef SPANLINE_ENTER_BLOCK
#undef SPANLINE_LOAD_BLOCK

// clang-format on

inline void TexelRun::draw_blocks(const void* blocks, std::uint32_t count) {
  whole = {blocks, pixels + 16 * count};
  draw_whole_blocks();
}

inline void TexelRun::draw_rightwards(const TextureBlock& block, std::uint32_t into) {
  TextureSteps at_first;
  at_first.restart(block);
  at_first.skip(into, block);
  part = {at_first.du, at_first.dv, block.ddu, block.ddv, at_first.u, at_first.v, entry_at(into)};
  depth -= into;
  pixels -= into;
  draw_part_rightwards();
}

// The increments apply to walking right; here they are subtracted from the steps, that is, added to the negated steps.
inline void TexelRun::draw_leftwards(const TextureBlock& block, std::uint32_t count) {
  TextureSteps at_last;
  at_last.restart(block);
  at_last.skip(count - 1, block);
  part = {0u - at_last.du, 0u - at_last.dv, block.ddu, block.ddv, at_last.u, at_last.v, entry_at(16 - count)};
  z += (count - 1) * dz;
  dz = 0u - dz;
  draw_part_leftwards();
}

/// Draws a run whose surface can give several blocks at once; returns false and draws nothing if it cannot. Two cases
/// go to `Portable`, a BlockRun: a run inside one block that touches neither of its ends, and whole blocks whose depths
/// are not word-aligned.
template <class Portable, TableSurface Surface>
[[gnu::always_inline]] inline bool texel_run(std::uint16_t* depth, std::uint16_t* pixels, std::uint32_t count,
                                             std::uint32_t z, std::uint32_t dz, const Surface& surface,
                                             std::int32_t first) {
  const TexelTable table = surface.texel_table();
  TexelRun at;  // what it draws is set with each
  at.depth = depth;
  at.pixels = pixels;
  at.z = z;
  at.texels = table.words;
  at.dz = dz;
  at.mask_u = 2 * table.mask_u;
  at.mask_v = 2 * table.mask_v;
  return for_certain_blocks(
      surface, first, count,
      [&](std::int32_t column, const TextureBlock& block, std::uint32_t into, std::uint32_t in_block)
          __attribute__((always_inline)) {
            if (into == 0)
              at.draw_leftwards(block, in_block);
            else if (into + in_block == 16)
              at.draw_rightwards(block, into);
            else  // and that is all of the run
              Portable::part(depth, pixels, z, dz, surface, column, block, into, in_block);
          },
      [&](std::int32_t column, const TextureBlock* blocks, std::uint32_t some) __attribute__((always_inline)) {
        if ((reinterpret_cast<std::uintptr_t>(at.depth) & 3) == 0) return at.draw_blocks(blocks, some);
        Portable::whole_blocks(at.depth, at.pixels, at.z, dz, surface, column, blocks, some);
        at.depth += 16 * some;
        at.pixels += 16 * some;
        at.z += 16 * some * dz;
      });
}

}  // namespace spanline::armv6m
#endif
