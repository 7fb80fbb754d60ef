// Bodies of polygons that are one entry each, about the eye and before it, cut by planes above all.
#include <utility>

#include "generators.hpp"
#include "parts.hpp"
#include "sizes.hpp"
#include "support/polygon_bodies.hpp"
#include "support/random_instance.hpp"

namespace spanline::contract {
namespace {

Q16_16 any_number(Random& random, double low, double high) { return test::nearest<Q16_16>(random.real(low, high)); }

/// A prism of any size, lit and coloured in any way.
OwnedMesh any_prism(Random& random, int largest) {
  OwnedMesh mesh = test::prism(random.between(3, 8), random.between(600, largest), random.between(400, largest));
  if (random.chance(3)) mesh.polygon_normals.clear();
  if (random.chance(3)) {
    const bool one = random.chance(2);
    const Rgb888 all = any_colour(random);
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
      mesh.vertex_colours.push_back(one ? all : any_colour(random));
  } else if (random.chance(2)) {
    for (std::size_t i = 0; i < mesh.corners.size(); ++i) mesh.polygon_colours.push_back(any_colour(random));
  }
  if (!random.chance(8)) test::mark_planar(mesh);
  return mesh;
}

}  // namespace

Scene polygon_bodies(Random& random) {
  Scene scene = sized(random);
  look_from_four(scene);
  scene.settings.cull = any_cull(random);
  scene.settings.camera.near_plane = any_number(random, 0.05, random.chance(2) ? 0.3 : 4.2);
  if (random.chance(4)) scene.settings.camera.far_plane = any_number(random, 4.3, 6);
  if (random.chance(4)) {
    scene.settings.camera.projection = Projection::orthographic;
    scene.settings.camera.focal = Q16_16::from_ratio(scene.height, 3);
  }
  if (random.chance(2)) {  // a room about the eye
    OwnedMesh room = any_prism(random, 30000);
    test::turn_inside_out(room);
    Transform transform;
    transform.rotation = test::random_rotation(random);
    transform.translation = {any_number(random, -1, 1), any_number(random, -1, 1), any_number(random, 2, 5)};
    transform.scale = test::nearest<Fixed<24>>(random.real(0.5, 2));
    add_mesh(scene, std::move(room), transform, {any_colour(random), any_shading(random)});
  }
  const int count = random.between(1, 4);
  for (int i = 0; i < count; ++i) {
    Transform transform;
    transform.rotation = test::random_rotation(random);
    transform.translation = {any_number(random, -1.2, 1.2), any_number(random, -0.8, 0.8),
                             any_number(random, -1, random.chance(2) ? 1 : 5)};
    add_mesh(scene, any_prism(random, 9000), transform, {any_colour(random), any_shading(random)});
  }
  return scene;
}

}  // namespace spanline::contract
