#pragma once
#include <optional>
#include <string>

#include "scene/scene.hpp"

struct aiMaterial;
struct aiScene;

namespace spanline::sim {

/// The texture of a file's material.
struct MaterialTexture {
  unsigned points = 0;  ///< which set of a vertex's texture coordinates
  Wrap wrap_s = Wrap::repeat, wrap_t = Wrap::repeat;
  std::optional<SceneImage> image;
};

/// Of a material of a file that lies at `path`: its base or diffuse colours, and its opacities (`map_d` of MTL).
[[nodiscard]] MaterialTexture texture_of(const aiScene& file, const aiMaterial& material, const std::string& path);

}  // namespace spanline::sim
