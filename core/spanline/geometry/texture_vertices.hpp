#pragma once
#include <cstdint>
#include <span>

#include "spanline/geometry/view_space.hpp"
#include "spanline/model/mesh.hpp"
#include "spanline/model/texture.hpp"
#include "spanline/model/volume.hpp"
#include "spanline/raster/texture_vertex.hpp"

namespace spanline {

/// Distance to nearness for one instance: 2^31 for the nearest that its bounding sphere or the near plane allows.
class Nearness {
 public:
  Nearness() = default;
  Nearness(const FrameView& view, const ViewTransform& transform);

  /// Of a point at the distance z > 0 along the axis of view; relative error below 2^-26, or half a unit.
  [[nodiscard]] std::uint32_t operator()(std::int64_t z) const;

 private:
  bool perspective_ = false;
  std::uint32_t nearest_ = 0;  ///< the nearest distance, normalised to [2^31, 2^32)
  int nearest_zeros_ = 0;      ///< by so many bits
};

/// What texturing needs of every vertex of a mesh with texture coordinates.
void make_texture_vertices(const ViewTransform& transform, const Nearness& nearness, const Mesh& mesh,
                           const TextureMatrix& matrix, TextureVertex* out);

/// The same for meshes with vertex normals, which show their surroundings: with r the line of sight mirrored at the
/// normal, in the axes of view, s and t are ½ + ½·h of the unit vector h along r + (0, 0, 1), t downwards (OpenGL's
/// GL_SPHERE_MAP). Within 2^-13 of that (tested).
void make_sphere_map_vertices(const ViewTransform& transform, const Rotation& normals_to_view, Projection projection,
                              const Nearness& nearness, const Mesh& mesh, const TextureMatrix& matrix,
                              TextureVertex* out);

/// The same for solids: s and t of a vertex's point in the mesh's own space, and r apart (model/volume.hpp).
void make_volume_vertices(const ViewTransform& transform, const Nearness& nearness, const Mesh& mesh,
                          const Volume& volume, TextureVertex* out, std::int32_t* third);

/// How clipping makes the texture vertex of a new point. By a pointer, so that programs that draw no textures link none
/// of this.
struct TextureVertexMaker {
  const Nearness* nearness = nullptr;
  TextureVertex (*make)(const Nearness& nearness, std::int64_t z, std::int32_t s, std::int32_t t) = nullptr;

  [[nodiscard]] static TextureVertexMaker for_instance(const Nearness& nearness);
};

}  // namespace spanline
