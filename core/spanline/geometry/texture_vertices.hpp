#pragma once
#include <cstdint>
#include <span>

#include "spanline/geometry/view_space.hpp"
#include "spanline/model/mesh.hpp"
#include "spanline/model/texture.hpp"
#include "spanline/model/volume.hpp"
#include "spanline/raster/texture_vertex.hpp"

namespace spanline {

/// Computes nearness, a scaled 1/z, from distance for one instance. The nearest distance that the bounding sphere or
/// the near plane allows has nearness 2^31.
class Nearness {
 public:
  Nearness() = default;
  Nearness(const FrameView& view, const ViewTransform& transform);

  /// The nearness of a point at the distance z > 0 along the axis of view, in view units. Its error is below 2^-26 of
  /// it or half a unit, whichever is greater.
  [[nodiscard]] std::uint32_t operator()(std::int64_t z) const;

 private:
  bool perspective_ = false;
  std::uint32_t nearest_ = 0;  ///< the nearest distance, normalised to [2^31, 2^32)
  int nearest_zeros_ = 0;      ///< number of bits by which it was shifted to the left
};

/// Makes the texture vertices of a mesh with texture coordinates.
void make_texture_vertices(const ViewTransform& transform, const Nearness& nearness, const Mesh& mesh,
                           const TextureMatrix& matrix, TextureVertex* out);

/// Makes the texture vertices of a sphere map, for meshes with vertex normals that reflect their surroundings. Let r be
/// the line of sight mirrored at the normal, in the axes of view, and h the unit vector along r + (0, 0, 1). Then s = ½
/// + ½·h.x and t = ½ − ½·h.y (GL_SPHERE_MAP of the OpenGL specification), within 2^-13 (tested).
void make_sphere_map_vertices(const ViewTransform& transform, const Rotation& normals_to_view, Projection projection,
                              const Nearness& nearness, const Mesh& mesh, const TextureMatrix& matrix,
                              TextureVertex* out);

/// Makes the texture vertices of a solid texture (model/volume.hpp): s, t and the third coordinate r are the vertex's
/// position in model space. r is written to `third`.
void make_volume_vertices(const ViewTransform& transform, const Nearness& nearness, const Mesh& mesh,
                          const Volume& volume, TextureVertex* out, std::int32_t* third);

/// Makes the texture vertex of a point that clipping has made. It is called by a pointer, so that programs without
/// textures do not link this code.
struct TextureVertexMaker {
  const Nearness* nearness = nullptr;
  TextureVertex (*make)(const Nearness& nearness, std::int64_t z, std::int32_t s, std::int32_t t) = nullptr;

  [[nodiscard]] static TextureVertexMaker for_instance(const Nearness& nearness);
};

}  // namespace spanline
