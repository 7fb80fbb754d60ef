#include "spanline/geometry/clipper.hpp"

#include <algorithm>
#include <tuple>

#include "spanline/math/bits.hpp"
#include "spanline/math/integer.hpp"
#include "spanline/raster/texture_vertex.hpp"

namespace spanline {
namespace {

constexpr unsigned near_plane = 0, far_plane = 1, first_guard_plane = 2;
constexpr int dropped_bits = 13;  // low bits of view coordinates that guard-band distances drop; 31 bits remain

/// v·t / 2^31 for |v| < 2^45 and t ≤ 2^31, rounded down. It takes two products, since a single one would need 76 bits.
std::int64_t scaled(std::int64_t v, std::uint32_t t) {
  const std::int64_t high = (v >> 16) * static_cast<std::int64_t>(t);
  const std::int64_t low = ((v & 0xffff) * static_cast<std::int64_t>(t)) >> 16;
  return (high + low) >> 15;
}

bool comes_first(const ViewPoint& a, const ViewPoint& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); }

}  // namespace

Clipper::Clipper(const FrameView& view, const ViewTransform& transform, vertex_shade::Kind shades)
    : near_(transform.near_plane()), far_(transform.far_plane()), shades_(shades) {
  const std::int32_t focal = view.camera.focal.raw();
  // The guard band is centred on the picture's corner, view space on its middle. `room` is the distance from the middle
  // to one side of the guard band, in pixels · 2^16.
  const auto room = [](std::int32_t size, int side) { return (ScreenVertex::guard_pixels * 2 + side * size) * 32768; };
  for (unsigned i = 0; i < 4; ++i) {
    // Screen x grows with view x, screen y with −y. The room is larger by size/2 on the low side and smaller by size/2
    // on the high side.
    const bool vertical = i >= 2;
    const bool low = i % 2 == 0;
    const std::int32_t pixels = room(vertical ? view.viewport.height : view.viewport.width, low ? 1 : -1);
    const std::int32_t along = (low != vertical) ? focal : -focal;
    Plane& plane = guard_[i];
    plane = {vertical ? 0 : along, vertical ? along : 0, 0, 0};
    if (view.camera.projection == Projection::perspective) {
      plane.z = pixels;
    } else {
      const int shift = transform.exponent() - dropped_bits;
      plane.constant = shift >= 34 ? std::int64_t{1} << 61 : shift_rounded(pixels, -shift);
    }
  }
}

std::int64_t Clipper::distance(unsigned plane, const ViewPoint& point) const {
  if (plane == near_plane) return point.z - near_;
  if (plane == far_plane) return far_ - point.z;
  const Plane& p = guard_[plane - first_guard_plane];
  return p.x * (point.x >> dropped_bits) + p.y * (point.y >> dropped_bits) + p.z * (point.z >> dropped_bits) +
         p.constant;
}

ClipVertex Clipper::intersection(unsigned plane, const ClipVertex& a, std::int64_t distance_a, const ClipVertex& b,
                                 std::int64_t distance_b) const {
  const bool ordered = comes_first(a.point, b.point);
  const ClipVertex& from = ordered ? a : b;
  const ClipVertex& to = ordered ? b : a;
  const auto size = [](std::int64_t d) { return static_cast<std::uint64_t>(d < 0 ? -d : d); };
  const std::uint64_t part = size(ordered ? distance_a : distance_b);
  const std::uint64_t whole = size(distance_a) + size(distance_b);
  const int shift = std::max(0, 32 - leading_zeros_64(whole));
  const auto t = static_cast<std::uint32_t>(((part >> shift) << 31) / std::max<std::uint64_t>(1, whole >> shift));
  ClipVertex made;
  made.point = {from.point.x + scaled(to.point.x - from.point.x, t),
                from.point.y + scaled(to.point.y - from.point.y, t),
                from.point.z + scaled(to.point.z - from.point.z, t)};
  if (plane == near_plane) made.point.z = near_;
  if (plane == far_plane) made.point.z = far_;
  made.s = TextureVertex::mix(from.s, to.s, t);
  made.t = TextureVertex::mix(from.t, to.t, t);
  made.r = TextureVertex::mix(from.r, to.r, t);
  made.shade = vertex_shade::mix(shades_, from.shade, to.shade, t);
  return made;
}

void ClipPolygon::append(const ClipVertex& corner) {
  unsigned place = 0;
  while (place < corner_.size() && (taken_ >> place & 1) != 0) ++place;
  if (place == corner_.size() || count_ == most_corners) {
    overflowed_ = true;
    return;
  }
  corner_[place] = corner;
  taken_ = static_cast<std::uint16_t>(taken_ | 1u << place);
  order_[count_++] = static_cast<std::uint8_t>(place);
}

void Clipper::clip(ClipPolygon& polygon) const {
  for (unsigned plane = 0; plane < ClipPolygon::planes && polygon.count_ != 0; ++plane) {
    std::array<std::int64_t, ClipPolygon::most_corners> distances;
    bool cut = false;
    for (unsigned i = 0; i < polygon.count_; ++i) {
      const ClipVertex& vertex = polygon[i];
      distances[i] = distance(plane, vertex.point);
      if (plane >= first_guard_plane && vertex.in_guard_band) distances[i] = std::max<std::int64_t>(0, distances[i]);
      cut |= distances[i] < 0;
    }
    if (!cut) continue;
    const auto before = polygon.order_;
    const unsigned count = polygon.count_;
    polygon.count_ = 0;
    unsigned outside = 0;
    for (unsigned i = 0; i < count; ++i) {
      const unsigned j = i + 1 == count ? 0 : i + 1;
      if (distances[i] < 0)
        outside |= 1u << before[i];
      else if (polygon.count_ < ClipPolygon::most_corners)
        polygon.order_[polygon.count_++] = before[i];
      else
        polygon.overflowed_ = true;
      if ((distances[i] >= 0) != (distances[j] >= 0))
        polygon.append(
            intersection(plane, polygon.corner_[before[i]], distances[i], polygon.corner_[before[j]], distances[j]));
    }
    polygon.taken_ = static_cast<std::uint16_t>(polygon.taken_ & ~outside);
    if (polygon.count_ < 3) polygon.count_ = 0;
  }
}

}  // namespace spanline
