#pragma once
#include <cstdint>

#include "spanline/model/camera.hpp"
#include "spanline/model/mesh.hpp"
#include "spanline/model/transform.hpp"
#include "spanline/raster/gradients.hpp"
#include "spanline/raster/screen_vertex.hpp"

namespace spanline {

/// A point in view space: x to the right, y up, z the distance along the axis of view. All in units of 2^-exponent
/// world units, where the exponent belongs to the instance; |component| < 2^44.
struct ViewPoint {
  std::int64_t x, y, z;
};

/// One camera over one viewport at one depth format: what a frame's instances have in common.
struct FrameView {
  Camera camera;
  Viewport viewport;
  int depth_bits = 16;
  std::uint32_t nearest_depth = 0;  ///< the format's least and greatest vertex depths
  std::uint32_t farthest_depth = 65534;
};

/// Model space to view space for one instance, in block-floating fixed point: exponents are chosen once an instance
/// from its size and distance, so that no scale of model or world costs precision.
class ViewTransform {
 public:
  ViewTransform() = default;
  ViewTransform(const FrameView& view, const Mesh& mesh, const Transform& transform);

  /// A vertex of the mesh, |coordinate| ≤ 2^30. Error below 2^-26 of the reach of the view: the far plane, or what
  /// lies beyond it.
  [[nodiscard]] ViewPoint operator()(std::int32_t x, std::int32_t y, std::int32_t z) const {
    return {component(0, x, y, z), component(1, x, y, z), component(2, x, y, z)};
  }

  [[nodiscard]] std::int64_t near_plane() const { return near_; }
  [[nodiscard]] std::int64_t far_plane() const { return far_; }
  /// World units to view units, rounded.
  [[nodiscard]] std::int64_t from_world(Q16_16 length) const;

  /// The centre and radius of the mesh's bounding sphere in view units; the radius is rounded up.
  [[nodiscard]] ViewPoint sphere_centre() const { return centre_; }
  [[nodiscard]] std::int64_t sphere_radius() const { return radius_; }

  /// Row i of the matrix (x, y, z as ViewPoint has them) and its translation, in units of 2^-guard() view units.
  [[nodiscard]] std::int64_t entry(int row, int column) const { return matrix_[row][column]; }
  [[nodiscard]] std::int64_t translation(int row) const { return translation_[row]; }
  [[nodiscard]] int guard() const { return guard_; }
  /// View units a world unit are 2^exponent().
  [[nodiscard]] int exponent() const { return exponent_; }

 private:
  [[nodiscard]] std::int64_t component(int row, std::int32_t x, std::int32_t y, std::int32_t z) const {
    const std::int64_t sum = static_cast<std::int64_t>(matrix_[row][0]) * x +
                             static_cast<std::int64_t>(matrix_[row][1]) * y +
                             static_cast<std::int64_t>(matrix_[row][2]) * z + translation_[row];
    return guard_ >= 0 ? sum >> guard_ : sum * (std::int64_t{1} << -guard_);
  }

  std::int32_t matrix_[3][3] = {};    ///< view units a step · 2^guard, |entry| < 2^30
  std::int64_t translation_[3] = {};  ///< view units · 2^guard
  int guard_ = 0;                     ///< extra fraction bits of the sums, ≤ 18
  int exponent_ = 0;                  ///< view units a world unit are 2^exponent
  std::int64_t near_ = 0, far_ = 0;
  ViewPoint centre_{};
  std::int64_t radius_ = 0;
};

/// How an instance lies to the view.
enum class Placement : std::uint8_t {
  outside,    ///< nothing of it can be seen
  inside,     ///< all of it lies inside the viewport and the depth range: nothing to clip or to cut
  unclipped,  ///< inside the depth range and the guard band, but it may leave the viewport
  clipped,    ///< it may need clipping
};

/// Bounding sphere against the frustum: conservative, exact to the rounding of the sphere.
[[nodiscard]] Placement place(const FrameView& view, const ViewTransform& transform);

}  // namespace spanline
