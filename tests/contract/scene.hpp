#pragma once
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "spanline/frame/renderer.hpp"
#include "spanline/model/cull.hpp"
#include "support/owned_mesh.hpp"
#include "support/random_texture.hpp"
#include "support/screen_triangle.hpp"

namespace spanline::contract {

using test::Corner;
using test::Corners;
using test::OwnedMesh;

/// An instance of a mesh.
struct Part {
  const Mesh* mesh;
  Transform transform;
  Material material;
};

/// What a surface may be made of besides a texture.
struct SurfaceTables {
  std::vector<std::uint8_t> bytes;
  std::vector<std::uint16_t> words;
  HeightMap heights;
  VolumeTexture solid;
};

/// What every algorithm is to draw: triangles given on screen, then instances. Moved, never copied: parts point into
/// it.
struct Scene {
  int width = 96, height = 64;
  std::vector<Corners> triangles;  ///< 24-bit depths, smaller is nearer
  std::deque<OwnedMesh> owned;
  std::deque<Mesh> meshes;  ///< views of `owned`
  std::vector<Part> parts;
  std::deque<test::OwnTexture> textures;  ///< of the parts' materials
  std::deque<SurfaceTables> tables;       ///< likewise
  std::vector<PointLight> point_lights;   ///< of the settings
  FrameSettings settings;

  Scene() { settings.cull = Cull::none; }
  Scene(int w, int h) : Scene() {
    width = w;
    height = h;
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;
  Scene(Scene&&) = default;
  Scene& operator=(Scene&&) = default;
  ~Scene() = default;

  [[nodiscard]] std::size_t pixel_count() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  /// Polygons of the table at most: clipping cuts a triangle into seven.
  [[nodiscard]] std::size_t polygon_count() const;
};

/// The triangles of a scene as source text, for the report of a failure; nothing for long ones.
[[nodiscard]] std::string text_of(const Scene& scene);

}  // namespace spanline::contract
