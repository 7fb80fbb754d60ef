#pragma once
#include "spanline/raster/screen_vertex.hpp"

namespace spanline {

/// Twice the signed area on screen, square sixteenths of a pixel, y down; negative if the corners run counter-clockwise
/// for the viewer. 32 bits suffice for corners inside a viewport, 64 for the guard band.
template <class Wide>
[[nodiscard]] inline Wide signed_area(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c) {
  const Wide dx1 = b.x - a.x, dy1 = b.y - a.y, dx2 = c.x - a.x, dy2 = c.y - a.y;
  return dx1 * dy2 - dx2 * dy1;
}

}  // namespace spanline
