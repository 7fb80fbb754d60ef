#include "spanline/raster/outline.hpp"

namespace spanline {
namespace {

std::int64_t doubled_area(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c) {
  const std::int64_t dx1 = b.x - a.x, dy1 = b.y - a.y, dx2 = c.x - a.x, dy2 = c.y - a.y;
  return dx1 * dy2 - dx2 * dy1;
}

}  // namespace

OutlineShape shape_of(const Outline& outline) {
  const auto area = [&](unsigned a, unsigned b, unsigned c) {
    return doubled_area(*outline.corner[a], *outline.corner[b], *outline.corner[c]);
  };
  const unsigned last = outline.count - 1;
  bool clockwise = false, counter_clockwise = false;
  const auto note = [&](std::int64_t doubled) {
    clockwise |= doubled > 0;
    counter_clockwise |= doubled < 0;
  };
  OutlineShape shape{Turn::none, 1, 0};
  std::int64_t largest = -1;
  for (unsigned i = 1; i < last; ++i) {
    const std::int64_t doubled = area(0, i, i + 1), size = doubled < 0 ? -doubled : doubled;
    note(doubled);
    if (size > largest) {
      largest = size;
      shape.reference = i;
      shape.area = doubled;
    }
  }
  // The turns at corners 1 and `last` are those of the fan's first and last triangles.
  for (unsigned i = 1; i + 2 <= last; ++i) note(area(i, i + 1, i + 2));
  note(area(last, 0, 1));
  if (clockwise != counter_clockwise) shape.turn = clockwise ? Turn::clockwise : Turn::counter_clockwise;
  return shape;
}

}  // namespace spanline
