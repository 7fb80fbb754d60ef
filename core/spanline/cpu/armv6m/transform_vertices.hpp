#pragma once
#include <cstdint>

#include "spanline/cpu/vertex_constants.hpp"
#include "spanline/math/bits.hpp"
#include "spanline/math/reciprocal.hpp"
#include "spanline/raster/screen_vertex.hpp"

#if defined(__ARM_ARCH_6M__)
namespace spanline::armv6m {

/// VertexConstants in the order in which the code for a vertex loads them: a load of several words costs about one
/// cycle a word, a load of a single word costs two.
struct TransformWords {
  std::uint32_t z_high[3], z_low[3], z_offset;  ///< distance: whole units and 14 fraction bits of the matrix entries
  std::int32_t x[3], x_offset, y[3], y_offset;
  const std::uint8_t* leading_zeros_of_byte;
  const std::uint16_t* reciprocal_seed;
  std::int32_t shift, twice_centre_x, twice_centre_y;
  std::uint32_t scale_low, scale_high;  ///< halfwords of depth_scale
  std::int32_t depth_shift;
  std::uint32_t depth_base;
  std::int32_t depth_fraction, nearest, farthest;
  std::uint32_t depth_position;  ///< position of the lowest bit of depth in a vertex's word
};
static_assert(sizeof(TransformWords) == 28 * 4);

// clang-format off

/// Transforms the vertices [first, end), at least one, of 6 bytes each, without outcodes. It does what
/// portable::transform_vertices does in C++, where compilers keep the constants on the stack and load them one by one.
/// Distances must be at least 2^24.
[[gnu::naked, gnu::noinline]] inline void transform_by_words(const TransformWords* /*words*/, const void* /*first*/,
                                                             ScreenVertex* /*out*/, const void* /*end*/) {
  // r8 vertex, r9 output, r10 constants, r11 and r12 x and y in view space, r14 distance; on the stack the end of the
  // vertices.
  __asm__ volatile(
      ".syntax unified\n\t"
      "push {r4, r5, r6, r7, lr}\n\t"
      "mov r4, r8\n\t"
      "mov r5, r9\n\t"
      "mov r6, r10\n\t"
      "mov r7, r11\n\t"
      "push {r3, r4, r5, r6, r7}\n\t"
      "mov r10, r0\n\t"
      "mov r8, r1\n\t"
      "mov r9, r2\n"
      "1: mov r7, r8\n\t"
      "movs r1, #0\n\t"
      "ldrsh r1, [r7, r1]\n\t"
      "movs r2, #2\n\t"
      "ldrsh r2, [r7, r2]\n\t"
      "movs r3, #4\n\t"
      "ldrsh r3, [r7, r3]\n\t"
      "adds r7, #6\n\t"
      "mov r8, r7\n\t"
      "mov r0, r10\n\t"
      "ldmia r0!, {r4, r5, r6}\n\t"  // distance
      "muls r4, r1\n\t"
      "muls r5, r2\n\t"
      "muls r6, r3\n\t"
      "adds r4, r4, r5\n\t"
      "adds r4, r4, r6\n\t"
      "ldmia r0!, {r5, r6, r7}\n\t"
      "muls r5, r1\n\t"
      "muls r6, r2\n\t"
      "muls r7, r3\n\t"
      "adds r5, r5, r6\n\t"
      "adds r5, r5, r7\n\t"
      "asrs r5, r5, #14\n\t"
      "adds r4, r4, r5\n\t"
      "ldmia r0!, {r5}\n\t"
      "adds r4, r4, r5\n\t"
      "mov lr, r4\n\t"
      "ldmia r0!, {r4, r5, r6, r7}\n\t"  // x
      "muls r4, r1\n\t"
      "muls r5, r2\n\t"
      "muls r6, r3\n\t"
      "adds r4, r4, r5\n\t"
      "adds r4, r4, r6\n\t"
      "adds r4, r4, r7\n\t"
      "asrs r4, r4, #15\n\t"
      "mov r11, r4\n\t"
      "ldmia r0!, {r4, r5, r6, r7}\n\t"  // y
      "muls r1, r4\n\t"
      "muls r2, r5\n\t"
      "muls r3, r6\n\t"
      "adds r1, r1, r2\n\t"
      "adds r1, r1, r3\n\t"
      "adds r1, r1, r7\n\t"
      "asrs r1, r1, #15\n\t"
      "mov r12, r1\n\t"
      "ldmia r0!, {r5, r6, r7}\n\t"  // r3 shift to 29 bits, r4 distance shifted
      "mov r4, lr\n\t"
      "lsrs r3, r4, #24\n\t"
      "ldrb r3, [r5, r3]\n\t"
      "subs r3, #3\n\t"
      "lsls r4, r3\n\t"
      "lsrs r5, r4, #21\n\t"  // r5 reciprocal of 16 bits
      "lsls r5, r5, #1\n\t"
      "ldrh r5, [r6, r5]\n\t"
      "lsrs r6, r4, #13\n\t"
      "muls r6, r5\n\t"
      "lsls r6, r6, #1\n\t"
      "negs r6, r6\n\t"
      "asrs r6, r6, #9\n\t"
      "muls r6, r5\n\t"
      "asrs r6, r6, #22\n\t"
      "adds r6, #1\n\t"
      "asrs r6, r6, #1\n\t"
      "adds r5, r5, r6\n\t"
      "muls r4, r5\n\t"  // r5 of 26 bits, r4 rounded to 16
      "negs r4, r4\n\t"
      "asrs r4, r4, #16\n\t"
      "muls r4, r5\n\t"
      "asrs r4, r4, #18\n\t"
      "lsls r5, r5, #10\n\t"
      "adds r5, r5, r4\n\t"
      "asrs r4, r5, #9\n\t"
      "adds r4, #1\n\t"
      "asrs r4, r4, #1\n\t"
      "subs r7, r7, r3\n\t"
      "ldmia r0!, {r1, r2}\n\t"  // r6 position on screen
      "mov r6, r11\n\t"
      "muls r6, r4\n\t"
      "asrs r6, r7\n\t"
      "adds r6, r6, r1\n\t"
      "asrs r6, r6, #1\n\t"
      "mov r1, r12\n\t"
      "muls r1, r4\n\t"
      "asrs r1, r7\n\t"
      "adds r1, r1, r2\n\t"
      "asrs r1, r1, #1\n\t"
      "uxth r6, r6\n\t"
      "lsls r1, r1, #16\n\t"
      "orrs r6, r1\n\t"
      "ldmia r0!, {r1, r2}\n\t"  // r5 high word of reciprocal and scale
      "lsls r5, r5, #5\n\t"
      "uxth r4, r5\n\t"
      "lsrs r5, r5, #16\n\t"
      "movs r7, r4\n\t"
      "muls r7, r1\n\t"
      "lsrs r7, r7, #16\n\t"
      "muls r1, r5\n\t"
      "adds r1, r1, r7\n\t"
      "muls r4, r2\n\t"
      "uxth r7, r1\n\t"
      "adds r4, r4, r7\n\t"
      "lsrs r4, r4, #16\n\t"
      "muls r5, r2\n\t"
      "lsrs r1, r1, #16\n\t"
      "adds r5, r5, r1\n\t"
      "adds r5, r5, r4\n\t"
      "ldmia r0!, {r1, r2, r4, r7}\n\t"  // r5 depth
      "subs r1, r1, r3\n\t"
      "lsrs r5, r1\n\t"
      "subs r5, r2, r5\n\t"
      "asrs r5, r4\n\t"
      "ldmia r0!, {r1, r2}\n\t"
      "cmp r5, r7\n\t"
      "blt 2f\n\t"
      "movs r7, r5\n\t"
      "cmp r5, r1\n\t"
      "bgt 3f\n"
      "2: lsls r7, r2\n\t"
      "mov r1, r9\n\t"
      "stmia r1!, {r6, r7}\n\t"
      "mov r9, r1\n\t"
      "ldr r1, [sp]\n\t"
      "cmp r8, r1\n\t"
      "beq 4f\n\t"
      "b 1b\n"
      "3: movs r7, r1\n\t"
      "b 2b\n"
      "4: pop {r3, r4, r5, r6, r7}\n\t"
      "mov r8, r4\n\t"
      "mov r9, r5\n\t"
      "mov r10, r6\n\t"
      "mov r11, r7\n\t"
      "pop {r4, r5, r6, r7, pc}\n");
}

// clang-format on

/// The same as portable::transform_vertices.
inline void transform_vertices(const VertexConstants& constants, const void* first, ScreenVertex* out,
                               const void* end) {
  if (first == end) return;
  constexpr int low_bits = VertexConstants::distance_fraction_bits;
  const auto low = [&](int j) { return word(constants.z[j] & ((1 << low_bits) - 1)); };
  const auto high = [&](int j) { return word(constants.z[j] >> low_bits); };
  const TransformWords words{.z_high = {high(0), high(1), high(2)},
                             .z_low = {low(0), low(1), low(2)},
                             .z_offset = word(constants.z_offset),
                             .x = {constants.x[0], constants.x[1], constants.x[2]},
                             .x_offset = constants.x_offset,
                             .y = {constants.y[0], constants.y[1], constants.y[2]},
                             .y_offset = constants.y_offset,
                             .leading_zeros_of_byte = detail::leading_zeros_of_byte.data(),
                             .reciprocal_seed = detail::reciprocal_seed.data(),
                             .shift = constants.shift,
                             .twice_centre_x = 2 * constants.centre_x + 1,
                             .twice_centre_y = 2 * constants.centre_y + 1,
                             .scale_low = constants.depth_scale & 0xffff,
                             .scale_high = constants.depth_scale >> 16,
                             .depth_shift = constants.depth_shift,
                             .depth_base = constants.depth_base,
                             .depth_fraction = constants.depth_fraction,
                             .nearest = constants.nearest,
                             .farthest = constants.farthest,
                             .depth_position = static_cast<std::uint32_t>(32 - constants.depth_bits)};
  transform_by_words(&words, first, out, end);
}

}  // namespace spanline::armv6m
#endif
