#include "scene/composed_image.hpp"

#include <algorithm>

#include "base/failure.hpp"
#include "image/brightness.hpp"
#include "image/resized.hpp"

namespace spanline::sim {
namespace {

ImageRgba decoded(const ImageSource& source) {
  if (!source.path.empty()) return read_image(source.path);
  try {
    return decode_image(source.bytes);
  } catch (const Failure& failure) {
    throw Failure(source.name + " " + failure.what());
  }
}

/// White with the opacities that an image stands for as its alpha.
ImageRgba opacities_of(ImageRgba image) {
  const bool opaque =
      std::all_of(image.pixels.begin(), image.pixels.end(), [](const Rgba8888& pixel) { return pixel.alpha == 255; });
  for (Rgba8888& pixel : image.pixels) pixel = {{}, opaque ? brightness(pixel.colour) : pixel.alpha};
  return image;
}

}  // namespace

ImageRgba composed(const SceneImage& image) {
  if (!image.opacities.exists()) return decoded(image.colours);
  ImageRgba opacities = opacities_of(decoded(image.opacities));
  if (!image.colours.exists()) return opacities;
  ImageRgba result = decoded(image.colours);
  if (opacities.width != result.width || opacities.height != result.height)
    opacities = resized(opacities, result.width, result.height);
  for (std::size_t i = 0; i < result.pixels.size(); ++i) result.pixels[i].alpha = opacities.pixels[i].alpha;
  return result;
}

}  // namespace spanline::sim
