#pragma once
#include <cstdint>

#include "spanline/raster/screen_vertex.hpp"

namespace spanline {

/// The corners of a convex polygon on screen, in order, either way round.
struct Outline {
  static constexpr unsigned most_corners = 8;

  const ScreenVertex* corner[most_corners];
  unsigned count;  ///< of corners, [3, most_corners]
};

/// How an outline turns on screen, y down.
enum class Turn : std::int8_t {
  counter_clockwise = -1,
  none = 0,  ///< snapping has made the outline concave, or it has no area
  clockwise = 1
};

/// The way round of an outline and its reference triangle, whose plane is the polygon's: the largest triangle of the
/// fan from corner 0; of equally large ones, the first.
struct OutlineShape {
  Turn turn;
  unsigned reference;  ///< the reference triangle has corners 0, `reference` and `reference` + 1
  std::int64_t area;   ///< twice its signed area, square sixteenths of a pixel, positive if clockwise
};

/// The shape of an outline inside the guard band. It is convex if all its turns, and all triangles of its fan, have the
/// same orientation or none. Then the fan's triangles do not overlap, so that the pixels inside the outline are those
/// of the fan.
[[nodiscard]] OutlineShape shape_of(const Outline& outline);

}  // namespace spanline
