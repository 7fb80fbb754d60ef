#pragma once
#include "spanline/geometry/view_space.hpp"
#include "spanline/model/mesh.hpp"
#include "spanline/raster/fan_diagonals.hpp"

namespace spanline {

/// Makes the lines on which the diagonals of a polygon's fan lie on the screen, for polygons that clipping changes. It
/// is called by a pointer, so that programs that do not tell triangles apart, for ids or statistics, do not link it.
struct FanLineMaker {
  const FrameView* view = nullptr;
  /// The corners are those of the mesh; `clockwise` says how the polygon turns on the screen.
  FanDiagonals (*make)(const FrameView& view, const ViewTransform& transform, const Mesh& mesh, const Outline& corners,
                       bool clockwise) = nullptr;

  [[nodiscard]] static FanLineMaker for_view(const FrameView& view);
};

}  // namespace spanline
