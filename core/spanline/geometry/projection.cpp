#include "spanline/geometry/projection.hpp"

#include <algorithm>

#include "spanline/math/bits.hpp"
#include "spanline/math/integer.hpp"

namespace spanline {
namespace {

constexpr std::int64_t far_away = 1 << 20;  // sixteenths of a pixel; stands for any position beyond the guard band
constexpr std::int64_t guard_sixteenths = ScreenVertex::guard_pixels * 16;

std::uint64_t absolute(std::int64_t value) {
  return value < 0 ? 0 - static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value);
}

}  // namespace

PointProjection::PointProjection(const FrameView& view, const ViewTransform& transform)
    : projection_(view.camera.projection),
      near_(transform.near_plane()),
      far_(transform.far_plane()),
      focal_raw_(view.camera.focal.raw()),
      width_(view.viewport.width * 16),
      height_(view.viewport.height * 16),
      depth_bits_(view.depth_bits),
      nearest_(view.nearest_depth),
      farthest_(view.farthest_depth) {
  exponent_shift_ = transform.exponent() + 16 - 4;
  // far / (far − near) ≥ 1 as a 32-bit mantissa and an exponent: numerator and denominator are normalised, then
  // divided. In an orthographic view the far plane may lie at the eye or behind it; the ratio is not used there.
  const std::int64_t range = std::max<std::int64_t>(1, far_ - near_), far = std::max<std::int64_t>(1, far_);
  const int far_zeros = leading_zeros_64(static_cast<std::uint64_t>(far)),
            range_zeros = leading_zeros_64(static_cast<std::uint64_t>(range));
  const std::uint64_t numerator = static_cast<std::uint64_t>(far) << far_zeros;                // [2^63, 2^64)
  const std::uint64_t denominator = (static_cast<std::uint64_t>(range) << range_zeros) >> 32;  // [2^31, 2^32)
  std::uint64_t quotient = numerator / denominator;  // ratio · 2^(far_zeros − range_zeros + 32), in (2^31, 2^33)
  int shift = far_zeros - range_zeros + 32;
  while (quotient >> 32) {
    quotient >>= 1;
    --shift;
  }
  ratio_ = static_cast<std::uint32_t>(quotient);
  ratio_shift_ = shift;
}

PointProjection::Sixteenths PointProjection::to_screen(const ViewPoint& point) const {
  std::int64_t x, y;
  if (projection_ == Projection::orthographic) {
    const auto scaled = [this](std::int64_t v) {
      // |v| < 2^44. Its upper 31 bits give 1/4096 of a sixteenth of a pixel at the guard band.
      const int narrow = 13;
      const std::int64_t product = (v >> narrow) * focal_raw_;
      const int shift = exponent_shift_ - narrow;
      if (shift > 62) return std::int64_t{0};
      if (shift <= 0) return product > 0 ? far_away : product < 0 ? -far_away : std::int64_t{0};
      return std::clamp<std::int64_t>(shift_rounded(product, shift), -far_away, far_away);
    };
    x = scaled(point.x);
    y = scaled(-point.y);
  } else {
    // The components are scaled until the greatest has 28 bits, so that 16·focal·x/z can be computed in 64 bits.
    const std::uint64_t greatest = absolute(point.x) | absolute(point.y) | absolute(point.z);
    const int shift = 36 - leading_zeros_64(greatest | 1);
    const auto normal = [shift](std::int64_t v) { return shift_rounded(v, shift); };
    const std::int64_t depth = std::max<std::int64_t>(1, normal(point.z));
    const auto scaled = [&](std::int64_t v) {
      return std::clamp<std::int64_t>(divide_rounded(normal(v) * focal_raw_, depth * 4096), -far_away, far_away);
    };
    x = scaled(point.x);
    y = scaled(-point.y);
  }
  return {x + width_ / 2, y + height_ / 2};
}

std::uint8_t PointProjection::viewport_codes(std::int64_t x, std::int64_t y) const {
  unsigned code = 0;
  if (x < 0) code |= outcode_left;
  if (x > width_) code |= outcode_right;
  if (y < 0) code |= outcode_top;
  if (y > height_) code |= outcode_bottom;
  return static_cast<std::uint8_t>(code);
}

std::uint32_t PointProjection::depth_at(std::int64_t z) const {
  const std::uint64_t greatest = (std::uint64_t{1} << depth_bits_) - 1;
  std::uint64_t share;  // position in the depth range, Q31 in [0, 1]
  const auto above_near = static_cast<std::uint64_t>(std::max<std::int64_t>(0, z - near_));
  if (projection_ == Projection::orthographic) {
    const auto range = static_cast<std::uint64_t>(std::max<std::int64_t>(1, far_ - near_));
    const int shift = std::max(0, 33 - leading_zeros_64(range | above_near));
    share = ((above_near >> shift) << 31) / std::max<std::uint64_t>(1, range >> shift);
  } else {
    // The share is (z − n)/z · f/(f − n). The first factor is computed in Q31 from z and z − n shortened to 32 bits.
    const int shift = std::max(0, 32 - leading_zeros_64(static_cast<std::uint64_t>(z)));
    const std::uint64_t part =
        ((above_near >> shift) << 31) / std::max<std::uint64_t>(1, static_cast<std::uint64_t>(z) >> shift);
    const std::uint64_t product = part * ratio_;  // Q31 · 2^ratio_shift
    share = ratio_shift_ >= 0 ? product >> ratio_shift_ : product << -ratio_shift_;
  }
  const std::uint64_t depth =
      (std::min<std::uint64_t>(share, std::uint64_t{1} << 31) * greatest + (std::uint64_t{1} << 30)) >> 31;
  return std::clamp(static_cast<std::uint32_t>(depth), nearest_, farthest_);
}

ScreenVertex PointProjection::operator()(const ViewPoint& point) const {
  if (point.z < near_) return ScreenVertex::make(0, 0, 0, depth_bits_, outcode_near);
  const auto far_code = static_cast<std::uint8_t>(point.z > far_ ? +outcode_far : 0);
  const auto [x, y] = to_screen(point);
  const auto code = static_cast<std::uint8_t>(viewport_codes(x, y) | far_code);
  const bool beyond = static_cast<std::int64_t>(absolute(x)) > guard_sixteenths ||
                      static_cast<std::int64_t>(absolute(y)) > guard_sixteenths;
  if (beyond) return ScreenVertex::make(0, 0, 0, depth_bits_, static_cast<std::uint8_t>(code | outcode_guard));
  const std::uint32_t depth = far_code != 0 ? farthest_ : depth_at(point.z);
  return ScreenVertex::make(static_cast<std::int32_t>(x), static_cast<std::int32_t>(y), depth, depth_bits_, code);
}

ScreenVertex PointProjection::clipped(const ViewPoint& point) const {
  auto [x, y] = to_screen(point);
  x = std::clamp(x, -guard_sixteenths, guard_sixteenths);
  y = std::clamp(y, -guard_sixteenths, guard_sixteenths);
  return ScreenVertex::make(static_cast<std::int32_t>(x), static_cast<std::int32_t>(y), depth_at(point.z), depth_bits_,
                            viewport_codes(x, y));
}

}  // namespace spanline
