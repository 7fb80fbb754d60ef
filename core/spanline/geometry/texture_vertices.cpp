#include "spanline/geometry/texture_vertices.hpp"

#include <algorithm>

#include "spanline/geometry/vertex_transform.hpp"
#include "spanline/math/bits.hpp"
#include "spanline/math/integer.hpp"
#include "spanline/math/inverse_root.hpp"
#include "spanline/math/reciprocal.hpp"

namespace spanline {
namespace {

constexpr std::uint32_t nearest_of_all = 1u << 31;

std::uint32_t normalised(std::int64_t value, int& zeros) {
  const auto positive = static_cast<std::uint64_t>(std::max<std::int64_t>(1, value));
  zeros = leading_zeros_64(positive);
  return static_cast<std::uint32_t>((positive << zeros) >> 32);
}

/// One row of the texture matrix, applied to texture coordinates of the mesh.
struct MatrixRow {
  std::int64_t s, t, one;
  int shift;

  MatrixRow(Q16_16 of_s, Q16_16 of_t, Q16_16 offset, int texture_exponent)
      : s(of_s.raw()),
        t(of_t.raw()),
        one(static_cast<std::int64_t>(offset.raw()) * (1 << (TextureUnits::fraction_bits - 16))),
        shift(16 - TextureUnits::fraction_bits - texture_exponent) {}
  [[nodiscard]] std::int32_t operator()(TextureCoordinate c) const {
    return static_cast<std::int32_t>(shift_rounded(s * c.s + t * c.t, shift) + one);
  }
};

}  // namespace

Nearness::Nearness(const FrameView& view, const ViewTransform& transform)
    : perspective_(view.camera.projection == Projection::perspective) {
  nearest_ = normalised(std::max(transform.near_plane(), transform.sphere_centre().z - transform.sphere_radius()),
                        nearest_zeros_);
}

std::uint32_t Nearness::operator()(std::int64_t z) const {
  if (!perspective_) return nearest_of_all;
  int zeros;
  const std::uint32_t distance = normalised(z, zeros);
  const int shift = nearest_zeros_ - zeros;  // bits that the distance has more than the nearest one
  if (shift < 0) return nearest_of_all;
  if (shift > 31) return 1;
  // nearest/distance · 2^30 in (2^29, 2^31]
  const std::uint32_t ratio = multiply_high(nearest_, reciprocal_32(distance));
  const std::uint32_t scaled = shift == 0 ? std::min(ratio, nearest_of_all / 2) * 2 : ratio >> (shift - 1);
  return std::clamp<std::uint32_t>(scaled, 1, nearest_of_all);
}

void make_texture_vertices(const ViewTransform& transform, const Nearness& nearness, const Mesh& mesh,
                           const TextureMatrix& matrix, TextureVertex* out) {
  const MatrixRow row_s(matrix.ss, matrix.st, matrix.s0, mesh.texture_exponent);
  const MatrixRow row_t(matrix.ts, matrix.tt, matrix.t0, mesh.texture_exponent);
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
    const TextureCoordinate& c = mesh.texture_coordinates[i];
    out[i] = {nearness(view_point(transform, mesh, i).z), row_s(c), row_t(c)};
  }
}

void make_sphere_map_vertices(const ViewTransform& transform, const Rotation& normals_to_view, Projection projection,
                              const Nearness& nearness, const Mesh& mesh, const TextureMatrix& matrix,
                              TextureVertex* out) {
  constexpr int exponent = -14;
  constexpr std::int32_t one = 1 << 30;
  const MatrixRow row_s(matrix.ss, matrix.st, matrix.s0, exponent);
  const MatrixRow row_t(matrix.ts, matrix.tt, matrix.t0, exponent);
  const auto product = [](std::int64_t a, std::int32_t b) { return (a * b) >> 30; };
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
    const ViewPoint point = view_point(transform, mesh, i);
    // In the axes of view: x to the right, y up, z towards the viewer.
    const Direction sight = projection == Projection::perspective
                                ? direction_and_length(point.x, point.y, -point.z).direction
                                : Direction{{}, {}, -Q2_30::from_int(1)};
    const PackedNormal packed = mesh.vertex_normals[i];
    constexpr std::int32_t unit = (one + 255) / 511;
    const Direction normal =
        normals_to_view * Direction{Q2_30::from_raw(packed.x() * unit), Q2_30::from_raw(packed.y() * unit),
                                    Q2_30::from_raw(packed.z() * unit)};
    const std::int64_t twice_along = 2 * std::int64_t{dot(sight, normal).raw()};
    const auto mirrored = [&](Q2_30 along, Q2_30 across) { return along.raw() - product(twice_along, across.raw()); };
    const Direction half = direction_and_length(mirrored(sight.x, normal.x), mirrored(sight.y, normal.y),
                                                mirrored(sight.z, normal.z) + one)
                               .direction;
    const auto coordinate = [](std::int32_t h) {
      return static_cast<std::int16_t>(((one >> 1) + (h >> 1) + (1 << 15)) >> 16);
    };
    const TextureCoordinate c{coordinate(half.x.raw()), coordinate(-half.y.raw())};
    out[i] = {nearness(point.z), row_s(c), row_t(c)};
  }
}

void make_volume_vertices(const ViewTransform& transform, const Nearness& nearness, const Mesh& mesh,
                          const Volume& volume, TextureVertex* out, std::int32_t* third) {
  // Steps · scale have 16 fraction bits, texture coordinates have 20. Coordinates beyond the range of 32 bits wrap.
  const int shift = 16 - TextureUnits::fraction_bits - mesh.step_exponent - volume.exponent;
  const auto coordinate = [&](std::int32_t steps, std::int32_t offset, Q16_16 origin) {
    const std::int64_t product = (static_cast<std::int64_t>(steps) + offset) * volume.scale.raw();
    const std::uint64_t scaled = shift > 62  ? 0
                                 : shift > 0 ? static_cast<std::uint64_t>(shift_rounded(product, shift))
                                             : static_cast<std::uint64_t>(product) << std::min(-shift, 63);
    return signed_word(static_cast<std::uint32_t>(scaled) + (word(origin.raw()) << (TextureUnits::fraction_bits - 16)));
  };
  const Vec3<std::int32_t>& offset = mesh.offset;
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
    const Vertex32 v = mesh.vertex(i);
    out[i] = {nearness(view_point(transform, mesh, i).z), coordinate(v.x, offset.x, volume.origin.x),
              coordinate(v.y, offset.y, volume.origin.y)};
    third[i] = coordinate(v.z, offset.z, volume.origin.z);
  }
}

TextureVertexMaker TextureVertexMaker::for_instance(const Nearness& nearness) {
  return {&nearness, [](const Nearness& scale, std::int64_t z, std::int32_t s, std::int32_t t) {
            return TextureVertex{scale(z), s, t};
          }};
}

}  // namespace spanline
