#pragma once
#include <optional>
#include <string>

#include "scene/scene.hpp"

struct aiMaterial;
struct aiScene;

namespace spanline::sim {

/// KHR_texture_transform of glTF: scale, then rotation, then offset, where t counts downwards:
///
///     s' = offset_s + scale_s · s · cos + scale_t · t · sin
///     t' = offset_t − scale_s · s · sin + scale_t · t · cos
///
/// The signs are those of the extension's own example and of its implementations; its listing in GLSL turns the other
/// way (KhronosGroup/glTF, issue 1563).
struct TextureTransform {
  double offset_s = 0, offset_t = 0, scale_s = 1, scale_t = 1;
  double rotation = 0;  ///< radians
  [[nodiscard]] TexturePoint operator()(TexturePoint point) const;
};

/// The texture of a file's material.
struct MaterialTexture {
  unsigned points = 0;         ///< which set of a vertex's texture coordinates
  TextureTransform transform;  ///< of these
  PartWrap wrap_s = PartWrap::repeat, wrap_t = PartWrap::repeat;
  std::optional<SceneImage> image;
};

/// Of a material of a file that lies at `path`: its base or diffuse colours, and its opacities (`map_d` of MTL).
[[nodiscard]] MaterialTexture texture_of(const aiScene& file, const aiMaterial& material, const std::string& path);

}  // namespace spanline::sim
