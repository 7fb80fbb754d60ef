#pragma once
#include <cstdint>

#include "spanline/visibility/counters.hpp"

namespace spanline {

/// The part of the picture that is being drawn: rows [first_row, end_row) of a line-major buffer, biased by `row_bias`.
template <class Depth, class Pixel>
struct BandTarget {
  typename Depth::Word* depth;  ///< null where the algorithm keeps no depth
  Pixel* pixels;
  std::int32_t width;
  std::int32_t first_row;
  std::int32_t end_row;
  Pixel background;
  VisibilityCounters* counters = nullptr;  ///< for Counting only
};

}  // namespace spanline
