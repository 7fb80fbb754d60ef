#include "spanline/geometry/fan_lines.hpp"

#include "spanline/geometry/vertex_transform.hpp"

namespace spanline {
namespace {

std::int64_t magnitude_of(std::int64_t value) { return value < 0 ? -value : value; }

struct Direction {
  std::int64_t x, y, z;
};

/// The cross product of two points, |component| < 2^31 each, shifted to the right until its components are below 2^29.
Direction normal_of(const Direction& p, const Direction& q) {
  Direction n{p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
  while (((magnitude_of(n.x) | magnitude_of(n.y) | magnitude_of(n.z)) >> 29) != 0) n = {n.x >> 1, n.y >> 1, n.z >> 1};
  return n;
}

Direction direction_of(const FrameView& view, const ViewTransform& transform, const Mesh& mesh, Link vertex) {
  constexpr int dropped_bits = 14;  // of the 44 bits of a component
  const ViewPoint p = view_point(transform, mesh, vertex);
  // In orthographic views the line of sight is moved aside, so all points are as far as one world unit.
  const bool perspective = view.camera.projection == Projection::perspective;
  const int unit = transform.exponent() - dropped_bits;
  const std::int64_t far = unit < 0 ? 1 : std::int64_t{1} << (unit < 30 ? unit : 30);
  return {p.x >> dropped_bits, p.y >> dropped_bits, perspective ? p.z >> dropped_bits : far};
}

/// The line where the plane through the eye, corner 0 and corner i meets the screen. The line of sight of pixel (X, Y)
/// is (X + ½ − width/2, height/2 − Y − ½, focal), and it lies on one side of that plane or the other.
HalfPlane make_line(const FrameView& view, const ViewTransform& transform, const Mesh& mesh, const Outline& corners,
                    unsigned i, bool clockwise) {
  Direction n = normal_of(direction_of(view, transform, mesh, corners.number(0)),
                          direction_of(view, transform, mesh, corners.number(i)));
  if (clockwise) n = {-n.x, -n.y, -n.z};
  // In half pixels · 2^15, so that the focal length (Q16.16) has no fraction.
  const std::int64_t to_middle = n.x * (1 - view.viewport.width) - n.y * (1 - view.viewport.height);
  return HalfPlane::fitted(n.x << 16, -(n.y << 16), (to_middle << 15) + n.z * view.camera.focal.raw());
}

}  // namespace

FanLineMaker FanLineMaker::for_view(const FrameView& view) { return {&view, &make_line}; }

}  // namespace spanline
