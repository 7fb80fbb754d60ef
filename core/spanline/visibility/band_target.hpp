#pragma once
#include <cstdint>

#include "spanline/visibility/depth_bounds.hpp"

namespace spanline {

/// Counters of what a visibility algorithm did (--stats).
struct VisibilityCounters {
  std::uint64_t spans = 0;        ///< runs of pixels handed to shading or to the depth test
  std::uint64_t pixels = 0;       ///< pixels of polygons written
  std::uint64_t depth_tests = 0;  ///< depth comparisons
  std::uint64_t shaded = 0;       ///< spanning: all pixels written, the background's too
  std::uint64_t decisions = 0;    ///< spanning: visibility decisions, one a span that begins or comes back to the front
  std::uint64_t crossings = 0;    ///< spanning: false edges, where polygons cross inside a span
  std::uint64_t order_repairs = 0;  ///< spanning: polygons that changed places from one row to the next
  std::uint64_t sleeps = 0;         ///< spanning: polygons that slept behind another
};

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
  DepthBounds<Depth>* bounds = nullptr;    ///< for z-buffers with bounds only
};

}  // namespace spanline
