#pragma once
#include <cstdint>
#include <span>

#include "spanline/cpu/vertex_constants.hpp"
#include "spanline/geometry/projection.hpp"
#include "spanline/geometry/view_space.hpp"
#include "spanline/model/mesh.hpp"
#include "spanline/raster/screen_vertex.hpp"

namespace spanline {

/// Transforms vertices from model space directly to the screen, for 16-bit meshes in perspective that lie within the
/// depth range and the guard band. It takes 32-bit products and one table reciprocal a vertex, and no division. The
/// error on screen is below 1/32 pixel, besides the rounding to sixteenths; depth is within 2.5 units at 24 bits
/// (tested).
class VertexTransform {
 public:
  /// Whether this class can transform the instance. Conditions are that its farthest distance is at most 4 times its
  /// nearest, and far/(far − near) is below 4, with limits of position and scale that keep the errors small.
  [[nodiscard]] static bool takes(const FrameView& view, const ViewTransform& transform, const Mesh& mesh,
                                  Placement placement);

  VertexTransform(const FrameView& view, const ViewTransform& transform);

  /// Transforms all vertices. `with_outcodes` says that the instance may leave the viewport.
  void run(std::span<const Vertex16> vertices, ScreenVertex* out, bool with_outcodes) const;

 private:
  VertexConstants constants_;
};

/// Transforms all vertices of any mesh with any placement, by way of view space.
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
