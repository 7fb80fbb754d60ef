#pragma once
#include "image/image_file.hpp"

namespace spanline::sim {

/// The image at another size: each pixel is the mean of the area that it covers, weighted by alpha.
[[nodiscard]] ImageRgba resized(const ImageRgba& image, int width, int height);

}  // namespace spanline::sim
