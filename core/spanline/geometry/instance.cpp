#include "spanline/geometry/instance.hpp"

namespace spanline {

void InstanceGeometry::transform_vertices(ScreenVertex* out) const {
  if (VertexTransform::takes(view_, transform_, mesh_, placement_)) {
    VertexTransform(view_, transform_).run(mesh_.vertices, out, placement_ != Placement::inside);
  } else {
    transform_wide(transform_, projection_, mesh_, out);
  }
}

}  // namespace spanline
