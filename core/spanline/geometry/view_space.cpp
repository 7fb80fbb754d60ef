#include "spanline/geometry/view_space.hpp"

#include <algorithm>

#include "spanline/math/bits.hpp"
#include "spanline/math/integer.hpp"

namespace spanline {
namespace {

constexpr int view_bits = 43;        // |view coordinate| < 2^43 for anything inside the far plane
constexpr int entry_bits = 30;       // bits of matrix entries
constexpr int largest_guard = 18;    // translation·2^guard stays below 2^62
constexpr int world_fraction = 46;   // fraction bits of translations: Q30 rotation · Q16.16 position
constexpr int linear_fraction = 54;  // fraction bits of linear entries: Q30 rotation · Q8.24 scale

std::uint64_t absolute(std::int64_t value) {
  return value < 0 ? 0 - static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value);
}

/// Number of bits of `value` without leading zeros; 0 for 0.
int bit_count(std::uint64_t value) { return value == 0 ? 0 : 64 - leading_zeros_64(value); }

std::int64_t dot_wide(const Direction& row, std::int64_t x, std::int64_t y, std::int64_t z) {
  return row.x.raw() * x + row.y.raw() * y + row.z.raw() * z;
}

}  // namespace

std::int64_t ViewTransform::from_world(Q16_16 length) const { return shift_rounded(length.raw(), 16 - exponent_); }

ViewTransform::ViewTransform(const FrameView& view, const Mesh& mesh, const Transform& transform) {
  const Camera& camera = view.camera;
  const Rotation rotation = camera.axes * transform.rotation;
  const auto difference = [](Q16_16 a, Q16_16 b) { return static_cast<std::int64_t>(a.raw()) - b.raw(); };
  const std::int64_t dx = difference(transform.translation.x, camera.eye.x),
                     dy = difference(transform.translation.y, camera.eye.y),
                     dz = difference(transform.translation.z, camera.eye.z);

  std::int64_t linear[3][3];  // world units a step · 2^(54 − step exponent)
  std::int64_t position[3];   // world units · 2^46
  std::uint64_t greatest_linear = 0, greatest_position = 0;
  for (int i = 0; i < 3; ++i) {
    // The third view axis points backwards, but z is the distance forwards.
    const std::int64_t sign = i == 2 ? -1 : 1;
    const Direction& row = rotation.row[i];
    linear[i][0] = sign * row.x.raw() * transform.scale.raw();
    linear[i][1] = sign * row.y.raw() * transform.scale.raw();
    linear[i][2] = sign * row.z.raw() * transform.scale.raw();
    position[i] = sign * dot_wide(camera.axes.row[i], dx, dy, dz);
    for (const std::int64_t entry : linear[i]) greatest_linear = std::max(greatest_linear, absolute(entry));
    greatest_position = std::max(greatest_position, absolute(position[i]));
  }

  // The reach of the view is the farther of its two planes (the near plane of an orthographic view may lie far behind
  // the eye), or the greatest distance of the instance if that is larger. `steps` is a bound of |vertex + offset| over
  // all three axes.
  const std::uint64_t steps = static_cast<std::uint64_t>(magnitude(mesh.offset.x)) + magnitude(mesh.offset.y) +
                              magnitude(mesh.offset.z) + magnitude(mesh.bounds.centre.x) +
                              magnitude(mesh.bounds.centre.y) + magnitude(mesh.bounds.centre.z) + mesh.bounds.radius;
  const int instance_log2 = bit_count(greatest_linear) - linear_fraction + mesh.step_exponent + bit_count(steps) + 1;
  const int position_log2 = bit_count(greatest_position) - world_fraction;
  const int planes_log2 =
      bit_count(std::max(magnitude(camera.near_plane.raw()), magnitude(camera.far_plane.raw()))) - 16;
  const int reach_log2 = std::max({instance_log2, position_log2, planes_log2}) + 1;
  exponent_ = view_bits - reach_log2;

  const int entry_shift = linear_fraction - mesh.step_exponent - exponent_;  // right shift: linear → view units a step
  guard_ = std::min(largest_guard, entry_bits - (bit_count(greatest_linear) - entry_shift));
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const int shift = entry_shift - guard_;
      matrix_[i][j] = shift > 62 ? 0 : static_cast<std::int32_t>(shift_rounded(linear[i][j], shift));
    }
    translation_[i] = shift_rounded(position[i], world_fraction - exponent_ - guard_) +
                      static_cast<std::int64_t>(matrix_[i][0]) * mesh.offset.x +
                      static_cast<std::int64_t>(matrix_[i][1]) * mesh.offset.y +
                      static_cast<std::int64_t>(matrix_[i][2]) * mesh.offset.z;
  }
  near_ = from_world(camera.near_plane);
  far_ = from_world(camera.far_plane);
  centre_ = (*this)(mesh.bounds.centre.x, mesh.bounds.centre.y, mesh.bounds.centre.z);
  // radius · scale · 2^step_exponent in view units, increased by the errors of rounding and of the matrix
  const std::int64_t scale_linear = transform.scale.raw();  // Q24
  const int radius_shift = 24 - mesh.step_exponent - exponent_;
  const std::int64_t product = static_cast<std::int64_t>(mesh.bounds.radius) * scale_linear;
  radius_ = (radius_shift > 62 ? 0 : shift_rounded(product, radius_shift)) + 2 +
            (product >> std::min(62, std::max(0, radius_shift + 26)));
}

namespace {

/// The position of a sphere relative to a side plane of the frustum: inside if value ≥ reach, outside if value ≤
/// −reach.
struct SideTest {
  std::int64_t value;
  std::int64_t reach;
};

/// The plane focal·coordinate + half·depth = 0 through the eye and a side of the picture. Focal length and half the
/// picture's size are in 1/65536 pixel. With fewer bits, instances that leave the view could be classified as inside.
class SidePlane {
 public:
  SidePlane(std::int64_t focal, std::int64_t half)
      : focal_(focal), half_(half), norm_(square_root(static_cast<std::uint64_t>(focal * focal + half * half)) + 1) {}

  [[nodiscard]] SideTest test(std::int64_t coordinate, std::int64_t depth, std::int64_t radius) const {
    return {focal_ * (coordinate >> 14) + half_ * (depth >> 14), norm_ * ((radius >> 14) + 3)};
  }

 private:
  std::int64_t focal_, half_, norm_;  ///< below 2^31, 2^26, 2^32
};

/// Whether the sphere's projection stays inside the guard band, with a margin of 8 pixels.
bool within_guard_band(std::int64_t coordinate, std::int64_t nearest, std::int64_t radius, std::int64_t focal_raw,
                       std::int64_t half_pixels) {
  const std::int64_t spare_pixels = ScreenVertex::guard_pixels - 8 - half_pixels;
  const std::int64_t reach = static_cast<std::int64_t>(absolute(coordinate)) + radius;
  return (reach >> 14) * focal_raw <= (spare_pixels * 65536) * (nearest >> 14);
}

Placement place_orthographic(const FrameView& view, const ViewTransform& t) {
  const ViewPoint c = t.sphere_centre();
  const std::int64_t r = t.sphere_radius();
  // Half the size of the view in view units: (size / 2 pixels) / (pixels a world unit). It is limited to 2^61, where
  // everything is in view.
  const auto half = [&](std::int32_t pixels) {
    const std::int64_t world_q16 = (static_cast<std::int64_t>(pixels) << 31) / view.camera.focal.raw();
    const int shift = 16 - t.exponent();
    if (bit_count(static_cast<std::uint64_t>(world_q16)) - shift > 61) return std::int64_t{1} << 61;
    return shift_rounded(world_q16, shift);
  };
  const std::int64_t half_x = half(view.viewport.width), half_y = half(view.viewport.height);
  const auto x = static_cast<std::int64_t>(absolute(c.x)), y = static_cast<std::int64_t>(absolute(c.y));
  if (x - r > half_x || y - r > half_y) return Placement::outside;
  if (c.z - r < t.near_plane() || c.z + r > t.far_plane()) return Placement::clipped;
  return x + r < half_x && y + r < half_y ? Placement::inside : Placement::clipped;
}

}  // namespace

Placement place(const FrameView& view, const ViewTransform& t) {
  const ViewPoint c = t.sphere_centre();
  const std::int64_t r = t.sphere_radius();
  if (c.z + r < t.near_plane() || c.z - r > t.far_plane()) return Placement::outside;
  if (view.camera.projection == Projection::orthographic) return place_orthographic(view, t);

  const SidePlane side(view.camera.focal.raw(), view.viewport.width * 32768),
      end(view.camera.focal.raw(), view.viewport.height * 32768);
  bool inside = true;
  for (const SideTest test :
       {side.test(c.x, c.z, r), side.test(-c.x, c.z, r), end.test(c.y, c.z, r), end.test(-c.y, c.z, r)}) {
    if (test.value <= -test.reach) return Placement::outside;
    if (test.value < test.reach) inside = false;
  }
  const std::int64_t nearest = c.z - r;
  if (nearest < t.near_plane() || c.z + r > t.far_plane()) return Placement::clipped;
  if (inside) return Placement::inside;
  const bool guarded = within_guard_band(c.x, nearest, r, view.camera.focal.raw(), view.viewport.width / 2) &&
                       within_guard_band(c.y, nearest, r, view.camera.focal.raw(), view.viewport.height / 2);
  return guarded ? Placement::unclipped : Placement::clipped;
}

}  // namespace spanline
