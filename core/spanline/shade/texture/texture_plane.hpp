#pragma once
#include <array>
#include <cstdint>

#include "spanline/math/bits.hpp"
#include "spanline/model/material.hpp"
#include "spanline/raster/linear_function.hpp"
#include "spanline/raster/texture_vertex.hpp"

namespace spanline {

/// Texture coordinates over a polygon, as a function of (x, y) alone.
///
/// Affine polygons have u and v as linear functions. In perspective, w = 1/z, u·w and v·w are linear, and a division
/// gives u and v (lecture 004: s/w, t/w, 1/w). It is made at absolute screen columns that are multiples of 16; between
/// two of them a parabola stands for the hyperbola, drawn as four chords of 4 columns. Where 16 columns change w by
/// more than a quarter, or a block's end lies so far outside the polygon that its words mean nothing, each pixel
/// divides for itself.
struct TexturePlane {
  enum class Way : std::uint8_t {
    affine,  ///< u and v are texture coordinates
    blocks,  ///< w, u and v are 30-bit words of 1/z, u/z and v/z
    exact,   ///< the same, too steep for blocks: a division a pixel
  };

  LinearFunction w, u, v;
  std::uint32_t base_u, base_v;  ///< in perspective, whole textures that are left out of u and v
  std::int8_t shift_u, shift_v;  ///< Q30 of u/w to the texture coordinate: to the right, or negative to the left
  std::int16_t origin;           ///< screen column from which columns count
  Way way;

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

/// What fits a texture plane to a polygon: values at its corners for `fit_fine`, and the constants.
struct TexturePlaneValues {
  std::array<std::int32_t, 3> w, u, v;
  int bits;                      ///< of them
  std::uint32_t base_u, base_v;  ///< to be added to u and v
  std::uint32_t shift_u, shift_v;
  TexturePlane::Way way;
};

/// The fixed-point formats of texture coordinates, in texels of one level: u with `fraction_u` fraction bits and v with
/// `fraction_v`, both modulo 2^32.
struct TexelScale {
  int log2_width, log2_height;
  int fraction_u, fraction_v;  ///< [16, 24]
};

/// The values for three corners.
[[nodiscard]] TexturePlaneValues texture_plane_values(const std::array<TextureVertex, 3>& corners,
                                                      TextureMapping mapping, const TexelScale& scale);

/// Makes a texture plane of a polygon's gradients.
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
    plane.u.at_origin += values.base_u;
    plane.v.at_origin += values.base_v;
    return;
  }
  gradients.fit_fine(values.w, values.bits, plane.w);
  // A block's ends lie within 15 columns of the polygon, whose words are in [0, 2^30]: below this slope they are in
  // [−2^29, 3·2^29] there, and none wraps.
  constexpr std::uint32_t steepest = 1u << 25;
  const auto steep = [](const LinearFunction& f) { return magnitude(signed_word(f.dx)) >= steepest; };
  if (steep(plane.w) || steep(plane.u) || steep(plane.v)) plane.way = TexturePlane::Way::exact;
}

}  // namespace spanline
