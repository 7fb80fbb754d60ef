#pragma once
#include <cstdint>

#include "spanline/model/cull.hpp"
#include "spanline/raster/medium_triangle.hpp"
#include "spanline/raster/outline.hpp"
#include "spanline/raster/small_triangle.hpp"
#include "spanline/raster/vertex_shade.hpp"

namespace spanline {

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

/// What becomes of an outline.
enum class OutlineFate : std::uint8_t {
  whole,   ///< it is one entry of the polygon table
  culled,  ///< it turns the wrong way
  fan      ///< it is concave after snapping, or its plane could leave the range of depths
};

/// Decides what becomes of an outline inside the guard band, and lays out one that is to be whole. Depths have
/// `depth_bits` bits.
///
/// The plane of the reference triangle lies near the depths of the other corners: layout.slack says how near. It must
/// not leave the range of depths at any of them. Polygons lie between their corners, so it leaves the range nowhere.
[[nodiscard]] OutlineFate lay_out(const Outline& outline, Cull cull, int depth_bits, OutlineLayout& layout);

/// Whether the shades of an outline's corners are linear over it: where the plane through those of the reference
/// triangle meets the others within a 256th of the range, and inside it. `reference` is as in OutlineShape.
[[nodiscard]] bool shades_are_linear(const Outline& outline, unsigned reference, const std::uint32_t* shades,
                                     vertex_shade::Kind kind);

/// The parts that `lay_out` and `lay_out_quad` share.
namespace outline_layout {

/// Whether a plane that differs by up to 2^slack units from depths in [low, high] could leave the range of depths. The
/// words of a plane differ from exact ones where it is extrapolated, too: by half a guard unit for each pixel from the
/// anchor, and by the error of the slopes.
[[nodiscard]] inline bool reaches_out(std::int32_t low, std::int32_t high, unsigned slack, int depth_bits) {
  constexpr std::int32_t rounding = 10;
  const std::int32_t reach = (1 << slack) + rounding;
  return low < reach || high + reach > (1 << depth_bits) - 2;
}

/// The box of an outline, biased, in sixteenths of a pixel.
struct Box {
  std::int32_t left, right, top, bottom;
  unsigned top_corner;  ///< the first of the topmost corners

  [[gnu::always_inline]] inline void begin(std::int32_t x, std::int32_t y) {
    left = right = x;
    top = bottom = y;
    top_corner = 0;
  }
  [[gnu::always_inline]] inline void add(unsigned corner, std::int32_t x, std::int32_t y) {
    left = x < left ? x : left;
    right = x > right ? x : right;
    bottom = y > bottom ? y : bottom;
    top_corner = y < top ? corner : top_corner;
    top = y < top ? y : top;
  }
  /// Whether an outline inside the viewport is of the small class. `area` is that of its reference triangle: slopes of
  /// planes over thinner ones are rounded too coarsely by the set-up of small triangles.
  [[nodiscard, gnu::always_inline]] inline bool is_small(std::int32_t top_x, std::int32_t area) const {
    constexpr std::int32_t least_area = 64;
    return bottom - top <= small_triangle::max_height && top_x - left <= small_triangle::reach &&
           right - top_x <= small_triangle::reach && (area < 0 ? -area : area) >= least_area;
  }
};

/// The class of an outline inside the viewport that is not small. Its box has this size, in sixteenths of a pixel.
[[nodiscard]] ActiveTriangle::Size wide_class_of(const Outline& outline, std::int32_t width, std::int32_t height);

/// Completes a layout.
[[gnu::always_inline]] inline void place(const Box& box, ActiveTriangle::Size size, std::int32_t top_x,
                                         OutlineLayout& layout) {
  layout.size = size;
  layout.top = box.top_corner;
  layout.first_row = row_at(box.top);
  layout.end_row = row_at(box.bottom);
  layout.origin = 0;
  if (size == ActiveTriangle::Size::small) layout.origin = small_triangle::origin_of(top_x) + row_bias;
  if (size == ActiveTriangle::Size::medium) layout.origin = medium_triangle::origin_of(box.left);
}

}  // namespace outline_layout
}  // namespace spanline
