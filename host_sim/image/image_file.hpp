#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "spanline/model/colour.hpp"

namespace spanline::sim {

/// A colour and how much of it covers what lies below, 0 … 255; not premultiplied.
struct Rgba8888 {
  Rgb888 colour{0, 0, 0};
  std::uint8_t alpha = 255;
  friend bool operator==(const Rgba8888&, const Rgba8888&) = default;
};

/// A picture with alpha, row-major, top row first.
struct ImageRgba {
  int width = 0, height = 0;
  std::vector<Rgba8888> pixels;

  [[nodiscard]] Rgba8888& at(int x, int y) {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  }
  [[nodiscard]] const Rgba8888& at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  }
};

/// The greatest side of an image that is read, and the most pixels.
inline constexpr int greatest_image_side = 16384;
inline constexpr std::uint64_t most_image_pixels = std::uint64_t{1} << 26;

/// Throws Failure for an image that is empty or beyond the limits.
void check_image_size(std::uint64_t width, std::uint64_t height);

/// Reads the bytes of a PNG or JPEG file, whichever they are. Throws Failure.
[[nodiscard]] ImageRgba decode_image(const std::vector<std::byte>& bytes);

/// Reads a PNG or JPEG file. Throws Failure that names the file.
[[nodiscard]] ImageRgba read_image(const std::string& path);

/// Whether a name ends as those of images do.
[[nodiscard]] bool is_image_name(const std::string& path);

}  // namespace spanline::sim
