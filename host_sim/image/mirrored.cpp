#include "image/mirrored.hpp"

namespace spanline::sim {

ImageRgba with_mirror_image(const ImageRgba& image, bool right, bool below) {
  ImageRgba result{right ? 2 * image.width : image.width, below ? 2 * image.height : image.height, {}};
  result.pixels.reserve(image.pixels.size() * (right ? 2 : 1) * (below ? 2 : 1));
  const auto folded = [](int at, int side) { return at < side ? at : 2 * side - 1 - at; };
  for (int y = 0; y < result.height; ++y)
    for (int x = 0; x < result.width; ++x)
      result.pixels.push_back(image.at(folded(x, image.width), folded(y, image.height)));
  return result;
}

}  // namespace spanline::sim
