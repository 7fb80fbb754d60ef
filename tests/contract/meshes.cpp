// Meshes before a camera: models, terrain, closed bodies inside or through one another, and what planes clip.
#include <bunny.hpp>
#include <teapot.hpp>
#include <utility>

#include "generators.hpp"
#include "parts.hpp"
#include "scenes/model_view.hpp"
#include "scenes/terrain_mesh.hpp"
#include "scenes/torus_mesh.hpp"
#include "sizes.hpp"
#include "support/random_instance.hpp"

namespace spanline::contract {
namespace {

using namespace spanline::literals;

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
