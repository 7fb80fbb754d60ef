#pragma once
#include <cstdint>
#include <span>

#include "spanline/cpu/vertex_constants.hpp"
#include "spanline/geometry/projection.hpp"
#include "spanline/geometry/view_space.hpp"
#include "spanline/model/mesh.hpp"
#include "spanline/raster/screen_vertex.hpp"

namespace spanline {

/// Model space straight to screen in 32-bit products, for 16-bit meshes that lie within the depth range and the guard
/// band, seen in perspective: one table reciprocal a vertex, no divide. Error on screen
/// below 1/32 pixel beside the rounding to sixteenths; depth within 2.5 units at 24 bits (tested).
class VertexTransform {
 public:
  /// Whether the instance can be taken: at its farthest at most 4 times as far away as at its nearest, and a far/(far −
  /// near) below 4.
  [[nodiscard]] static bool takes(const FrameView& view, const ViewTransform& transform, const Mesh& mesh,
                                  Placement placement);

  VertexTransform(const FrameView& view, const ViewTransform& transform);

  /// Transforms all vertices; `with_outcodes` where the instance may leave the viewport.
  void run(std::span<const Vertex16> vertices, ScreenVertex* out, bool with_outcodes) const;

 private:
  VertexConstants constants_;
};

/// All vertices by way of view space: any mesh, any placement.
void transform_wide(const ViewTransform& transform, const PointProjection& projection, const Mesh& mesh,
                    ScreenVertex* out);

/// Vertex `index` of the mesh in view space.
[[nodiscard]] inline ViewPoint view_point(const ViewTransform& transform, const Mesh& mesh, std::size_t index) {
  if (mesh.vertices.empty()) {
    const Vertex32& v = mesh.wide_vertices[index];
    return transform(v.x, v.y, v.z);
  }
  const Vertex16& v = mesh.vertices[index];
  return transform(v.x, v.y, v.z);
}

}  // namespace spanline
