#include "spanline/geometry/vertex_transform.hpp"

#include <algorithm>

#include "spanline/cpu/transform_vertices.hpp"
#include "spanline/math/bits.hpp"
#include "spanline/math/integer.hpp"

namespace spanline {
namespace {

constexpr std::int64_t half_of_dropped = 1 << (VertexConstants::dropped_bits - 1);

int bit_count(std::int64_t value) { return 64 - leading_zeros_64(static_cast<std::uint64_t>(value) | 1); }

std::int64_t magnitude_64(std::int64_t v) { return v < 0 ? -v : v; }

/// The value modulo 2^32, for sums that are taken modulo 2^32.
std::int32_t wrapped(std::int64_t value) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(static_cast<std::uint64_t>(value)));
}

}  // namespace

bool VertexTransform::takes(const FrameView& view, const ViewTransform& transform, const Mesh& mesh,
                            Placement placement) {
  if (mesh.vertices.empty() || view.camera.projection != Projection::perspective) return false;
  if (placement != Placement::inside && placement != Placement::unclipped) return false;
  const std::int64_t nearest = transform.sphere_centre().z - transform.sphere_radius();
  const std::int64_t farthest = transform.sphere_centre().z + transform.sphere_radius();
  if (farthest > nearest * 4) return false;  // errors grow with this ratio
  // Matrix entries are rounded to 2^-16 of the greatest position. With positions within 512 pixels of the middle, the
  // error is below 1/32 pixel.
  const ViewPoint centre = transform.sphere_centre();
  const std::int64_t reach = std::max(magnitude_64(centre.x), magnitude_64(centre.y)) + transform.sphere_radius();
  if ((reach >> 14) * view.camera.focal.raw() > (std::int64_t{512} << 16) * (nearest >> 14)) return false;
  // If the near plane is too close, too few bits remain for the depth term scale / z.
  if (transform.near_plane() < farthest >> 20) return false;
  // Entries with their fraction bits must fit 32 bits. They would not for a mesh that is only a few steps large.
  const int entry_shift = transform.guard() + bit_count(farthest) - VertexConstants::distance_bits -
                          VertexConstants::distance_fraction_bits;
  for (int j = 0; j < 3; ++j)
    if (magnitude_64(shift_rounded(transform.entry(2, j), entry_shift)) >= std::int64_t{1} << 31) return false;
  // far / (far − near) < 4 is equivalent to near < 3/4·far.
  return transform.near_plane() < transform.far_plane() - (transform.far_plane() >> 2);
}

VertexTransform::VertexTransform(const FrameView& view, const ViewTransform& t) {
  VertexConstants& c = constants_;
  const std::int64_t focal = view.camera.focal.raw();
  const ViewPoint centre = t.sphere_centre();
  const std::int64_t radius = t.sphere_radius();

  // Distances are scaled so that the farthest fits 29 bits.
  const int z_shift = bit_count(centre.z + radius) - VertexConstants::distance_bits;
  for (int j = 0; j < 3; ++j) {
    const std::int64_t entry =
        shift_rounded(t.entry(2, j), t.guard() + z_shift - VertexConstants::distance_fraction_bits);
    c.z[j] = wrapped(entry);
  }
  c.z_offset = wrapped(shift_rounded(t.translation(2), t.guard() + z_shift));

  // Positions are scaled so that focal · the greatest |x| or |y| fits 30 bits. x_shift is limited so that the final
  // shift lies in [1, 31].
  const std::int64_t reach = std::max(magnitude_64(centre.x), magnitude_64(centre.y)) + radius;
  const std::int64_t exact_reach = ((reach >> 12) * focal) >> 4;        // focal has 16 fraction bits
  const std::int64_t greatest = exact_reach + (exact_reach >> 12) + 1;  // room for rounding
  const int x_shift = std::max(bit_count(greatest) - VertexConstants::position_bits, z_shift - 6);
  const auto position_entry = [&](std::int64_t entry) {
    return wrapped(shift_rounded(entry * focal, t.guard() + 16 + x_shift));
  };
  const auto position_offset = [&](std::int64_t translation) {
    const std::int64_t view_units = shift_rounded(translation, t.guard());
    return wrapped(shift_rounded((view_units >> 12) * focal, 4 + x_shift) + half_of_dropped);
  };
  for (int j = 0; j < 3; ++j) {
    c.x[j] = position_entry(t.entry(0, j));
    c.y[j] = position_entry(-t.entry(1, j));
  }
  c.x_offset = position_offset(t.translation(0));
  c.y_offset = position_offset(-t.translation(1));
  c.shift = 25 + z_shift - x_shift - 1;  // less 1, since rounding takes the last bit

  // Depth = base − scale / z with base = (2^N − 1)·f/(f − n) and scale = base·n.
  const std::int64_t near = t.near_plane(), range = t.far_plane() - near;
  const int narrow = std::max(0, bit_count(t.far_plane()) - 31);
  const auto full = static_cast<std::int64_t>((std::uint64_t{1} << view.depth_bits) - 1);
  c.depth_bits = view.depth_bits;
  c.depth_fraction = 27 - view.depth_bits;
  const std::int64_t base = divide_rounded((full << c.depth_fraction) * (t.far_plane() >> narrow), range >> narrow);
  c.depth_base = static_cast<std::uint32_t>(base) + (1u << (c.depth_fraction - 1));
  // base·n / 2^z_shift as a mantissa of 32 bits and an exponent; base < 2^29, and n is shifted to 31 bits.
  const int near_shift = bit_count(near) - 31;
  const std::int64_t near_mantissa = near_shift >= 0 ? near >> near_shift : near << -near_shift;
  const auto product =
      static_cast<std::uint64_t>(base) * static_cast<std::uint64_t>(near_mantissa);  // · 2^(near_shift − z_shift)
  const int product_zeros = leading_zeros_64(product);
  c.depth_scale = static_cast<std::uint32_t>((product << product_zeros) >> 32);
  // scale / z = mantissa · 2^(32 − zeros + near_shift − z_shift) · 2^k · r26 / 2^54. The kernel computes
  // r26·32·mantissa / 2^32.
  c.depth_shift = 27 - (32 - product_zeros + near_shift - z_shift);

  c.centre_x = view.viewport.width * 8 + ScreenVertex::bias;
  c.centre_y = view.viewport.height * 8 + ScreenVertex::bias;
  c.right = view.viewport.width * 16 + ScreenVertex::bias;
  c.bottom = view.viewport.height * 16 + ScreenVertex::bias;
  c.nearest = static_cast<std::int32_t>(view.nearest_depth);
  c.farthest = static_cast<std::int32_t>(view.farthest_depth);
}

void VertexTransform::run(std::span<const Vertex16> vertices, ScreenVertex* out, bool with_outcodes) const {
  if (with_outcodes)
    transform_vertices<true>(constants_, vertices, out);
  else
    transform_vertices<false>(constants_, vertices, out);
}

void transform_wide(const ViewTransform& transform, const PointProjection& projection, const Mesh& mesh,
                    ScreenVertex* out) {
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) out[i] = projection(view_point(transform, mesh, i));
}

}  // namespace spanline
