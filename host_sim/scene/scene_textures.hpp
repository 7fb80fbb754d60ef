#pragma once
#include <string>
#include <vector>

#include "image/texture_image.hpp"
#include "scene/scene.hpp"
#include "spanline/model/material.hpp"

namespace spanline::sim {

/// The texture of a part: none, or one of a list.
struct PartTexture {
  static constexpr std::size_t none = ~std::size_t{0};
  std::size_t image = none;
  TexelAlpha alpha = TexelAlpha::cut_out;
};

/// Textures of a scene: each is there once for all parts that use it alike.
struct SceneTextures {
  std::vector<TextureImage> images;
  std::vector<PartTexture> of_part;  ///< one a part
};

/// Reads and quantises the images of all parts. Texels with alpha that cuts out become rgb565_cutout, those that blend
/// argb4444, others the format of `options`, which `format_wanted` makes hold for all. Mirrored ones are made twice as
/// large. Throws Failure that names the image.
[[nodiscard]] SceneTextures load_textures(const Scene& scene, const TextureOptions& options,
                                          bool format_wanted = false);

/// Whether any part has a texture that repeats mirrored, and coordinates for it.
[[nodiscard]] bool has_mirrored_textures(const Scene& scene);

/// Halves the texture coordinates of parts along axes where their textures repeat mirrored: what `load_textures` makes
/// there is image and mirror image in one, twice as large. For once, before the textures are drawn.
void halve_mirrored_coordinates(Scene& scene);

/// Wraps the textures of all parts alike, whatever the model says.
void set_wrap(Scene& scene, Wrap wrap);

/// Gives an image file to every part without a texture of its own; colours of the model give way to it there.
void use_texture(Scene& scene, const std::string& path);

/// Gives an image file to every part, whatever it had; colours and coordinates give way to it.
void use_environment(Scene& scene, const std::string& path);

}  // namespace spanline::sim
