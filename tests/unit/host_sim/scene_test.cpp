#include "scene/scene.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/core_mesh.hpp"
#include "scene/scene_bytes.hpp"
#include "scene/view.hpp"
#include "scene/world.hpp"
#include "spanline/model/validate.hpp"

namespace spanline::sim {
namespace {

/// Two triangles of a square in the plane z = 0, without shared vertices.
Scene loose_square() {
  Scene scene;
  scene.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, -0.0}, {1, 1, 0}, {0, 1, 0}};
  scene.triangles = {{0, 1, 2}, {3, 4, 5}};
  scene.polygon_normals = {{0, 0, 1}, {0, 0, 1}};
  return scene;
}

TEST(Weld, JoinsEqualVerticesInOrderOfFirstUse) {
  const Scene joined = welded(loose_square());
  EXPECT_EQ(joined.positions.size(), 4U);
  EXPECT_EQ(joined.triangles[0], (Scene::Triangle{0, 1, 2}));
  EXPECT_EQ(joined.triangles[1], (Scene::Triangle{0, 2, 3}));
}

TEST(Weld, KeepsAttributesThatDifferApart) {
  Scene scene = loose_square();
  scene.vertex_colours.assign(6, Rgb888{1, 2, 3});
  scene.vertex_colours[4] = {9, 9, 9};
  EXPECT_EQ(welded(scene).positions.size(), 5U);
}

TEST(VertexNormals, AreWeightedByArea) {
  Scene scene;
  scene.positions = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1}};
  scene.triangles = {{0, 1, 2}, {0, 3, 1}};
  scene.polygon_normals.resize(2);
  complete_vertex_normals(scene);
  // Twice the areas are 4 towards +z and 2 towards +y.
  EXPECT_NEAR(scene.vertex_normals[0].y, 2 / std::sqrt(20.0), 1e-12);
  EXPECT_NEAR(scene.vertex_normals[0].z, 4 / std::sqrt(20.0), 1e-12);
  EXPECT_EQ(scene.vertex_normals[2], (Vector3{0, 0, 1}));
}

TEST(SceneBytes, RoundTripAndRefusal) {
  Scene scene = welded(loose_square());
  scene.polygon_colours.assign(2, Rgb888{7, 8, 9});
  for (std::size_t i = 0; i < scene.positions.size(); ++i)
    scene.texture_points.push_back({static_cast<double>(i) / 4, -1});
  std::vector<std::byte> bytes = to_bytes(scene);
  const std::optional<Scene> copy = scene_from_bytes(bytes);
  ASSERT_TRUE(copy);
  EXPECT_EQ(copy->positions, scene.positions);
  EXPECT_EQ(copy->triangles, scene.triangles);
  EXPECT_EQ(copy->polygon_colours, scene.polygon_colours);
  EXPECT_EQ(copy->texture_points, scene.texture_points);
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(scene_from_bytes(std::span(bytes).first(size))) << size;
  scene.triangles[0][0] = 99;
  EXPECT_FALSE(scene_from_bytes(to_bytes(scene)));
}

TEST(CoreMeshes, SplitWithinLimitsInFileOrder) {
  Scene scene;
  constexpr std::uint32_t count = 50000;  // triangles with vertices of their own: 150,000 of them
  for (std::uint32_t i = 0; i < count; ++i) {
    const double x = i;
    for (const Vector3 corner : {Vector3{x, 0, 0}, Vector3{x, 1, 0}, Vector3{x, 0, 1}})
      scene.positions.push_back(corner);
    scene.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  scene.polygon_normals.resize(count);
  const View view = resolve_view({}, scene, Size{}, false);
  const World world = choose_world(view, scene, Size{});
  const std::vector<CoreMesh> meshes = to_core_meshes(scene, world);
  ASSERT_GE(meshes.size(), 3U);
  std::size_t triangle = 0;
  for (const CoreMesh& mesh : meshes) {
    EXPECT_TRUE(validate(mesh.view()).ok()) << to_string(validate(mesh.view()).fault);
    EXPECT_EQ(mesh.bounds.radius, meshes[0].bounds.radius);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3, ++triangle) {
      const double want = std::ldexp(world.to_world({static_cast<double>(triangle), 0, 0}).x, 16);
      ASSERT_NEAR(mesh.wide_vertices[mesh.indices[i]].x, want, 0.5);
    }
  }
  EXPECT_EQ(triangle, count);
}

/// A view's picture coordinates of a point, in half pictures: inside is (−1, 1).
Vector3 projected(const View& view, Size size, Vector3 point) {
  const Vector3 d = point - view.eye;
  const double depth = -dot(d, view.backwards);
  const double scale =
      view.orthographic ? 2 / view.ortho_height : 1 / (depth * std::tan(view.field_of_view * std::acos(-1.0) / 360));
  return {dot(d, view.right) * scale * size.height / size.width, dot(d, view.above) * scale, depth};
}

TEST(View, FramesTheWholeModel) {
  const Scene scene = welded(loose_square());
  for (const Size size : {Size{320, 240}, Size{100, 400}, Size{2047, 3}}) {
    for (const bool turns : {false, true}) {
      const View view = resolve_view({}, scene, size, turns);
      double greatest = 0;
      for (const Vector3 p : scene.positions) {
        const Vector3 q = projected(view, size, p);
        greatest = std::max({greatest, std::fabs(q.x), std::fabs(q.y)});
        EXPECT_GT(q.z, view.near_plane);
        EXPECT_LT(q.z, view.far_plane);
      }
      EXPECT_LT(greatest, 1);
      EXPECT_GT(greatest, turns ? 0.3 : 0.9);
    }
  }
}

TEST(View, PartialOptionsCombine) {
  const Scene scene = welded(loose_square());
  ViewRequest request;
  request.eye = Vector3{5, 6, 7};
  EXPECT_EQ(resolve_view(request, scene, {}, false).target, (Vector3{0.5, 0.5, 0}));
  request.eye.reset();
  request.target = Vector3{3, 0, 0};
  const View aimed = resolve_view(request, scene, {}, false);
  EXPECT_LT(std::fabs(projected(aimed, {}, {0, 1, 0}).x), 1);
  request.near_plane = 1000;
  EXPECT_GT(resolve_view(request, scene, {}, false).stated_far_plane, 1000);
}

TEST(View, LooksStraightDownWithoutBeingToldWhatIsUp) {
  ViewRequest request;
  request.eye = Vector3{0.5, 9, 0};
  const View view = resolve_view(request, welded(loose_square()), {}, false);
  EXPECT_NEAR(length(view.right), 1, 1e-12);
  EXPECT_NEAR(dot(view.above, {0, 0, -1}), 1, 1e-1);
}

TEST(View, TurningTheModelMovesTheEyeTheOtherWay) {
  View view;
  view.look_at({0, 0, 10}, {0, 0, 0}, {0, 1, 0});
  const View quarter = turned(view, 0.25);
  // The model has turned counter-clockwise seen from above: its −x side, seen from (−10, 0, 0), faces the eye.
  EXPECT_NEAR(quarter.eye.x, -10, 1e-9);
  EXPECT_NEAR(quarter.eye.z, 0, 1e-9);
}

}  // namespace
}  // namespace spanline::sim
