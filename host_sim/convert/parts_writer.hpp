#pragma once
#include <string>
#include <vector>

#include "convert/frame_need.hpp"
#include "scene/core_mesh.hpp"
#include "scene/scene_textures.hpp"

namespace spanline::sim {

/// A model cut into its parts, each a mesh with a material, and their textures.
struct FlashParts {
  std::vector<CoreMesh> meshes;  ///< one a part that has triangles; `part` is its number in the scene
  std::vector<Scene::Part> parts;
  SceneTextures textures;
  bool smooth = false;
};

/// Cuts a scene; textures as load_textures makes them. Throws Failure.
[[nodiscard]] FlashParts cut_into_parts(const Scene& scene, const TextureOptions& options, bool format_wanted);

/// A freestanding C++ header: `spanline_models::NAME`, an array of spanline::ModelPart, with all that it refers to.
[[nodiscard]] std::string write_parts_header(const FlashParts& parts, const std::string& name,
                                             const std::string& source);

/// Flash by mesh and texture, and the RAM of a frame, line by line, with their sums.
[[nodiscard]] std::string parts_report(const FlashParts& parts, const FrameNeed& need);

}  // namespace spanline::sim
