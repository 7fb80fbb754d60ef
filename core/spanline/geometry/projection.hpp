#pragma once
#include <cstdint>

#include "spanline/geometry/view_space.hpp"
#include "spanline/raster/screen_vertex.hpp"

namespace spanline {

/// View space to screen for one instance, for points anywhere: 64-bit arithmetic, two divisions a vertex. It serves
/// wide meshes, orthographic views, instances that reach through the near or far plane, and clipped vertices.
/// `VertexTransform` is the fast way for the rest.
class PointProjection {
 public:
  PointProjection() = default;
  PointProjection(const FrameView& view, const ViewTransform& transform);

  /// The point on screen with its depth and outcode. Where outcode_clip bits are set the position means nothing.
  [[nodiscard]] ScreenVertex operator()(const ViewPoint& point) const;

  /// The same for a point that has been clipped to the depth range and to the guard band: rounding past their edge is
  /// undone, and only the viewport's outcodes remain.
  [[nodiscard]] ScreenVertex clipped(const ViewPoint& point) const;

  /// Depth of a distance z in [near, far].
  [[nodiscard]] std::uint32_t depth_at(std::int64_t z) const;

 private:
  struct Sixteenths {
    std::int64_t x, y;
  };
  [[nodiscard]] Sixteenths to_screen(const ViewPoint& point) const;
  [[nodiscard]] std::uint8_t viewport_codes(std::int64_t x, std::int64_t y) const;

  Projection projection_ = Projection::perspective;
  std::int64_t near_ = 0, far_ = 1;
  std::int32_t focal_raw_ = 0;           ///< Q16.16
  int exponent_shift_ = 0;               ///< orthographic: view units · focal → sixteenths
  std::int32_t width_ = 0, height_ = 0;  ///< sixteenths
  std::uint32_t ratio_ = 0;              ///< far / (far − near), normalised to [2^31, 2^32)
  int ratio_shift_ = 0;                  ///< ratio_ / 2^ratio_shift is the ratio
  int depth_bits_ = 16;
  std::uint32_t nearest_ = 0, farthest_ = 0;
};

}  // namespace spanline
