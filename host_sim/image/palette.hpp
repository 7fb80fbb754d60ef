#pragma once
#include <vector>

#include "image/image_file.hpp"

namespace spanline::sim {

/// Few colours in the place of many.
class Palette {
 public:
  Palette() = default;
  /// `count` colours for an image by median cut: the box of colours whose widest channel is widest, weighted by its
  /// pixels, is cut where half of its pixels lie to either side. Fewer colours than that are kept as they are; the rest
  /// of the palette is black.
  [[nodiscard]] static Palette of(const ImageRgba& image, std::size_t count);

  [[nodiscard]] const std::vector<Rgb888>& colours() const { return colours_; }
  /// The number of the colour that is nearest; the first of several.
  [[nodiscard]] std::size_t nearest(Rgb888 colour) const;

 private:
  std::vector<Rgb888> colours_;
};

}  // namespace spanline::sim
