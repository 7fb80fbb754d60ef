#include "spanline/geometry/vertex_transform.hpp"

#include <algorithm>

#include "spanline/cpu/armv6m/transform.hpp"
#include "spanline/math/bits.hpp"
#include "spanline/math/integer.hpp"
#include "spanline/math/reciprocal.hpp"

namespace spanline {
namespace {

constexpr int depth_range_bits = 29;  // of a distance: [1, 2^29)
constexpr int position_bits = 30;     // of focal · x
constexpr int dropped_bits = 15;      // of a position before it meets the reciprocal
constexpr std::int64_t half_of_dropped = 1 << (dropped_bits - 1);
constexpr int low_bits = 14;  // fraction of a distance's matrix entries
[[maybe_unused]] constexpr std::int32_t low_mask = (1 << low_bits) - 1;

int bit_count(std::int64_t value) { return 64 - leading_zeros_64(static_cast<std::uint64_t>(value) | 1); }

std::int64_t magnitude_64(std::int64_t v) { return v < 0 ? -v : v; }

/// Modulo 2^32, as the sums it goes into.
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
  if (farthest > nearest * 4) return false;  // errors grow with it
  // Matrix entries are rounded to 2^-16 of the greatest position: 512 pixels from the middle keep that below 1/32
  // pixel.
  const ViewPoint centre = transform.sphere_centre();
  const std::int64_t reach = std::max(magnitude_64(centre.x), magnitude_64(centre.y)) + transform.sphere_radius();
  if ((reach >> 14) * view.camera.focal.raw() > (std::int64_t{512} << 16) * (nearest >> 14)) return false;
  // The share of depth behind the near plane must keep a few bits.
  if (transform.near_plane() < farthest >> 20) return false;
  // Entries with their fraction must fit 32 bits, which those of a mesh of very few steps would not.
  const int entry_shift = transform.guard() + bit_count(farthest) - depth_range_bits - low_bits;
  for (int j = 0; j < 3; ++j)
    if (magnitude_64(shift_rounded(transform.entry(2, j), entry_shift)) >= std::int64_t{1} << 31) return false;
  // far / (far − near) < 4, that is near < 3/4 far
  return transform.near_plane() < transform.far_plane() - (transform.far_plane() >> 2);
}

VertexTransform::VertexTransform(const FrameView& view, const ViewTransform& t) {
  const std::int64_t focal = view.camera.focal.raw();
  const ViewPoint centre = t.sphere_centre();
  const std::int64_t radius = t.sphere_radius();

  // Distance: the farthest fits 29 bits.
  const int z_shift = bit_count(centre.z + radius) - depth_range_bits;
  for (int j = 0; j < 3; ++j) {
    const std::int64_t entry = shift_rounded(t.entry(2, j), t.guard() + z_shift - low_bits);
    z_[j] = wrapped(entry);
  }
  tz_ = wrapped(shift_rounded(t.translation(2), t.guard() + z_shift));

  // Position: focal · the greatest |x| or |y| fits 30 bits. The shift must leave the final one in [1, 31].
  const std::int64_t reach = std::max(magnitude_64(centre.x), magnitude_64(centre.y)) + radius;
  const std::int64_t exact_reach = ((reach >> 12) * focal) >> 4;        // focal has 16 fraction bits
  const std::int64_t greatest = exact_reach + (exact_reach >> 12) + 1;  // room for rounding
  const int x_shift = std::max(bit_count(greatest) - position_bits, z_shift - 6);
  const auto position_entry = [&](std::int64_t entry) {
    return wrapped(shift_rounded(entry * focal, t.guard() + 16 + x_shift));
  };
  const auto position_offset = [&](std::int64_t translation) {
    const std::int64_t view_units = shift_rounded(translation, t.guard());
    return wrapped(shift_rounded((view_units >> 12) * focal, 4 + x_shift) + half_of_dropped);
  };
  for (int j = 0; j < 3; ++j) {
    x_[j] = position_entry(t.entry(0, j));
    y_[j] = position_entry(-t.entry(1, j));
  }
  tx_ = position_offset(t.translation(0));
  ty_ = position_offset(-t.translation(1));
  shift_ = 25 + z_shift - x_shift - 1;  // the last bit goes with the rounding

  // Depth = base − scale / z with base = (2^N − 1)·f/(f − n) and scale = base·n.
  const std::int64_t near = t.near_plane(), range = t.far_plane() - near;
  const int narrow = std::max(0, bit_count(t.far_plane()) - 31);
  const auto full = static_cast<std::int64_t>((std::uint64_t{1} << view.depth_bits) - 1);
  depth_bits_ = view.depth_bits;
  depth_fraction_ = 27 - view.depth_bits;
  const std::int64_t base = divide_rounded((full << depth_fraction_) * (t.far_plane() >> narrow), range >> narrow);
  depth_base_ = static_cast<std::uint32_t>(base) + (1u << (depth_fraction_ - 1));
  // base·n / 2^z_shift as a mantissa of 32 bits and an exponent; base < 2^29, near is brought to 31 bits.
  const int near_shift = bit_count(near) - 31;
  const std::int64_t near_mantissa = near_shift >= 0 ? near >> near_shift : near << -near_shift;
  const auto product =
      static_cast<std::uint64_t>(base) * static_cast<std::uint64_t>(near_mantissa);  // · 2^(near_shift − z_shift)
  const int product_zeros = leading_zeros_64(product);
  depth_scale_ = static_cast<std::uint32_t>((product << product_zeros) >> 32);
  // scale / z = mantissa · 2^(32 − zeros + near_shift − z_shift) · 2^k · r26 / 2^54, where r26·32·mantissa / 2^32 is
  // computed.
  depth_shift_ = 27 - (32 - product_zeros + near_shift - z_shift);

  centre_x_ = view.viewport.width * 8 + ScreenVertex::bias;
  centre_y_ = view.viewport.height * 8 + ScreenVertex::bias;
  right_ = view.viewport.width * 16 + ScreenVertex::bias;
  bottom_ = view.viewport.height * 16 + ScreenVertex::bias;
  nearest_ = static_cast<std::int32_t>(view.nearest_depth);
  farthest_ = static_cast<std::int32_t>(view.farthest_depth);
}

template <bool WithOutcodes>
void VertexTransform::run_all(std::span<const Vertex16> vertices, ScreenVertex* out) const {
  // A copy that no store can alias: its constants stay where the compiler puts them.
  const VertexTransform t = *this;
  const auto depth_position = static_cast<std::uint32_t>(32 - t.depth_bits_);
  const std::int32_t twice_centre_x = 2 * t.centre_x_ + 1, twice_centre_y = 2 * t.centre_y_ + 1;
#if defined(__ARM_ARCH_6M__)
  const std::uint32_t low_x = word(t.z_[0] & low_mask), low_y = word(t.z_[1] & low_mask),
                      low_z = word(t.z_[2] & low_mask);
  const std::uint32_t high_x = word(t.z_[0] >> low_bits), high_y = word(t.z_[1] >> low_bits),
                      high_z = word(t.z_[2] >> low_bits);
#endif
  for (const Vertex16& vertex : vertices) {
    const std::uint32_t px = word(vertex.x), py = word(vertex.y), pz = word(vertex.z);
    // Distance, entries with 14 fraction bits: one long product a component, or two short ones; the same bits.
#if defined(__ARM_ARCH_6M__)
    const std::uint32_t low = low_x * px + low_y * py + low_z * pz;
    const std::uint32_t distance =
        high_x * px + high_y * py + high_z * pz + word(t.tz_) + word(signed_word(low) >> low_bits);
#else
    const std::int64_t sum = static_cast<std::int64_t>(t.z_[0]) * vertex.x +
                             static_cast<std::int64_t>(t.z_[1]) * vertex.y +
                             static_cast<std::int64_t>(t.z_[2]) * vertex.z;
    const std::uint32_t distance =
        static_cast<std::uint32_t>(static_cast<std::uint64_t>(sum >> low_bits)) + word(t.tz_);
#endif
    const std::int32_t view_x =
        signed_word(word(t.x_[0]) * px + word(t.x_[1]) * py + word(t.x_[2]) * pz + word(t.tx_)) >> dropped_bits;
    const std::int32_t view_y =
        signed_word(word(t.y_[0]) * px + word(t.y_[1]) * py + word(t.y_[2]) * pz + word(t.ty_)) >> dropped_bits;

    const int normalise = leading_zeros_32(distance) - (32 - depth_range_bits);
    const std::uint32_t z = distance << normalise;  // [2^28, 2^29)
    // Two Newton steps: 2^44 / z with 16 bits, then 2^54 / z with 26. z·seed ≈ 2^44, so its low word is the error.
    const std::uint32_t seed = reciprocal_16(z >> 13);
    const std::int32_t error = signed_word(0u - z * seed);
    const std::uint32_t fine = (seed << 10) + word(((error >> 16) * signed_word(seed)) >> 18);
    const std::int32_t reciprocal = shift_right_rounded(signed_word(fine), 10);
    const int shift = t.shift_ - normalise;
    // Rounded and centred in one: ((v + 1) >> 1) + centre = (v + 1 + 2·centre) >> 1.
    const std::int32_t biased_x = (((view_x * reciprocal) >> shift) + twice_centre_x) >> 1;
    const std::int32_t biased_y = (((view_y * reciprocal) >> shift) + twice_centre_y) >> 1;

    const std::uint32_t behind = multiply_high(fine << 5, t.depth_scale_) >> (t.depth_shift_ - normalise);
    std::int32_t depth = signed_word(t.depth_base_ - behind) >> t.depth_fraction_;
    depth = depth < t.nearest_ ? t.nearest_ : depth > t.farthest_ ? t.farthest_ : depth;

    std::uint32_t code = 0;
    if constexpr (WithOutcodes) {
      if (biased_x < ScreenVertex::bias) code |= outcode_left;
      if (biased_x > t.right_) code |= outcode_right;
      if (biased_y < ScreenVertex::bias) code |= outcode_top;
      if (biased_y > t.bottom_) code |= outcode_bottom;
    }
    out->x = static_cast<std::uint16_t>(biased_x);
    out->y = static_cast<std::uint16_t>(biased_y);
    out->depth_word = word(depth) << depth_position | code;
    ++out;
  }
}

#if defined(__ARM_ARCH_6M__)
template <>
void VertexTransform::run_all<false>(std::span<const Vertex16> vertices, ScreenVertex* out) const {
  if (vertices.empty()) return;
  const auto low = [this](int j) { return word(z_[j] & low_mask); };
  const auto high = [this](int j) { return word(z_[j] >> low_bits); };
  const armv6m::TransformWords words{.z_high = {high(0), high(1), high(2)},
                                     .z_low = {low(0), low(1), low(2)},
                                     .z_offset = word(tz_),
                                     .x = {x_[0], x_[1], x_[2]},
                                     .x_offset = tx_,
                                     .y = {y_[0], y_[1], y_[2]},
                                     .y_offset = ty_,
                                     .leading_zeros_of_byte = detail::leading_zeros_of_byte.data(),
                                     .reciprocal_seed = detail::reciprocal_seed.data(),
                                     .shift = shift_,
                                     .twice_centre_x = 2 * centre_x_ + 1,
                                     .twice_centre_y = 2 * centre_y_ + 1,
                                     .scale_low = depth_scale_ & 0xffff,
                                     .scale_high = depth_scale_ >> 16,
                                     .depth_shift = depth_shift_,
                                     .depth_base = depth_base_,
                                     .depth_fraction = depth_fraction_,
                                     .nearest = nearest_,
                                     .farthest = farthest_,
                                     .depth_position = static_cast<std::uint32_t>(32 - depth_bits_)};
  armv6m::transform_vertices(&words, vertices.data(), out, vertices.data() + vertices.size());
}
#endif

void VertexTransform::run(std::span<const Vertex16> vertices, ScreenVertex* out, bool with_outcodes) const {
  if (with_outcodes)
    run_all<true>(vertices, out);
  else
    run_all<false>(vertices, out);
}

void transform_wide(const ViewTransform& transform, const PointProjection& projection, const Mesh& mesh,
                    ScreenVertex* out) {
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) out[i] = projection(view_point(transform, mesh, i));
}

}  // namespace spanline
