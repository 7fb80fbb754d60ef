#pragma once
#include <cstddef>
#include <span>

#include "image/image_file.hpp"

namespace spanline::sim {

/// Reads the bytes of a JPEG file, grey or in colour. Throws Failure; data that ends early or is damaged is refused.
[[nodiscard]] ImageRgba decode_jpeg(std::span<const std::byte> bytes);

}  // namespace spanline::sim
