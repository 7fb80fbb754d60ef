#pragma once
#include <algorithm>
#include <array>

#include "spanline/raster/screen_vertex.hpp"
#include "support/random.hpp"
#include "support/screen_triangle.hpp"

namespace spanline::test {

/// The classes of triangles that every set-up path of the rasteriser is tried with.
enum class TriangleKind {
  tiny,          ///< within 16 × 16 pixels, any depths
  tiny_gentle,   ///< the same, depths close together
  tiny_sliver,   ///< the same, third corner within a few sixteenths of the line through the others
  pixel,         ///< within two pixels
  medium,        ///< within 32 × 32 pixels
  large,         ///< within 190 × 190 pixels
  right_angled,  ///< legs of 8 whole pixels, as in benchmark scenes
  screen,        ///< corners anywhere in the picture
  sliver,        ///< as long as the picture and a few sixteenths wide
  giant,         ///< corners anywhere in the guard band
  giant_sliver,  ///< as long as the guard band and a few sixteenths wide
};

inline constexpr std::array all_triangle_kinds{
    TriangleKind::tiny,   TriangleKind::tiny_gentle, TriangleKind::tiny_sliver,  TriangleKind::pixel,
    TriangleKind::medium, TriangleKind::large,       TriangleKind::right_angled, TriangleKind::screen,
    TriangleKind::sliver, TriangleKind::giant,       TriangleKind::giant_sliver};

[[nodiscard]] inline const char* name_of(TriangleKind kind) {
  constexpr std::array names{"tiny",         "tiny_gentle", "tiny_sliver", "pixel", "medium",      "large",
                             "right_angled", "screen",      "sliver",      "giant", "giant_sliver"};
  return names[static_cast<std::size_t>(kind)];
}

/// Draws random triangles of a kind for one picture size and one range of depths.
class TriangleMaker {
 public:
  TriangleMaker(std::uint32_t seed, int width, int height, std::int32_t nearest, std::int32_t farthest)
      : random_(seed), width_(width * 16), height_(height * 16), nearest_(nearest), farthest_(farthest) {}

  [[nodiscard]] Corners operator()(TriangleKind kind) {
    Corners c{};
    switch (kind) {
      case TriangleKind::tiny:
      case TriangleKind::tiny_gentle:
        c = around(256);
        break;
      case TriangleKind::pixel:
        c = around(32);
        break;
      case TriangleKind::medium:
        c = around(512);
        break;
      case TriangleKind::large:
        c = around(3000);
        break;
      case TriangleKind::tiny_sliver:
        c = thinned(around(256), 2);
        break;
      case TriangleKind::right_angled:
        c = right_angle();
        break;
      case TriangleKind::screen:
      case TriangleKind::sliver:
        for (Corner& k : c) k = {random_.between(0, width_), random_.between(0, height_), depth()};
        if (kind == TriangleKind::sliver) c = thinned(c, 3);
        break;
      case TriangleKind::giant:
      case TriangleKind::giant_sliver:
        for (Corner& k : c) k = {random_.between(-guard, guard), random_.between(-guard, guard), depth()};
        if (kind == TriangleKind::giant_sliver) c = thinned(c, 3);
        break;
    }
    if (kind == TriangleKind::tiny_gentle || kind == TriangleKind::right_angled) {
      const std::int32_t base = depth();
      for (Corner& k : c) k.z = base + random_.between(0, (farthest_ - nearest_) / 64);
    }
    for (Corner& k : c) {
      k.x = std::clamp(k.x, -guard, guard);
      k.y = std::clamp(k.y, -guard, guard);
      k.z = std::clamp(k.z, nearest_, farthest_);
    }
    std::rotate(c.begin(), c.begin() + random_.between(0, 2), c.end());
    return c;
  }

  [[nodiscard]] Random& random() { return random_; }
  [[nodiscard]] std::int32_t depth() { return random_.between(nearest_, farthest_); }

 private:
  static constexpr int guard = ScreenVertex::guard_pixels * 16;

  [[nodiscard]] Corners around(int size) {
    const int x = random_.between(0, width_) - size / 2, y = random_.between(0, height_) - size / 2;
    Corners c;
    for (Corner& k : c) k = {x + random_.between(0, size), y + random_.between(0, size), depth()};
    return c;
  }
  /// Moves the third corner to within `reach` sixteenths of the line through the others.
  [[nodiscard]] Corners thinned(Corners c, int reach) {
    const std::int64_t part = random_.between(0, 64);
    const auto between = [part](int a, int b) { return static_cast<int>(a + (b - a) * part / 64); };
    c[2].x = between(c[0].x, c[1].x) + random_.between(-reach, reach);
    c[2].y = between(c[0].y, c[1].y) + random_.between(-reach, reach);
    return c;
  }
  [[nodiscard]] Corners right_angle() {
    constexpr int leg = 128;
    const int x = random_.between(0, width_) & ~15, y = random_.between(0, height_) & ~15, turn = random_.between(0, 3);
    Corners c;
    for (int k = 0; k < 3; ++k) {
      const int corner = (turn + k) & 3;
      c[static_cast<std::size_t>(k)] = {x + (corner == 1 || corner == 2 ? leg : 0), y + (corner >= 2 ? leg : 0), 0};
    }
    return c;
  }

  Random random_;
  int width_, height_;
  std::int32_t nearest_, farthest_;
};

}  // namespace spanline::test
