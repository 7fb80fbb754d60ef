#pragma once
#include <array>

#include "support/screen_triangle.hpp"

namespace spanline::test {

/// A lecture's triangle, whose fill takes in its right and bottom edges: its corners are pixel centres moved a little
/// away from its middle, along its plane through z·unit at those centres. y counts upwards from the bottom row.
struct LectureTriangle {
  struct Point {
    int x, y, z;
  };
  std::array<Point, 3> corner;

  [[nodiscard]] Corners grown(int height, int unit) const {
    const int middle_x = corner[0].x + corner[1].x + corner[2].x, middle_y = corner[0].y + corner[1].y + corner[2].y;
    Corners out;
    // The plane's gradients in units a pixel, whole numbers for these triangles.
    const auto [dzdx, dzdy] = gradients();
    for (std::size_t i = 0; i < 3; ++i) {
      const Point& p = corner[i];
      // Sixteenths: a sixteenth of the way from the middle. The plane's units are multiples of 16, so depths stay
      // whole.
      const int mx = (3 * p.x - middle_x) / 3, my = (3 * p.y - middle_y) / 3;
      out[i] = {p.x * 16 + 8 + mx, (height - 1 - p.y) * 16 + 8 - my, p.z * unit + (dzdx * mx + dzdy * my) * unit / 16};
    }
    return out;
  }

 private:
  [[nodiscard]] std::array<int, 2> gradients() const {
    const auto& [a, b, c] = corner;
    const int area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    return {((b.z - a.z) * (c.y - a.y) - (c.z - a.z) * (b.y - a.y)) / area,
            ((c.z - a.z) * (b.x - a.x) - (b.z - a.z) * (c.x - a.x)) / area};
  }
};

}  // namespace spanline::test
