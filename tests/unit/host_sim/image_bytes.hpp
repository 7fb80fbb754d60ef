#pragma once
#include <cstddef>
#include <vector>

#include "image/image_file.hpp"

namespace spanline::sim::test {

/// A PNG file with alpha, and a JPEG file of the best quality without subsampled colours (alpha is dropped).
[[nodiscard]] std::vector<std::byte> png_with_alpha(const ImageRgba& image);
[[nodiscard]] std::vector<std::byte> jpeg_of(const ImageRgba& image);

}  // namespace spanline::sim::test
