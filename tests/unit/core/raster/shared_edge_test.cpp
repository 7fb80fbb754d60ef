// Polygons that share an edge leave no gap and write no pixel twice (promise 4).
//
// Later triangles are nearer, so that each fragment wins its depth test: fragments tested, pixels written and pixels
// that show something are one number if every pixel is written once.
#include <gtest/gtest.h>
#include <spanline/frame/ready_made_traits.hpp>
#include <spanline/raster/surface_blocks.hpp>
#include <spanline/visibility/counters.hpp>

#include <algorithm>
#include <vector>

#include "support/effort.hpp"
#include "support/exact_triangle.hpp"
#include "support/random.hpp"
#include "support/ready_made_studios.hpp"

namespace spanline::test {
namespace {

using Traits = FlatTraits<Rgb565, Depth16<>, Counted>;

struct Point {
  int x, y;
};

/// Triangles over points, each at a depth of its own, nearer and nearer.
class Sheet {
 public:
  void add(Point a, Point b, Point c) {
    const std::int32_t z = 60000 - 8 * static_cast<std::int32_t>(triangles_.size());
    triangles_.push_back({Corner{a.x, a.y, z}, Corner{b.x, b.y, z}, Corner{c.x, c.y, z}});
  }
  [[nodiscard]] const std::vector<Corners>& triangles() const { return triangles_; }

 private:
  std::vector<Corners> triangles_;
};

/// Whether every pixel of `outline` (a polygon whose triangles are given coarsely) was written once, and no other.
void expect_once(const Sheet& sheet, const std::vector<Corners>& outline, int width, int height) {
  Studio<Traits> studio(screen_capacity(width, height, sheet.triangles().size()));
  const auto picture = studio.draw_screen(sheet.triangles());
  ASSERT_TRUE(studio.status().ok());
  std::size_t wanted = 0, missing = 0;
  for (const Corners& part : outline)
    ExactTriangle(part).for_each_pixel(width, height, [&](int x, int y) {
      ++wanted;
      if (!picture.drawn(x, y)) ++missing;
    });
  const VisibilityCounters& counted = studio.statistics().visibility;
  EXPECT_EQ(missing, 0U) << "gaps";
  EXPECT_EQ(picture.drawn_count(), wanted) << "pixels outside the union";
  EXPECT_EQ(counted.depth_tests, wanted) << "fragments";
  EXPECT_EQ(counted.pixels, wanted) << "pixels written";
}

std::vector<Corners> rectangle(int x0, int y0, int x1, int y1) {
  const Corner a{x0, y0, 0}, b{x1, y0, 0}, c{x1, y1, 0}, d{x0, y1, 0};
  return {{a, b, c}, {a, c, d}};
}

/// A random triangulation of a rectangle: points are thrown in one by one, and the triangle that a point falls into is
/// split; a point on an edge splits both sides, so that all edges stay shared.
class Triangulation {
 public:
  Triangulation(Random& random, int x0, int y0, int x1, int y1) : random_(random), low_{x0, y0}, high_{x1, y1} {
    const Point a = low_, b{x1, y0}, c = high_, d{x0, y1};
    parts_ = {{a, b, c}, {a, c, d}};
  }
  void split() {
    const Point p{random_.between(low_.x + 1, high_.x - 1), random_.between(low_.y + 1, high_.y - 1)};
    std::vector<std::array<Point, 3>> kept, made;
    for (const auto& t : parts_) {
      const std::int64_t side[3] = {area(t[1], t[2], p), area(t[2], t[0], p), area(t[0], t[1], p)};
      if (side[0] < 0 || side[1] < 0 || side[2] < 0) {
        kept.push_back(t);
        continue;
      }
      if ((side[0] == 0) + (side[1] == 0) + (side[2] == 0) > 1) return;  // on a corner
      if (side[0] != 0) made.push_back({t[1], t[2], p});
      if (side[1] != 0) made.push_back({t[2], t[0], p});
      if (side[2] != 0) made.push_back({t[0], t[1], p});
    }
    kept.insert(kept.end(), made.begin(), made.end());
    parts_ = std::move(kept);
  }
  [[nodiscard]] const std::vector<std::array<Point, 3>>& parts() const { return parts_; }

 private:
  static std::int64_t area(Point a, Point b, Point c) {
    return static_cast<std::int64_t>(b.x - a.x) * (c.y - a.y) - static_cast<std::int64_t>(b.y - a.y) * (c.x - a.x);
  }
  Random& random_;
  Point low_, high_;
  std::vector<std::array<Point, 3>> parts_;
};

TEST(SharedEdges, RandomTriangulationsOfARectangleWriteEachPixelOnce) {
  Random random(11);
  for (int i = 0; i < rounds(150); ++i) {
    const int x0 = random.between(-40, 300), y0 = random.between(-40, 300);
    const int x1 = x0 + random.between(64, 16 * 190), y1 = y0 + random.between(64, 16 * 140);
    Triangulation mesh(random, x0, y0, x1, y1);
    const int points = random.between(1, 250);
    for (int k = 0; k < points; ++k) mesh.split();
    Sheet sheet;
    for (const auto& t : mesh.parts()) sheet.add(t[0], t[1], t[2]);
    expect_once(sheet, rectangle(x0, y0, x1, y1), 180, 130);
    ASSERT_FALSE(HasFailure()) << "round " << i;
  }
}

TEST(SharedEdges, TriangulationsAcrossTheGuardBandWriteEachPixelOnce) {
  Random random(12);
  for (int i = 0; i < rounds(60); ++i) {
    constexpr int far = ScreenVertex::guard_pixels * 16;
    Triangulation mesh(random, -far, -far, far, far);
    for (int k = random.between(2, 120); k > 0; --k) mesh.split();
    Sheet sheet;
    for (const auto& t : mesh.parts()) sheet.add(t[0], t[1], t[2]);
    expect_once(sheet, rectangle(-far, -far, far, far), 180, 130);
    ASSERT_FALSE(HasFailure()) << "round " << i;
  }
}

TEST(SharedEdges, GridsWithJitterWriteEachPixelOnce) {
  Random random(13);
  for (int i = 0; i < rounds(100); ++i) {
    const int cell = random.between(20, 400), jitter = cell / 3, columns = 2400 / cell + 1, rows = 1600 / cell + 1;
    const int x0 = random.between(0, 400), y0 = random.between(0, 300);
    std::vector<Point> points;
    for (int r = 0; r <= rows; ++r)
      for (int c = 0; c <= columns; ++c) {
        // The border stays straight, so that the union is a rectangle.
        const int across = c == 0 || c == columns ? 0 : random.between(-jitter, jitter);
        const int down = r == 0 || r == rows ? 0 : random.between(-jitter, jitter);
        points.push_back({x0 + c * cell + across, y0 + r * cell + down});
      }
    Sheet sheet;
    const auto at = [&](int c, int r) { return points[static_cast<std::size_t>(r * (columns + 1) + c)]; };
    for (int r = 0; r < rows; ++r)
      for (int c = 0; c < columns; ++c) {
        // A third of a cell of jitter keeps quadrilaterals convex enough for either diagonal only where both halves
        // keep their orientation: the diagonal is chosen so.
        const Point a = at(c, r), b = at(c + 1, r), d = at(c, r + 1), e = at(c + 1, r + 1);
        const auto area = [](Point p, Point q, Point s) {
          return static_cast<std::int64_t>(q.x - p.x) * (s.y - p.y) -
                 static_cast<std::int64_t>(q.y - p.y) * (s.x - p.x);
        };
        if (area(a, b, e) >= 0 && area(a, e, d) >= 0) {
          sheet.add(a, b, e);
          sheet.add(a, e, d);
        } else {
          sheet.add(a, b, d);
          sheet.add(b, e, d);
        }
      }
    expect_once(sheet, rectangle(x0, y0, x0 + columns * cell, y0 + rows * cell), 200, 140);
    ASSERT_FALSE(HasFailure()) << "round " << i;
  }
}

TEST(SharedEdges, FansAroundAVertexWriteEachPixelOnce) {
  Random random(14);
  for (int i = 0; i < rounds(400); ++i) {
    const int x0 = random.between(0, 500), y0 = random.between(0, 500), x1 = x0 + random.between(32, 1500),
              y1 = y0 + random.between(32, 1500);
    const Point centre{random.between(x0 + 1, x1 - 1), random.between(y0 + 1, y1 - 1)};
    // The rim: points on the rectangle's border, in order.
    std::vector<Point> rim;
    const int spokes = random.between(1, 30);
    const auto side = [&](Point from, Point to) {
      std::vector<int> parts{0};
      for (int k = 0; k < spokes; ++k) parts.push_back(random.between(1, 1023));
      std::sort(parts.begin(), parts.end());
      parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
      for (const int part : parts) {
        const Point p{from.x + (to.x - from.x) * part / 1024, from.y + (to.y - from.y) * part / 1024};
        if (rim.empty() || p.x != rim.back().x || p.y != rim.back().y) rim.push_back(p);
      }
    };
    side({x0, y0}, {x1, y0});
    side({x1, y0}, {x1, y1});
    side({x1, y1}, {x0, y1});
    side({x0, y1}, {x0, y0});
    Sheet sheet;
    for (std::size_t k = 0; k < rim.size(); ++k) sheet.add(centre, rim[k], rim[(k + 1) % rim.size()]);
    expect_once(sheet, rectangle(x0, y0, x1, y1), 128, 128);
    ASSERT_FALSE(HasFailure()) << "round " << i;
  }
}

TEST(SharedEdges, TriangleSoupsCoverExactlyTheUnionAndTestEachFragmentOnce) {
  Random random(15);
  for (int i = 0; i < rounds(60); ++i) {
    std::vector<Corners> soup;
    for (int k = 0; k < 60; ++k) {
      const int size = 1 << random.between(4, 12), x = random.between(0, 2400), y = random.between(0, 1600);
      Corners t;
      for (Corner& c : t) c = {x + random.between(-size, size), y + random.between(-size, size), 60000 - 8 * k};
      soup.push_back(t);
    }
    Studio<Traits> studio(screen_capacity(150, 100, soup.size()));
    const auto picture = studio.draw_screen(soup);
    std::vector<int> layers(picture.pixels.size());
    std::set<std::uint32_t> covering;
    std::uint64_t fragments = 0;
    for (std::size_t k = 0; k < soup.size(); ++k)
      ExactTriangle(soup[k]).for_each_pixel(150, 100, [&](int x, int y) {
        ++layers[picture.at(x, y)];
        ++fragments;
        covering.insert(static_cast<std::uint32_t>(k));
      });
    for (std::size_t p = 0; p < layers.size(); ++p)
      ASSERT_EQ(layers[p] != 0, picture.depth[p] != Depth16<>::clear) << "pixel " << p << " of round " << i;
    EXPECT_EQ(studio.statistics().visibility.depth_tests, fragments);
    EXPECT_EQ(studio.statistics().visibility.pixels, fragments);
    EXPECT_EQ(picture.covered, covering);
  }
}

}  // namespace
}  // namespace spanline::test
