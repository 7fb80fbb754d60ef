#pragma once
/// @file
/// Models of several materials.
///
/// ```cpp
/// #include <spanline/frame/ready_made_traits.hpp>
/// #include <spanline/frame/renderer.hpp>
///
/// Status add_all(Renderer<LocalLightTraits<>>& picture, std::span<const ModelPart> robot, const Transform& where) {
///   Status status;
///   for (std::size_t i = 0; status.ok() && i < robot.size(); ++i)
///     status = picture.add(*robot[i].mesh, where, robot[i].material);
///   return status;
/// }
/// ```
#include "spanline/model/material.hpp"
#include "spanline/model/mesh.hpp"

namespace spanline {

/// A piece of a model with its own material, as `spanline convert --materials` writes them. A model is an array of
/// these.
struct ModelPart {
  const Mesh* mesh = nullptr;  ///< must stay valid until the frame is drawn; no renderer accepts null, the default
  Material material{};         ///< of the whole mesh
};

/// A part under a texture, or null for none. A constant of C++, whatever else a material has.
[[nodiscard]] constexpr ModelPart model_part(const Mesh& mesh, Rgb888 colour, ShadingMode shading,
                                             std::uint8_t opacity = 255, const Texture* texture = nullptr,
                                             TexelAlpha alpha = TexelAlpha::cut_out) {
  ModelPart part;
  part.mesh = &mesh;
  part.material.colour = colour;
  part.material.shading = shading;
  part.material.opacity = opacity;
  part.material.texturing.texture = texture;
  part.material.texturing.alpha = alpha;
  return part;
}

/// The same part with highlights, for renderers with `LocalFlatShader` in their lists.
[[nodiscard]] constexpr ModelPart shining(ModelPart part, Rgb888 specular, std::uint8_t shininess) {
  part.material.specular = specular;
  part.material.shininess = shininess;
  return part;
}

}  // namespace spanline
