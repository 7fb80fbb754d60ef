#pragma once
#include <cstdint>

#include "spanline/visibility/counters.hpp"

namespace spanline {

/// The band of the picture that is being drawn: rows [first_row, end_row) of the picture, in a buffer of whole lines.
template <class Depth, class Pixel>
struct BandTarget {
  using Plain = BandTarget;                ///< for targets that add to it: the part that kernels know the layout of
  typename Depth::Word* depth;             ///< depths of the band, line by line; null if the algorithm keeps no depth
  Pixel* pixels;                           ///< colours of the band, line by line
  std::int32_t width;                      ///< pixels of a line, 1 … 2047
  std::int32_t first_row;                  ///< first row of the band, biased by `row_bias`
  std::int32_t end_row;                    ///< row after the last one of the band, biased by `row_bias`
  Pixel background;                        ///< colour of pixels that no polygon covers
  VisibilityCounters* counters = nullptr;  ///< used only when counting
};

}  // namespace spanline
