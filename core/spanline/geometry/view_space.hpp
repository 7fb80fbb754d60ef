#pragma once
#include <cstdint>

#include "spanline/model/camera.hpp"
#include "spanline/model/mesh.hpp"
#include "spanline/model/transform.hpp"
#include "spanline/raster/gradients.hpp"
#include "spanline/raster/screen_vertex.hpp"

namespace spanline {

/// A point in view space: x to the right, y up, z the distance along the axis of view. Components are in view units,
/// |component| < 2^44. A view unit is 2^-exponent world units, with an exponent that is chosen for each instance.
struct ViewPoint {
  std::int64_t x, y, z;
};

/// The data that all instances of a frame share: camera, viewport and depth format.
struct FrameView {
  Camera camera;
  Viewport viewport;
  int depth_bits = 16;                   ///< 16 or 24
  std::uint32_t nearest_depth = 0;       ///< least vertex depth of the format
  std::uint32_t farthest_depth = 65534;  ///< greatest vertex depth of the format
};

/// The transformation from model space to view space for one instance, in block floating point: one exponent for the
/// whole instance is chosen from its size and distance, so that precision does not depend on the scale of model or
/// world.
class ViewTransform {
 public:
  ViewTransform() = default;
  ViewTransform(const FrameView& view, const Mesh& mesh, const Transform& transform);

  /// Transforms a vertex of the mesh, |coordinate| ≤ 2^30. The error is below 2^-26 of the reach of the view, which is
  /// the distance of the farther plane, or the greatest distance of the instance if that is larger.
  [[nodiscard]] ViewPoint operator()(std::int32_t x, std::int32_t y, std::int32_t z) const {
    return {component(0, x, y, z), component(1, x, y, z), component(2, x, y, z)};
  }

  [[nodiscard]] std::int64_t near_plane() const { return near_; }
  [[nodiscard]] std::int64_t far_plane() const { return far_; }
  /// A length in view units, rounded to nearest.
  [[nodiscard]] std::int64_t from_world(Q16_16 length) const;

  /// The centre and radius of the mesh's bounding sphere, in view units. The radius is rounded up.
  [[nodiscard]] ViewPoint sphere_centre() const { return centre_; }
  [[nodiscard]] std::int64_t sphere_radius() const { return radius_; }

  /// An entry of the matrix, and the translation of a row, in units of 2^-guard() view units. The rows are x, y and z
  /// of ViewPoint.
  [[nodiscard]] std::int64_t entry(int row, int column) const { return matrix_[row][column]; }
  [[nodiscard]] std::int64_t translation(int row) const { return translation_[row]; }
  [[nodiscard]] int guard() const { return guard_; }
  /// A world unit has 2^exponent() view units.
  [[nodiscard]] int exponent() const { return exponent_; }

 private:
  [[nodiscard]] std::int64_t component(int row, std::int32_t x, std::int32_t y, std::int32_t z) const {
    const std::int64_t sum = static_cast<std::int64_t>(matrix_[row][0]) * x +
                             static_cast<std::int64_t>(matrix_[row][1]) * y +
                             static_cast<std::int64_t>(matrix_[row][2]) * z + translation_[row];
    return guard_ >= 0 ? sum >> guard_ : sum * (std::int64_t{1} << -guard_);
  }

  std::int32_t matrix_[3][3] = {};    ///< view units a step of the mesh · 2^guard, |entry| < 2^30
  std::int64_t translation_[3] = {};  ///< view units · 2^guard
  int guard_ = 0;                     ///< extra fraction bits of the sums, at most 18; may be negative
  int exponent_ = 0;                  ///< a world unit has 2^exponent view units
  std::int64_t near_ = 0, far_ = 0;   ///< distances of the planes, view units
  ViewPoint centre_{};                ///< centre of the bounding sphere, view units
  std::int64_t radius_ = 0;           ///< radius of the bounding sphere, view units, rounded up
};

/// The position of an instance relative to the view.
enum class Placement : std::uint8_t {
  outside,    ///< no part of it is visible
  inside,     ///< all of it lies inside the viewport and the depth range, so nothing is clipped or cut
  unclipped,  ///< it lies inside the depth range and the guard band, but may leave the viewport
  clipped,    ///< it may need clipping
};

/// Places an instance by testing its bounding sphere against the frustum. The result is conservative.
[[nodiscard]] Placement place(const FrameView& view, const ViewTransform& transform);

}  // namespace spanline
