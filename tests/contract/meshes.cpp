// Meshes before a camera: models, terrain, closed bodies inside or through one another, and what planes clip.
#include <bunny.hpp>
#include <cmath>
#include <numbers>
#include <teapot.hpp>
#include <utility>

#include "generators.hpp"
#include "scenes/model_view.hpp"
#include "scenes/terrain_mesh.hpp"
#include "scenes/torus_mesh.hpp"
#include "sizes.hpp"
#include "support/random_instance.hpp"

namespace spanline::contract {
namespace {

using namespace spanline::literals;

constexpr std::array<DirectionalLight, 1> light{{{{0.4243_q30, 0.5657_q30, 0.7071_q30}, Fixed<16>::from_ratio(8, 10)}}};

ShadingMode any_shading(Random& random) { return random.chance(2) ? ShadingMode::flat : ShadingMode::gouraud; }
Cull any_cull(Random& random) {
  constexpr Cull culls[] = {Cull::back, Cull::front, Cull::none};
  return culls[random.between(0, 2)];
}
Angle any_angle(Random& random) { return Angle::from_raw(static_cast<std::uint32_t>(random.wide(0, 0xffffffff))); }
Rgb888 any_colour(Random& random) {
  const auto channel = [&] { return static_cast<std::uint8_t>(random.between(0, 255)); };
  return {channel(), channel(), channel()};
}

/// A model in any pose, in front of which the near plane may lie.
Scene posed(Random& random, const Mesh& mesh) {
  Scene scene = random.chance(2) ? Scene(160, 120) : Scene(320, 240);
  const auto view = scenes::model_view(mesh, any_angle(random), scene.height, any_shading(random));
  scene.settings = view.settings;
  scene.settings.cull = any_cull(random);
  if (random.chance(3)) scene.settings.camera.near_plane = test::nearest<Q16_16>(random.real(2.6, 4.4));
  Transform transform = view.transform;
  if (random.chance(2)) {  // so near that it leaves the picture
    transform.translation.z = transform.translation.z + test::nearest<Q16_16>(random.real(0.5, 2.5));
    transform.translation.x = transform.translation.x + test::nearest<Q16_16>(random.real(-1, 1));
  }
  scene.parts.push_back({&mesh, transform, view.material});
  return scene;
}

/// A sphere of triangles about the origin; normals point outwards. `radius` in steps of 2^-13.
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

}  // namespace

Scene bunny(Random& random) { return posed(random, spanline_models::bunny); }
Scene teapot(Random& random) { return posed(random, spanline_models::teapot); }

/// Over the hills, some of which lie behind the eye.
Scene terrain(Random& random) {
  Scene scene = sized(random);
  look_from_four(scene);
  const auto coordinate = [&](double low, double high) { return test::nearest<Q16_16>(random.real(low, high)); };
  scene.settings.camera.look_at({coordinate(-600, 600), coordinate(150, 700), coordinate(300, 1200)},
                                {coordinate(-300, 300), {}, coordinate(-400, 0)}, {{}, 1.0_q30, {}});
  scene.settings.camera.near_plane = test::nearest<Q16_16>(random.real(2, 300));
  scene.settings.camera.far_plane = test::nearest<Q16_16>(random.real(1000, 3000));
  scene.settings.cull = any_cull(random);
  Transform transform;
  transform.translation = {-4096.0_q16, {}, {}};
  scene.parts.push_back({&scenes::terrain, transform, {}});
  return scene;
}

/// Spheres about one another, open in front where the near plane cuts them, in any order of submission.
Scene nested_spheres(Random& random) {
  Scene scene = sized(random);
  look_from_four(scene);
  scene.settings.cull = any_cull(random);
  scene.settings.camera.near_plane = test::nearest<Q16_16>(random.chance(2) ? 0.5 : random.real(2.8, 4.2));
  const int count = random.between(2, 5);
  for (int i = 0; i < count; ++i) {
    Transform transform;
    transform.rotation = test::random_rotation(random);
    transform.translation = {
        test::nearest<Q16_16>(random.real(-0.1, 0.1)), test::nearest<Q16_16>(random.real(-0.1, 0.1)), {}};
    const int radius = random.between(2000, 10000);
    add_mesh(scene, sphere(radius, random.between(3, 9), random.between(3, 14)), transform,
             {any_colour(random), any_shading(random)});
  }
  return scene;
}

/// Two or three tori through one another, and triangles given on screen before them.
Scene crossing_tori(Random& random) {
  Scene scene = sized(random);
  look_from_four(scene);
  scene.settings.cull = any_cull(random);
  if (random.chance(3)) {
    scene.settings.camera.projection = Projection::orthographic;
    scene.settings.camera.focal = Q16_16::from_ratio(scene.height, 3);
  }
  const int count = random.between(2, 3);
  for (int i = 0; i < count; ++i) {
    Transform transform;
    transform.rotation = test::random_rotation(random);
    transform.translation = {test::nearest<Q16_16>(random.real(-0.8, 0.8)),
                             test::nearest<Q16_16>(random.real(-0.5, 0.5)),
                             test::nearest<Q16_16>(random.real(-0.5, 0.5))};
    const bool coloured = random.chance(2);
    scene.parts.push_back({coloured ? &scenes::coloured_torus : &scenes::torus,
                           transform,
                           {any_colour(random), coloured ? ShadingMode::gouraud : any_shading(random)}});
  }
  if (random.chance(2)) scene.triangles = penetrating_soup(random).triangles;
  return scene;
}

/// Random triangles in space, about the eye or cut by both planes, coloured at their corners.
Scene clipped_soup(Random& random) {
  test::RandomInstance instance(random, {.wide = random.chance(2),
                                         .orthographic = random.chance(4),
                                         .closest = random.chance(2) ? 0.2 : 1.05,
                                         .farthest = 3,
                                         .aside = 0.2,
                                         .range_around = random.chance(2),
                                         .vertices = 90});
  Scene scene(std::min(instance.view.viewport.width, 400), std::min(instance.view.viewport.height, 300));
  scene.settings.camera = instance.view.camera;
  scene.settings.lighting = {Fixed<16>::from_ratio(2, 10), light};
  for (std::size_t i = 0; i < instance.mesh.vertex_count(); ++i)
    instance.owned.vertex_colours.push_back(any_colour(random));
  const Transform transform = instance.transform;
  add_mesh(scene, std::move(instance.owned), transform, {any_colour(random), ShadingMode::gouraud});
  return scene;
}

}  // namespace spanline::contract
