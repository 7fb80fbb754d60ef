#pragma once
#include "spanline/geometry/clipper.hpp"
#include "spanline/geometry/polygon_assembly.hpp"
#include "spanline/geometry/projection.hpp"
#include "spanline/geometry/vertex_store.hpp"
#include "spanline/geometry/vertex_transform.hpp"
#include "spanline/geometry/view_space.hpp"

namespace spanline {

/// The geometry stage of one instance: its placement in the view and the transformation of its vertices to the screen.
class InstanceGeometry {
 public:
  InstanceGeometry(const FrameView& view, const Mesh& mesh, const Transform& transform)
      : view_(view), mesh_(mesh), transform_(view, mesh, transform), placement_(place(view, transform_)) {}

  [[nodiscard]] Placement placement() const { return placement_; }

  /// Transforms every vertex of the mesh to the screen.
  void transform_vertices(ScreenVertex* out) const;

  /// The clipper and the context of clipping for this instance. The context refers to this object, to `clipper` and to
  /// `store`, which must outlive it.
  [[nodiscard]] Clipper clipper(vertex_shade::Kind shades) const { return {view_, transform_, shades}; }
  [[nodiscard]] PolygonAssembly::ClipContext clip_context(const Clipper& clipper, VertexStore& store) const {
    return {&clipper, &transform_, &projection_, {}, &store};
  }

  /// The texture vertices of this instance (see texture_vertices.hpp).
  [[nodiscard]] Nearness nearness() const { return {view_, transform_}; }
  void make_texture_vertices(const Nearness& nearness, const TextureMatrix& matrix, TextureVertex* out) const {
    spanline::make_texture_vertices(transform_, nearness, mesh_, matrix, out);
  }
  void make_sphere_map_vertices(const Nearness& nearness, const TextureMatrix& matrix, const Rotation& rotation,
                                TextureVertex* out) const {
    spanline::make_sphere_map_vertices(transform_, view_.camera.axes * rotation, view_.camera.projection, nearness,
                                       mesh_, matrix, out);
  }
  void make_volume_vertices(const Nearness& nearness, const Volume& volume, TextureVertex* out,
                            std::int32_t* third) const {
    spanline::make_volume_vertices(transform_, nearness, mesh_, volume, out, third);
  }

 private:
  const FrameView& view_;
  const Mesh& mesh_;
  ViewTransform transform_;
  Placement placement_;
  PointProjection projection_{view_, transform_};
};

}  // namespace spanline
