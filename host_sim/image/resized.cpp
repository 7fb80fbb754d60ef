#include "image/resized.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace spanline::sim {
namespace {

/// What an interval of the source's columns or rows adds up to, weighted by alpha: a box filter both ways.
Rgba8888 mean(const ImageRgba& image, double left, double right, double top, double bottom) {
  std::array<double, 3> sum{};
  double alpha = 0, area = 0;
  for (int y = static_cast<int>(top); y < image.height && y < bottom; ++y)
    for (int x = static_cast<int>(left); x < image.width && x < right; ++x) {
      const double weight = (std::min<double>(x + 1, right) - std::max<double>(x, left)) *
                            (std::min<double>(y + 1, bottom) - std::max<double>(y, top));
      const Rgba8888& pixel = image.at(x, y);
      const double covered = weight * pixel.alpha;
      sum[0] += covered * pixel.colour.red;
      sum[1] += covered * pixel.colour.green;
      sum[2] += covered * pixel.colour.blue;
      alpha += covered;
      area += weight;
    }
  const auto channel = [](double value) { return static_cast<std::uint8_t>(std::lround(value)); };
  if (alpha <= 0 || area <= 0) return {{0, 0, 0}, 0};
  return {{channel(sum[0] / alpha), channel(sum[1] / alpha), channel(sum[2] / alpha)}, channel(alpha / area)};
}

}  // namespace

ImageRgba resized(const ImageRgba& image, int width, int height) {
  ImageRgba result{width, height, {}};
  result.pixels.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  const double across = static_cast<double>(image.width) / width, down = static_cast<double>(image.height) / height;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      result.pixels.push_back(mean(image, x * across, (x + 1) * across, y * down, (y + 1) * down));
  return result;
}

}  // namespace spanline::sim
