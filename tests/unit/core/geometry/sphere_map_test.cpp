// Texture coordinates of surfaces that show their surroundings, against OpenGL's formula in floating point.
#include <gtest/gtest.h>

#include <vector>

#include "spanline/geometry/texture_vertices.hpp"
#include "spanline/geometry/vertex_transform.hpp"
#include "support/effort.hpp"
#include "support/random_instance.hpp"

namespace spanline::test {
namespace {

TEST(SphereMap, CoordinatesFollowTheMirroredLineOfSight) {
  Random random(1);
  double worst = 0;
  for (int i = 0; i < rounds(4000); ++i) {
    RandomInstance instance(random, {.wide = random.chance(4), .orthographic = random.chance(3), .vertices = 9});
    std::vector<std::array<double, 3>> normals;
    for (int v = 0; v < 9; ++v) {
      double n[3], length = 0;
      for (double& c : n) {
        c = random.real(-1, 1);
        length += c * c;
      }
      if (length < 0.01) n[0] = length = 1;
      int packed[3];
      for (int k = 0; k < 3; ++k) packed[k] = static_cast<int>(std::lround(n[k] / std::sqrt(length) * 511));
      instance.owned.vertex_normals.emplace_back(packed[0], packed[1], packed[2]);
      normals.push_back({packed[0] / 511.0, packed[1] / 511.0, packed[2] / 511.0});
    }
    instance.mesh = instance.owned.view();
    const ViewTransform transform(instance.view, instance.mesh, instance.transform);
    const Nearness nearness(instance.view, transform);
    const Rotation rotation = instance.view.camera.axes * instance.transform.rotation;
    std::vector<TextureVertex> got(9);
    make_sphere_map_vertices(transform, rotation, instance.view.camera.projection, nearness, instance.mesh, {},
                             got.data());
    for (std::size_t v = 0; v < 9; ++v) {
      const ViewPoint p = view_point(transform, instance.mesh, v);
      double u[3] = {double(p.x), double(p.y), -double(p.z)};
      if (instance.view.camera.projection == Projection::orthographic) u[0] = u[1] = 0, u[2] = -1;
      const double distance = std::sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
      double n[3], along = 0;
      for (int k = 0; k < 3; ++k) {
        const Direction& row = rotation.row[k];
        n[k] = (row.x.raw() * normals[v][0] + row.y.raw() * normals[v][1] + row.z.raw() * normals[v][2]) * 0x1p-30;
        u[k] /= distance;
        along += n[k] * u[k];
      }
      const double r[3] = {u[0] - 2 * along * n[0], u[1] - 2 * along * n[1], u[2] - 2 * along * n[2]};
      const double m = 2 * std::sqrt(r[0] * r[0] + r[1] * r[1] + (r[2] + 1) * (r[2] + 1));
      if (m < 0.01) continue;  // behind the sphere: any point of its rim
      const double off = std::max(std::abs(std::ldexp(got[v].s, -20) - (r[0] / m + 0.5)),
                                  std::abs(std::ldexp(got[v].t, -20) - (0.5 - r[1] / m)));
      worst = std::max(worst, off);
      ASSERT_LE(off, 0x1p-13) << "round " << i;
    }
  }
  std::printf("sphere map: off by at most 1/%.0f of the texture\n", 1 / worst);
}

}  // namespace
}  // namespace spanline::test
