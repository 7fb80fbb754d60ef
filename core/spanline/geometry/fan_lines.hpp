#pragma once
#include "spanline/geometry/view_space.hpp"
#include "spanline/model/mesh.hpp"
#include "spanline/raster/half_plane.hpp"
#include "spanline/raster/outline.hpp"

namespace spanline {

/// Makes the lines on which the diagonals of a polygon's fan lie on the screen, for polygons that clipping changes. It
/// is called by a pointer, so that programs that do not tell triangles apart, for ids or statistics, do not link it.
struct FanLineMaker {
  const FrameView* view = nullptr;
  /// The line of the diagonal from corner 0 to corner `i` of the mesh's polygon. `clockwise` says how it turns on the
  /// screen.
  HalfPlane (*make)(const FrameView& view, const ViewTransform& transform, const Mesh& mesh, const Outline& corners,
                    unsigned i, bool clockwise) = nullptr;

  [[nodiscard]] static FanLineMaker for_view(const FrameView& view);
};

}  // namespace spanline
