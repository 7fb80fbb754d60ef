#include "parts.hpp"
#include <spanline/model/cull.hpp>

#include <cmath>
#include <numbers>
#include <utility>

namespace spanline::contract {

ShadingMode any_shading(test::Random& random) { return random.chance(2) ? ShadingMode::flat : ShadingMode::gouraud; }
Cull any_cull(test::Random& random) {
  constexpr Cull culls[] = {Cull::back, Cull::front, Cull::none};
  return culls[random.between(0, 2)];
}
Angle any_angle(test::Random& random) {
  return Angle::from_raw(static_cast<std::uint32_t>(random.wide(0, 0xffffffff)));
}
Rgb888 any_colour(test::Random& random) {
  const auto channel = [&] { return static_cast<std::uint8_t>(random.between(0, 255)); };
  return {channel(), channel(), channel()};
}

OwnedMesh sphere(int radius, int rings, int sides) {
  OwnedMesh mesh;
  for (int i = 0; i <= rings; ++i)
    for (int j = 0; j < sides; ++j) {
      const double down = std::numbers::pi * i / rings, around = 2 * std::numbers::pi * j / sides;
      const double p[3] = {std::sin(down) * std::cos(around), std::cos(down), std::sin(down) * std::sin(around)};
      const auto coordinate = [&](int k) { return static_cast<std::int16_t>(std::lround(p[k] * radius)); };
      const auto normal = [&](int k) { return static_cast<int>(std::lround(p[k] * 511)); };
      mesh.vertices.push_back({coordinate(0), coordinate(1), coordinate(2)});
      mesh.vertex_normals.emplace_back(normal(0), normal(1), normal(2));
    }
  const auto at = [&](int i, int j) { return static_cast<std::size_t>(i * sides + j % sides); };
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < sides; ++j) {
      mesh.triangle(at(i, j), at(i, j + 1), at(i + 1, j + 1));
      mesh.triangle(at(i, j), at(i + 1, j + 1), at(i + 1, j));
    }
  mesh.fit_bounds();
  return mesh;
}

void look_from_four(Scene& scene) {
  scene.settings.camera.eye = {{}, {}, 4.0_q16};
  scene.settings.camera.focal = Q16_16::from_ratio(std::int64_t{5} * scene.height, 4);
  scene.settings.camera.near_plane = 0.5_q16;
  scene.settings.camera.far_plane = 16.0_q16;
  scene.settings.lighting = {Fixed<16>::from_ratio(2, 10), light};
}

void add_mesh(Scene& scene, OwnedMesh mesh, const Transform& transform, const Material& material) {
  scene.owned.push_back(std::move(mesh));
  scene.meshes.push_back(scene.owned.back().view());
  scene.parts.push_back({&scene.meshes.back(), transform, material});
}

}  // namespace spanline::contract
