#include "image/height_image.hpp"

#include <bit>
#include <cmath>

#include "base/failure.hpp"
#include "image/brightness.hpp"
#include "image/image_file.hpp"

namespace spanline::sim {

HeightMap HeightImage::view() const {
  HeightMap map;
  map.log2_width = static_cast<std::uint8_t>(log2_width);
  map.log2_height = static_cast<std::uint8_t>(log2_height);
  map.heights = heights;
  return map;
}

double HeightImage::at(double s, double t) const {
  const double u = s * (1 << log2_width) - 0.5, v = t * (1 << log2_height) - 0.5;
  const double column = std::floor(u), row = std::floor(v), right = u - column, down = v - row;
  const auto texel = [&](double x, double y) {
    const auto wrapped = [](double value, int log2) {
      const double size = 1 << log2;
      return static_cast<std::size_t>(value - std::floor(value / size) * size);
    };
    return heights[(wrapped(y, log2_height) << log2_width) + wrapped(x, log2_width)] / 255.0;
  };
  return (texel(column, row) * (1 - right) + texel(column + 1, row) * right) * (1 - down) +
         (texel(column, row + 1) * (1 - right) + texel(column + 1, row + 1) * right) * down;
}

HeightImage read_heights(const std::string& path) {
  const ImageRgba image = read_image(path);
  constexpr int greatest = 1 << HeightMap::max_log2_size;
  const auto allowed = [](int side) { return side <= greatest && std::has_single_bit(static_cast<unsigned>(side)); };
  if (!allowed(image.width) || !allowed(image.height))
    throw file_failure(path, "is " + std::to_string(image.width) + "x" + std::to_string(image.height) +
                                 "; heights have sides that are powers of two, at most " + std::to_string(greatest));
  HeightImage result;
  result.log2_width = std::countr_zero(static_cast<unsigned>(image.width));
  result.log2_height = std::countr_zero(static_cast<unsigned>(image.height));
  for (const Rgba8888& pixel : image.pixels) result.heights.push_back(brightness(pixel.colour));
  return result;
}

}  // namespace spanline::sim
