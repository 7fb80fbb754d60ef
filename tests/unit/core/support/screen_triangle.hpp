#pragma once
#include <array>
#include <cstdint>
#include <ostream>
#include <span>
#include <vector>

#include "spanline/raster/screen_vertex.hpp"

namespace spanline::test {

/// A corner on screen: sixteenths of a pixel, and a smaller-is-nearer depth of the format that draws it.
struct Corner {
  int x = 0, y = 0;
  std::int32_t z = 0;
};

using Corners = std::array<Corner, 3>;

inline std::ostream& operator<<(std::ostream& out, const Corners& t) {
  for (const Corner& c : t) out << '(' << c.x << ", " << c.y << ", " << c.z << ") ";
  return out;
}

/// The corner as the renderer takes it, with the outcodes of a picture of this size.
[[nodiscard]] inline ScreenVertex vertex_of(const Corner& c, int bits, int width, int height) {
  const int code = (c.x < 0 ? outcode_left : 0) | (c.x > width * 16 ? outcode_right : 0) | (c.y < 0 ? outcode_top : 0) |
                   (c.y > height * 16 ? outcode_bottom : 0);
  return ScreenVertex::make(c.x, c.y, static_cast<std::uint32_t>(c.z), bits, static_cast<std::uint8_t>(code));
}

[[nodiscard]] inline std::vector<ScreenVertex> vertices_of(std::span<const Corners> triangles, int bits, int width,
                                                           int height) {
  std::vector<ScreenVertex> vertices;
  vertices.reserve(triangles.size() * 3);
  for (const Corners& triangle : triangles)
    for (const Corner& corner : triangle) vertices.push_back(vertex_of(corner, bits, width, height));
  return vertices;
}

}  // namespace spanline::test
