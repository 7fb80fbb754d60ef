#pragma once
#include "image/image_file.hpp"

namespace spanline::sim {

/// The image with its mirror image to the right, below, or both, so that plain repetition of the whole is mirrored
/// repetition of the image.
[[nodiscard]] ImageRgba with_mirror_image(const ImageRgba& image, bool right, bool below);

}  // namespace spanline::sim
