#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <spanline/raster/surface_blocks.hpp>

#include "support/screen_triangle.hpp"

namespace spanline::test {

/// What a triangle must cover and how deep it must be, by definition: edge functions in 64-bit integers, the top-left
/// rule, pixel centres at 16·i + 8 sixteenths, and depth as a quotient of 128-bit integers. Shares no idea with the
/// rasteriser.
class ExactTriangle {
 public:
  explicit ExactTriangle(const Corners& corners) : c_(corners) {
    area_ = static_cast<std::int64_t>(c_[1].x - c_[0].x) * (c_[2].y - c_[0].y) -
            static_cast<std::int64_t>(c_[1].y - c_[0].y) * (c_[2].x - c_[0].x);
    if (area_ < 0) {
      std::swap(c_[1], c_[2]);
      area_ = -area_;
    }
  }

  /// Twice the area, square sixteenths.
  [[nodiscard]] std::int64_t area() const { return area_; }

  [[nodiscard]] bool covers(int x, int y) const {
    if (area_ == 0) return false;
    for (std::size_t k = 0; k < 3; ++k) {
      const Corner &from = c_[next(k)], &to = c_[next(next(k))];
      const int dx = to.x - from.x, dy = to.y - from.y;
      const std::int64_t side = edge(k, x, y);
      const bool top_or_left = dy < 0 || (dy == 0 && dx > 0);  // clockwise on screen, y down
      if (side < 0 || (side == 0 && !top_or_left)) return false;
    }
    return true;
  }

  /// Depth at a pixel centre, exact but for the last rounding to double.
  [[nodiscard]] double depth(int x, int y) const {
    return static_cast<double>(numerator(x, y)) / static_cast<double>(area_);
  }

  /// |integer − depth| at a pixel centre: the difference is formed exactly.
  [[nodiscard]] double depth_error(int x, int y, std::int64_t integer) const {
    return std::fabs(static_cast<double>(static_cast<__int128>(integer) * area_ - numerator(x, y)) /
                     static_cast<double>(area_));
  }

  /// Columns and rows that can hold covered pixels of a picture: [first, last].
  struct Range {
    int first, last;
  };
  [[nodiscard]] Range columns(int width) const { return range(c_[0].x, c_[1].x, c_[2].x, width); }
  [[nodiscard]] Range rows(int height) const { return range(c_[0].y, c_[1].y, c_[2].y, height); }

  /// Calls f(x, y) for every covered pixel of a picture, row by row.
  template <class F>
  void for_each_pixel(int width, int height, F f) const {
    const Range across = columns(width), down = rows(height);
    for (int y = down.first; y <= down.last; ++y)
      for (int x = across.first; x <= across.last; ++x)
        if (covers(x, y)) f(x, y);
  }

 private:
  static std::size_t next(std::size_t k) { return k == 2 ? 0 : k + 1; }
  static Range range(int a, int b, int c, int size) {
    return {std::max(0, (std::min({a, b, c}) >> 4) - 1), std::min(size - 1, (std::max({a, b, c}) >> 4) + 1)};
  }
  /// Twice the area of the pixel centre with the edge opposite corner k: its weight.
  [[nodiscard]] std::int64_t edge(std::size_t k, int x, int y) const {
    const Corner &from = c_[next(k)], &to = c_[next(next(k))];
    return static_cast<std::int64_t>(to.x - from.x) * (16 * y + 8 - from.y) -
           static_cast<std::int64_t>(to.y - from.y) * (16 * x + 8 - from.x);
  }
  [[nodiscard]] __int128 numerator(int x, int y) const {
    __int128 sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += static_cast<__int128>(edge(k, x, y)) * c_[k].z;
    return sum;
  }

  Corners c_;
  std::int64_t area_;
};

}  // namespace spanline::test
