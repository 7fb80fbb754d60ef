// Where an instance's sphere lies to the view, at every focal length that a camera may have: what is called inside
// leaves the viewport by no vertex, for such instances are drawn without being cut, and what is called outside shows
// nothing.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "spanline/geometry/instance.hpp"
#include "support/effort.hpp"
#include "support/random.hpp"

namespace spanline::test {
namespace {

constexpr int width = 320, height = 240;
constexpr double unit = 1 / 65536.0;

FrameView view_with(std::int32_t focal_raw, Projection projection) {
  FrameView view;
  view.camera.projection = projection;
  view.camera.focal = Q16_16::from_raw(focal_raw);
  view.camera.near_plane = Q16_16::from_ratio(1, 64);
  view.camera.far_plane = Q16_16::from_int(30000);
  view.viewport = {width, height};
  return view;
}

/// Points of a ball of the given radius, in steps of 2^-13 world units.
std::vector<Vertex16> ball(Random& random, std::int32_t radius) {
  std::vector<Vertex16> points;
  for (const int axis : {0, 1, 2})
    for (const int sign : {-1, 1}) {
      Vertex16 point{};
      (axis == 0 ? point.x : axis == 1 ? point.y : point.z) = static_cast<std::int16_t>(sign * radius);
      points.push_back(point);
    }
  while (points.size() < 40) {
    const double turn = random.between(0, 62831) / 1e4, up = random.between(-1000, 1000) / 1000.0;
    const double around = std::sqrt(1 - up * up);
    points.push_back({static_cast<std::int16_t>(radius * around * std::cos(turn)),
                      static_cast<std::int16_t>(radius * up),
                      static_cast<std::int16_t>(radius * around * std::sin(turn))});
  }
  return points;
}

class Placements : public ::testing::TestWithParam<std::int32_t> {};

TEST_P(Placements, InsideIsInsideAndOutsideIsOutside) {
  Random random(static_cast<std::uint32_t>(GetParam()));
  const double focal = GetParam() * unit;
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    const FrameView view = view_with(GetParam(), projection);
    for (int round = 0; round < rounds(2000); ++round) {
      const std::int32_t radius = random.between(1, 32000);
      const std::vector<Vertex16> points = ball(random, radius);
      Mesh mesh;
      mesh.vertices = points;
      mesh.step_exponent = -13;
      mesh.bounds = {{}, static_cast<std::uint32_t>(radius)};
      Transform transform;
      // About where an edge of the picture is, as far as positions reach.
      const double z = std::exp2(random.between(-500, 1400) / 100.0);
      const double scale = projection == Projection::perspective ? z / focal : 1 / focal;
      const auto coordinate = [&](int half) {
        const double wanted = random.between(-1100, 1100) / 1000.0 * half * scale;
        return Q16_16::from_raw(static_cast<std::int32_t>(std::clamp(wanted, -32000.0, 32000.0) / unit));
      };
      transform.translation = {coordinate(width / 2), coordinate(height / 2),
                               Q16_16::from_raw(static_cast<std::int32_t>(-z / unit))};
      const InstanceGeometry instance(view, mesh, transform);
      std::vector<ScreenVertex> screen(points.size());
      instance.transform_vertices(screen.data());
      for (std::size_t i = 0; i < points.size(); ++i) {
        if (instance.placement() == Placement::inside) {
          ASSERT_TRUE(screen[i].x >= ScreenVertex::bias && screen[i].x <= ScreenVertex::bias + width * 16) << round;
          ASSERT_TRUE(screen[i].y >= ScreenVertex::bias && screen[i].y <= ScreenVertex::bias + height * 16) << round;
        }
        if (instance.placement() == Placement::outside) {
          const double depth = -(transform.translation.z.raw() * unit + points[i].z / 8192.0);
          const double size = projection == Projection::perspective ? focal / depth : focal;
          const double x = (transform.translation.x.raw() * unit + points[i].x / 8192.0) * size,
                       y = (transform.translation.y.raw() * unit + points[i].y / 8192.0) * size;
          const bool seen =
              depth > 1 / 60.0 && depth < 29999 && std::abs(x) < width / 2 - 0.1 && std::abs(y) < height / 2 - 0.1;
          ASSERT_FALSE(seen) << round << " " << x << " " << y << " " << depth;
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(FocalLengths, Placements,
                         ::testing::Values(1, 2, 4095, 4096, 7000, 65535, 500000, 1 << 24, 0x7fffffff));

}  // namespace
}  // namespace spanline::test
