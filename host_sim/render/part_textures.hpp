#pragma once
#include <span>
#include <vector>

#include "render/frame.hpp"
#include "scene/scene_textures.hpp"

namespace spanline::sim {

/// The textures of a scene's parts, read and quantised, as frames ask for them.
class PartTextures {
 public:
  PartTextures() = default;                ///< none
  PartTextures(PartTextures&&) = default;  // views point into tables, which stay where they are when moved
  PartTextures& operator=(PartTextures&&) = default;
  /// Throws Failure that names the image.
  PartTextures(const Scene& scene, const TextureOptions& options) : textures_(load_textures(scene, options)) {
    for (const TextureImage& image : textures_.images) views_.push_back(image.view());
    for (const PartTexture& part : textures_.of_part)
      of_part_.push_back({part.image == PartTexture::none ? nullptr : &views_[part.image], part.alpha});
  }

  /// One a part; good for as long as this lives and stays where it is.
  [[nodiscard]] std::span<const FrameTexture> of_part() const { return of_part_; }

 private:
  SceneTextures textures_;
  std::vector<Texture> views_;
  std::vector<FrameTexture> of_part_;
};

}  // namespace spanline::sim
