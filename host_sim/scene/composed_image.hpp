#pragma once
#include "image/image_file.hpp"
#include "scene/scene.hpp"

namespace spanline::sim {

/// Reads an image's parts and puts them together, at the size of its colours. Opacities are the alpha of their image,
/// or its brightness where it is opaque all over. Throws Failure that names the file.
[[nodiscard]] ImageRgba composed(const SceneImage& image);

}  // namespace spanline::sim
