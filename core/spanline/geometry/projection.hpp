#pragma once
#include <cstdint>

#include "spanline/geometry/view_space.hpp"
#include "spanline/raster/screen_vertex.hpp"

namespace spanline {

/// Projects points of one instance from view space to the screen, wherever they lie, with 64-bit arithmetic and two
/// divisions a vertex for the position. It is used for wide meshes, orthographic views, instances that cross the near
/// or far plane, and clipped vertices. `VertexTransform` is faster and is used for the rest.
class PointProjection {
 public:
  PointProjection() = default;
  PointProjection(const FrameView& view, const ViewTransform& transform);

  /// The point on screen with its depth and outcode. The position is meaningless if any bit of outcode_clip is set.
  [[nodiscard]] ScreenVertex operator()(const ViewPoint& point) const;

  /// The same for a point that was clipped to the depth range and the guard band. A position that rounding moved
  /// outside is clamped, and only the outcodes of the viewport are set.
  [[nodiscard]] ScreenVertex clipped(const ViewPoint& point) const;

  /// The integer depth of a distance z in [near, far], rounded to nearest.
  [[nodiscard]] std::uint32_t depth_at(std::int64_t z) const;

 private:
  struct Sixteenths {
    std::int64_t x, y;  ///< screen position, not biased, sixteenths of a pixel
  };
  [[nodiscard]] Sixteenths to_screen(const ViewPoint& point) const;
  [[nodiscard]] std::uint8_t viewport_codes(std::int64_t x, std::int64_t y) const;

  Projection projection_ = Projection::perspective;
  std::int64_t near_ = 0, far_ = 1;  ///< distances of the planes, view units
  std::int32_t focal_raw_ = 0;       ///< Q16.16
  int exponent_shift_ = 0;           ///< orthographic: right shift, view units · focal_raw_ → sixteenths of a pixel
  std::int32_t width_ = 0, height_ = 0;       ///< size of the viewport, sixteenths of a pixel
  std::uint32_t ratio_ = 0;                   ///< mantissa of far / (far − near), in [2^31, 2^32)
  int ratio_shift_ = 0;                       ///< the ratio is ratio_ / 2^ratio_shift_
  int depth_bits_ = 16;                       ///< 16 or 24
  std::uint32_t nearest_ = 0, farthest_ = 0;  ///< least and greatest vertex depth of the format
};

}  // namespace spanline
