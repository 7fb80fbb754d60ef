#pragma once
#include <cstdint>

namespace spanline {

/// A run of visible pixels of one polygon on one line: what visibility gives and shading takes.
struct Span {
  std::int32_t y;   ///< line of the picture
  std::int32_t x0;  ///< first pixel
  std::int32_t x1;  ///< one past the last pixel, > x0
};

}  // namespace spanline
