#pragma once
#include <vector>

#include "scene/scene.hpp"
#include "scene/world.hpp"
#include "spanline/model/mesh.hpp"

namespace spanline::sim {

/// A mesh of the core that owns its tables.
struct CoreMesh {
  std::vector<Vertex16> vertices;
  std::vector<Vertex32> wide_vertices;
  std::vector<std::uint16_t> indices;
  std::vector<std::uint8_t> corners;  ///< empty: all are triangles
  std::vector<PackedNormal> polygon_normals, vertex_normals;
  std::vector<Rgb888> polygon_colours, vertex_colours;
  std::vector<std::uint8_t> vertex_opacities;
  std::vector<TextureCoordinate> texture_coordinates;
  int texture_exponent = -14;
  Rgb888 colour{};  ///< for the material, where there are no tables of colours
  std::uint8_t opacity = 255;
  Highlights highlights;
  std::size_t part = 0;  ///< of the scene
  Vec3<std::int32_t> offset{};
  int step_exponent = 0;
  BoundingSphere bounds{};

  [[nodiscard]] Mesh view() const;
};

/// The scene in the wide vertex form, steps of 2^−16 of a world unit, cut into meshes within Mesh's limits. Triangles
/// stay in file order, and fans that can be are polygons (scene/fan_joining.hpp). Tables that the scene does not have
/// stay empty. Where anything is seen through or textured, or highlights differ, every part of the scene has meshes of
/// its own.
///
/// All meshes state the bounds of the whole scene: the core chooses its exponents by them, and vertices that two meshes
/// share must go to the same place on the screen.
[[nodiscard]] std::vector<CoreMesh> to_core_meshes(const Scene& scene, const World& world);

/// A sphere around all points: the centre of their box, and the farthest of them, rounded up. |component| ≤ 2^30.
[[nodiscard]] BoundingSphere bounding_sphere(const std::vector<Vec3<std::int64_t>>& points);

/// The finest unit of texture coordinates that 16 bits allow, from 2^-14 textures on. Throws Failure.
[[nodiscard]] int texture_exponent_for(const std::vector<TexturePoint>& points);
[[nodiscard]] TextureCoordinate to_coordinate(TexturePoint point, int texture_exponent);

}  // namespace spanline::sim
