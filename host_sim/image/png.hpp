#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "image/image_file.hpp"
#include "image/picture.hpp"

namespace spanline::sim {

/// An 8-bit RGB PNG of the picture; throws Failure if the encoder fails.
[[nodiscard]] std::vector<std::byte> encode_png(const Picture& picture);

/// Reads any PNG as 8-bit RGB (alpha dropped); throws Failure that says what is wrong, without a file's name.
[[nodiscard]] Picture decode_png(std::span<const std::byte> bytes);

/// The same with alpha.
[[nodiscard]] ImageRgba decode_png_rgba(std::span<const std::byte> bytes);

}  // namespace spanline::sim
