#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ostream>
#include <vector>

#include "spanline/raster/gradients.hpp"
#include "spanline/raster/outline.hpp"
#include "support/exact_triangle.hpp"
#include "support/random.hpp"

namespace spanline::test {

inline constexpr Viewport outline_viewport{300, 200};

/// An outline that owns its corners.
struct OwnedOutline {
  std::vector<ScreenVertex> vertices;
  std::vector<Corner> corners;
  std::vector<Link> numbers;

  void add(int x, int y) {
    numbers.push_back(static_cast<Link>(corners.size()));
    corners.push_back({x, y, 1000});
    vertices.push_back(vertex_of(corners.back(), 16, outline_viewport.width, outline_viewport.height));
  }
  [[nodiscard]] Outline view() const {
    return {vertices.data(), numbers.data(), static_cast<unsigned>(vertices.size())};
  }
  [[nodiscard]] ExactTriangle fan(std::size_t i) const {
    return ExactTriangle({corners[0], corners[i], corners[i + 1]});
  }
  friend std::ostream& operator<<(std::ostream& out, const OwnedOutline& outline) {
    for (const Corner& c : outline.corners) out << '(' << c.x << ", " << c.y << ") ";
    return out;
  }
};

/// Corners on an ellipse of any shape and place, rounded to sixteenths of a pixel; either way round.
[[nodiscard]] inline OwnedOutline random_outline(Random& random) {
  const int count = random.between(3, Outline::most_corners);
  const double size = std::exp2(random.real(2, 12)), flat = std::exp2(random.real(-6, 0)), tilt = random.real(0, 3.15);
  const double middle_x = random.real(-400, 16 * outline_viewport.width + 400),
               middle_y = random.real(-400, 16 * outline_viewport.height + 400);
  const double start = random.real(0, 6.3), direction = random.between(0, 1) == 0 ? 1 : -1;
  OwnedOutline outline;
  for (int i = 0; i < count; ++i) {
    const double angle = start + direction * 6.2831853 * (i + random.real(0, 0.95)) / count;
    const double u = size * std::cos(angle), v = size * flat * std::sin(angle);
    const auto within = [](double at) { return static_cast<int>(std::clamp(std::round(at), -32000.0, 32000.0)); };
    outline.add(within(middle_x + u * std::cos(tilt) - v * std::sin(tilt)),
                within(middle_y + u * std::sin(tilt) + v * std::cos(tilt)));
  }
  return outline;
}

/// Gives the corners of an outline depths near a plane, or anywhere.
inline void give_depths(Random& random, int bits, OwnedOutline& outline) {
  const double dx = random.real(-1, 1) * (1 << bits) / 4000, dy = random.real(-1, 1) * (1 << bits) / 3000;
  const double start = random.real(-0.1, 1.1) * (1 << bits);
  const int noise = random.between(0, 3) == 0 ? 1 << random.between(0, bits - 4) : 0;
  for (std::size_t i = 0; i < outline.vertices.size(); ++i) {
    const double z =
        start + outline.corners[i].x / 16.0 * dx + outline.corners[i].y / 16.0 * dy + random.between(-noise, noise);
    const auto depth = static_cast<std::uint32_t>(std::clamp(z, 0.0, (1 << bits) - 2.0));
    outline.vertices[i].depth_word = depth << (32 - bits) | (outline.vertices[i].depth_word & 0xff);
  }
}

}  // namespace spanline::test
