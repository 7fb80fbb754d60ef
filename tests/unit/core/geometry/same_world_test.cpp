// Different ways to say the same world draw the same bytes: n-gons and their fans, step exponents and scales, units.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <spanline/frame/ready_made_traits.hpp>
#include <spanline/model/cull.hpp>

#include <vector>

#include "scenes/prisms_mesh.hpp"
#include "support/effort.hpp"
#include "support/random_instance.hpp"
#include "support/ready_made_studios.hpp"

namespace spanline::test {
namespace {

using Colours = GouraudTraits<Rgb565, Depth24<>>;

template <class Traits>
Picture<Traits> draw(const FrameView& view, const Mesh& mesh, const Transform& transform,
                     ShadingMode shading = ShadingMode::flat) {
  Studio<Traits> studio(
      mesh_capacity(view.viewport.width, view.viewport.height, 1, mesh.vertex_count(), mesh.triangle_count()));
  FrameSettings settings;
  settings.camera = view.camera;
  settings.cull = Cull::none;
  studio.begin(settings);
  studio.add(mesh, transform, {{200, 90, 40}, shading});
  auto picture = studio.draw();
  EXPECT_TRUE(studio.status().ok());
  return picture;
}

RandomInstance random_instance(std::uint32_t seed) {
  Random random(seed);
  return {random,
          {.orthographic = random.chance(3),
           .closest = 0.7,
           .farthest = 8,
           .aside = 1.5,
           .range_around = random.chance(2),
           .vertices = 24}};
}

TEST(SameWorld, PolygonsEqualTheFansOfTheirTriangles) {
  const Mesh& polygons = scenes::prisms;
  OwnedMesh fans;
  fans.vertices.assign(polygons.vertices.begin(), polygons.vertices.end());
  fans.offset = polygons.offset;
  fans.step_exponent = polygons.step_exponent;
  fans.bounds = polygons.bounds;
  std::size_t first = 0;
  for (std::size_t p = 0; p < polygons.corners.size(); ++p) {
    for (std::size_t i = 1; i + 1 < polygons.corners[p]; ++i) {
      fans.triangle(polygons.indices[first], polygons.indices[first + i], polygons.indices[first + i + 1]);
      if (!polygons.polygon_normals.empty()) fans.polygon_normals.push_back(polygons.polygon_normals[p]);
      if (!polygons.polygon_colours.empty()) fans.polygon_colours.push_back(polygons.polygon_colours[p]);
    }
    first += polygons.corners[p];
  }
  Random random(1);
  for (int i = 0; i < rounds(200); ++i) {
    FrameView view;
    view.viewport = {160, 120};
    view.camera.focal = Q16_16::from_int(random.between(60, 400));
    view.camera.projection = random.chance(4) ? Projection::orthographic : Projection::perspective;
    view.camera.near_plane = nearest<Q16_16>(random.real(0.1, 3.5));
    Transform transform;
    transform.rotation = random_rotation(random);
    transform.translation = {nearest<Q16_16>(random.real(-2, 2)), nearest<Q16_16>(random.real(-2, 2)),
                             nearest<Q16_16>(random.real(-6, -1))};
    ASSERT_TRUE(draw<Colours>(view, polygons, transform) == draw<Colours>(view, fans.view(), transform)) << i;
    ASSERT_TRUE(draw<Ids>(view, polygons, transform) == draw<Ids>(view, fans.view(), transform)) << i;
  }
}

RC_GTEST_PROP(SameWorld, AStepTwiceAsLongAtHalfTheScaleIsTheSame, (std::uint32_t seed)) {
  RandomInstance r = random_instance(seed);
  const int by = *rc::gen::inRange(1, 4);
  RC_PRE(r.owned.step_exponent + by <= 14);
  // Low bits that the shift would lose are cleared first.
  r.transform.scale = Fixed<24>::from_raw((r.transform.scale.raw() >> by << by) + (1 << by));
  const auto before = draw<Colours>(r.view, r.mesh, r.transform);
  r.owned.step_exponent = static_cast<std::int8_t>(r.owned.step_exponent + by);
  r.transform.scale = Fixed<24>::from_raw(r.transform.scale.raw() >> by);
  RC_ASSERT(before == draw<Colours>(r.view, r.owned.view(), r.transform));
}

RC_GTEST_PROP(SameWorld, UnitsTwiceAsLongEverywhereAreTheSame, (std::uint32_t seed)) {
  RandomInstance r = random_instance(seed);
  if (r.view.camera.projection == Projection::orthographic)
    r.view.camera.focal = Q16_16::from_raw((r.view.camera.focal.raw() >> 1 << 1) + 2);
  const auto halved = [](Q16_16& q) { q = Q16_16::from_raw(q.raw() / 2); };
  const auto doubled = [](Q16_16& q) { q = q + q; };
  RC_PRE(r.owned.step_exponent < 14);
  const auto lengths = {&r.view.camera.eye.x,       &r.view.camera.eye.y,      &r.view.camera.eye.z,
                        &r.view.camera.near_plane,  &r.view.camera.far_plane,  &r.transform.translation.x,
                        &r.transform.translation.y, &r.transform.translation.z};
  for (Q16_16* length : lengths) RC_PRE(std::abs(static_cast<std::int64_t>(length->raw())) < (1 << 30));
  const auto before = draw<Colours>(r.view, r.mesh, r.transform);
  for (Q16_16* length : lengths) doubled(*length);
  if (r.view.camera.projection == Projection::orthographic) halved(r.view.camera.focal);
  r.owned.step_exponent = static_cast<std::int8_t>(r.owned.step_exponent + 1);
  RC_ASSERT(before == draw<Colours>(r.view, r.owned.view(), r.transform));
}

RC_GTEST_PROP(SameWorld, ANormalVertexTableInItsWideFormDrawsNearlyTheSame, (std::uint32_t seed)) {
  const RandomInstance r = random_instance(seed);
  OwnedMesh wide = r.owned;
  wide.vertices.clear();
  for (const Vertex16& v : r.owned.vertices) wide.wide_vertices.push_back({v.x, v.y, v.z});
  const auto a = draw<Ids>(r.view, r.mesh, r.transform), b = draw<Ids>(r.view, wide.view(), r.transform);
  // The fast way rounds otherwise: edges may move by a sixteenth or two.
  std::size_t different = 0;
  for (std::size_t p = 0; p < a.pixels.size(); ++p) different += a.pixels[p] != b.pixels[p] ? 1U : 0U;
  RC_ASSERT(different <= a.pixels.size() / 50);
}

RC_GTEST_PROP(SameWorld, AnOffsetIsTheSameAsMovedVertices, (std::uint32_t seed)) {
  const RandomInstance r = random_instance(seed);
  OwnedMesh moved;
  for (const Vertex16& v : r.owned.vertices)
    moved.wide_vertices.push_back({v.x + r.owned.offset.x, v.y + r.owned.offset.y, v.z + r.owned.offset.z});
  moved.indices = r.owned.indices;
  moved.step_exponent = r.owned.step_exponent;
  moved.fit_bounds();
  OwnedMesh still = r.owned;
  still.vertices.clear();
  for (const Vertex16& v : r.owned.vertices) still.wide_vertices.push_back({v.x, v.y, v.z});
  const auto a = draw<Ids>(r.view, still.view(), r.transform), b = draw<Ids>(r.view, moved.view(), r.transform);
  std::size_t different = 0;
  for (std::size_t p = 0; p < a.pixels.size(); ++p) different += a.pixels[p] != b.pixels[p] ? 1U : 0U;
  RC_ASSERT(different <= a.pixels.size() / 200);
}

}  // namespace
}  // namespace spanline::test
