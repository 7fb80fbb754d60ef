#pragma once
#include <array>
#include <cstdint>

#include "spanline/math/bits.hpp"
#include "spanline/model/material.hpp"
#include "spanline/raster/linear_function.hpp"
#include "spanline/raster/texture_vertex.hpp"
#include "spanline/shade/texture/far_axes.hpp"

namespace spanline {

/// Texture coordinates on a polygon. At each pixel they depend on its screen position alone, not on the run that it
/// belongs to.
///
/// On affine polygons u and v are linear functions. In perspective w = 1/z, u·w and v·w are linear, and a division
/// gives u and v (lecture 004: s/w, t/w, 1/w). It is made at screen columns that are multiples of 16. Between two of
/// them the hyperbola is approximated by a parabola, which is drawn as four chords of 4 columns. Every pixel divides
/// for itself if w changes by more than a quarter over 16 columns, or if a block's end lies so far outside the polygon
/// that its words are invalid.
struct TexturePlane {
  enum class Way : std::uint8_t {
    affine,       ///< u and v are the texture coordinates themselves
    blocks,       ///< w, u and v are 30-bit words of 1/z, u/z and v/z; one division a block
    wide_blocks,  ///< the same; coordinates at both ends of a block may differ by more than a word
    exact,        ///< the same words, too steep for blocks; one division a pixel
    exact_far,    ///< the same, brought near along the plane's far axes
  };

  LinearFunction w, u, v;
  std::uint32_t base_u, base_v;  ///< perspective: whole textures subtracted from u and v
  std::int8_t shift_u, shift_v;  ///< right shift from u/w in Q30 to the texture coordinate; a left shift if negative
  std::int16_t origin;           ///< screen column of column 0
  Way way;
  FarAxes far;  ///< of exact_far alone

  void next_row() {
    w.next_row();
    u.next_row();
    v.next_row();
  }
  void skip_rows(std::int32_t rows) {
    w.skip_rows(rows);
    u.skip_rows(rows);
    v.skip_rows(rows);
  }
};

/// The values at a polygon's corners to which `fit_fine` fits a texture plane, and the plane's constants.
struct TexturePlaneValues {
  std::array<std::int32_t, 3> w, u, v;
  int bits;                      ///< size of the values
  std::uint32_t base_u, base_v;  ///< to be added to u and v
  /// As those of TexturePlane. For affine planes, the number of low bits that the values lack.
  std::uint32_t shift_u, shift_v;
  TexturePlane::Way way;
};

/// The fixed-point formats of texture coordinates: texels of one level, u with `fraction_u` and v with `fraction_v`
/// fraction bits, both modulo 2^32.
struct TexelScale {
  int log2_width, log2_height;
  int fraction_u, fraction_v;  ///< [8, 24]
};

/// The values for a triangle with these corners.
[[nodiscard]] TexturePlaneValues texture_plane_values(const std::array<TextureVertex, 3>& corners,
                                                      TextureMapping mapping, const TexelScale& scale);
/// The same for a plane with far axes: every pixel divides, on an affine one as well.
[[nodiscard]] TexturePlaneValues far_texture_plane_values(std::array<TextureVertex, 3> corners, TextureMapping mapping,
                                                          const TexelScale& scale);

/// Fits a texture plane to the values by a polygon's gradients.
template <class Gradients>
void fit_texture_plane(const Gradients& gradients, const TexturePlaneValues& values, TexturePlane& plane) {
  gradients.fit_fine(values.u, values.bits, plane.u);
  gradients.fit_fine(values.v, values.bits, plane.v);
  plane.base_u = values.base_u;
  plane.base_v = values.base_v;
  plane.shift_u = static_cast<std::int8_t>(values.shift_u);
  plane.shift_v = static_cast<std::int8_t>(values.shift_v);
  plane.origin = static_cast<std::int16_t>(gradients.origin());
  plane.way = values.way;
  if (values.way == TexturePlane::Way::affine) {
    plane.u = plane.u.shifted_left(values.shift_u);
    plane.v = plane.v.shifted_left(values.shift_v);
    plane.u.at_origin += values.base_u;
    plane.v.at_origin += values.base_v;
    return;
  }
  gradients.fit_fine(values.w, values.bits, plane.w);
  // Block ends lie within 15 columns of the polygon, where words are in [0, 2^30]. Below this slope the words at block
  // ends are in [−2^29, 3·2^29] and cannot wrap.
  constexpr std::uint32_t steepest = 1u << 25;
  const auto steep = [](const LinearFunction& f) { return magnitude(signed_word(f.dx)) >= steepest; };
  if (steep(plane.w) || steep(plane.u) || steep(plane.v)) plane.way = TexturePlane::Way::exact;
}

}  // namespace spanline
