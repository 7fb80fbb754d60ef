#pragma once
#include <cstdint>
#include <span>

#include "spanline/cpu/armv6m/transform_vertices.hpp"
#include "spanline/cpu/form.hpp"
#include "spanline/cpu/vertex_constants.hpp"
#include "spanline/math/bits.hpp"
#include "spanline/math/reciprocal.hpp"
#include "spanline/raster/screen_vertex.hpp"

namespace spanline {

namespace portable {

template <bool WithOutcodes, class Vertex>
inline void transform_vertices(const VertexConstants& constants, std::span<const Vertex> vertices, ScreenVertex* out) {
  // A local copy, which stores to `out` cannot alias.
  const VertexConstants t = constants;
  constexpr int low_bits = VertexConstants::distance_fraction_bits;
  const auto depth_position = static_cast<std::uint32_t>(32 - t.depth_bits);
  const std::int32_t twice_centre_x = 2 * t.centre_x + 1, twice_centre_y = 2 * t.centre_y + 1;
#if defined(__ARM_ARCH_6M__)
  constexpr std::int32_t low_mask = (1 << low_bits) - 1;
  const std::uint32_t low_x = word(t.z[0] & low_mask), low_y = word(t.z[1] & low_mask), low_z = word(t.z[2] & low_mask);
  const std::uint32_t high_x = word(t.z[0] >> low_bits), high_y = word(t.z[1] >> low_bits),
                      high_z = word(t.z[2] >> low_bits);
#endif
  for (const Vertex& vertex : vertices) {
    const std::uint32_t px = word(vertex.x), py = word(vertex.y), pz = word(vertex.z);
    // Distance: matrix entries have 14 fraction bits. One long product a component, or two short ones, give the same
    // bits.
#if defined(__ARM_ARCH_6M__)
    const std::uint32_t low = low_x * px + low_y * py + low_z * pz;
    const std::uint32_t distance =
        high_x * px + high_y * py + high_z * pz + word(t.z_offset) + word(signed_word(low) >> low_bits);
#else
    const std::int64_t sum = static_cast<std::int64_t>(t.z[0]) * vertex.x +
                             static_cast<std::int64_t>(t.z[1]) * vertex.y +
                             static_cast<std::int64_t>(t.z[2]) * vertex.z;
    const std::uint32_t distance =
        static_cast<std::uint32_t>(static_cast<std::uint64_t>(sum >> low_bits)) + word(t.z_offset);
#endif
    const std::int32_t view_x =
        signed_word(word(t.x[0]) * px + word(t.x[1]) * py + word(t.x[2]) * pz + word(t.x_offset)) >>
        VertexConstants::dropped_bits;
    const std::int32_t view_y =
        signed_word(word(t.y[0]) * px + word(t.y[1]) * py + word(t.y[2]) * pz + word(t.y_offset)) >>
        VertexConstants::dropped_bits;

    const int normalise = leading_zeros_32(distance) - (32 - VertexConstants::distance_bits);
    const std::uint32_t z = distance << normalise;  // [2^28, 2^29)
    // Two Newton steps give 2^44 / z to 16 bits and then 2^54 / z to 26. z·seed ≈ 2^44, so the low word of the product
    // is the error.
    const std::uint32_t seed = reciprocal_16(z >> 13);
    const std::int32_t error = signed_word(0u - z * seed);
    const std::uint32_t fine = (seed << 10) + word(((error >> 16) * signed_word(seed)) >> 18);
    const std::int32_t reciprocal = shift_right_rounded(signed_word(fine), 10);
    const int shift = t.shift - normalise;
    // Rounding and the move to the centre share one shift: ((v + 1) >> 1) + centre = (v + 1 + 2·centre) >> 1.
    const std::int32_t biased_x = (((view_x * reciprocal) >> shift) + twice_centre_x) >> 1;
    const std::int32_t biased_y = (((view_y * reciprocal) >> shift) + twice_centre_y) >> 1;

    const std::uint32_t behind = multiply_high(fine << 5, t.depth_scale) >> (t.depth_shift - normalise);
    std::int32_t depth = signed_word(t.depth_base - behind) >> t.depth_fraction;
    depth = depth < t.nearest ? t.nearest : depth > t.farthest ? t.farthest : depth;

    std::uint32_t code = 0;
    if constexpr (WithOutcodes) {
      if (biased_x < ScreenVertex::bias) code |= outcode_left;
      if (biased_x > t.right) code |= outcode_right;
      if (biased_y < ScreenVertex::bias) code |= outcode_top;
      if (biased_y > t.bottom) code |= outcode_bottom;
    }
    out->x = static_cast<std::uint16_t>(biased_x);
    out->y = static_cast<std::uint16_t>(biased_y);
    out->depth_word = word(depth) << depth_position | code;
    ++out;
  }
}

}  // namespace portable

/// Transforms vertices of three 16-bit coordinates x, y and z. Without outcodes, all vertices of the mesh must project
/// into the viewport.
template <bool WithOutcodes, Form form = Form::fastest, class Vertex>
inline void transform_vertices(const VertexConstants& constants, std::span<const Vertex> vertices, ScreenVertex* out) {
  static_assert(sizeof(Vertex) == 6);
#if defined(__ARM_ARCH_6M__)
  if constexpr (form == Form::fastest && !WithOutcodes)
    return armv6m::transform_vertices(constants, vertices.data(), out, vertices.data() + vertices.size());
#endif
  portable::transform_vertices<WithOutcodes>(constants, vertices, out);
}

}  // namespace spanline
