// Marked polygons are one entry each, and show what their fans show: the same pixels with the same ids, at depths that
// differ by no more than snapping and half a step of the model allow. All algorithms draw the same bytes of them.
#include <gtest/gtest.h>
#include <spanline/frame/ready_made_traits.hpp>
#include <spanline/model/planarity.hpp>
#include <spanline/model/validate.hpp>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "scenes/prisms_mesh.hpp"
#include "scenes/room_mesh.hpp"
#include "support/effort.hpp"
#include "support/owned_mesh.hpp"
#include "support/random.hpp"
#include "support/random_instance.hpp"
#include "support/ready_made_studios.hpp"

namespace spanline::test {
namespace {

template <class T, std::size_t size>
std::vector<T> copied(const std::array<T, size>& table) {
  return {table.begin(), table.end()};
}

OwnedMesh prisms() {
  OwnedMesh mesh;
  mesh.vertices = copied(scenes::prisms_tables.vertices);
  mesh.indices = copied(scenes::prisms_tables.indices);
  mesh.corners = copied(scenes::prisms_tables.corners);
  mesh.polygon_normals = copied(scenes::prisms_tables.normals);
  mesh.polygon_colours = copied(scenes::prisms_tables.colours);
  mesh.step_exponent = scenes::prisms.step_exponent;
  mesh.bounds = scenes::prisms.bounds;
  return mesh;
}

OwnedMesh marked(OwnedMesh mesh) {
  const Mesh view = mesh.view();
  for (std::size_t i = 0; i < mesh.corners.size(); ++i)
    if (planarity_of(view, i, view.first_corner(i)) == Planarity::planar) mesh.corners[i] |= Mesh::planar;
  return mesh;
}

/// A picture of the prisms from anywhere, also from among them.
struct AnyView {
  Transform transform;
  FrameSettings settings;
  Capacity capacity;

  explicit AnyView(Random& random) {
    transform.rotation = random_rotation(random);
    const double distance = random.real(0.3, 9);
    transform.translation = {nearest<Q16_16>(random.real(-1, 1)), nearest<Q16_16>(random.real(-1, 1)),
                             nearest<Q16_16>(-distance)};
    capacity = mesh_capacity(random.between(40, 320), random.between(30, 240), 1, 66, 96);
    capacity.awake = capacity.active = 400;
    settings.cull = random.between(0, 2) == 0 ? Cull::none : Cull::back;
    Camera& camera = settings.camera;
    camera.projection = random.between(0, 3) == 0 ? Projection::orthographic : Projection::perspective;
    const double size = std::exp2(random.real(4, 9));
    camera.focal = nearest<Q16_16>(camera.projection == Projection::perspective ? size : size / 3);
    camera.near_plane = nearest<Q16_16>(random.real(0.05, 0.5));
    camera.far_plane = nearest<Q16_16>(random.real(6, 40));
  }

  template <class Traits>
  Picture<Traits> draw(const OwnedMesh& mesh, int lines, PolygonCounts* counts = nullptr) const {
    Capacity own = capacity;
    own.band_lines = static_cast<std::uint16_t>(std::min<int>(lines, own.height));
    const Mesh view = mesh.view();
    Studio<Traits> studio(own);
    studio.begin(settings);
    studio.add(view, transform, {});
    auto picture = studio.draw();
    EXPECT_TRUE(studio.status().ok()) << to_string(studio.status().fault) << to_string(studio.status().pool);
    if (counts != nullptr) *counts = studio.statistics().polygons;
    return picture;
  }
};

template <class Depth>
class PlanarPolygons : public ::testing::Test {};
using Depths = ::testing::Types<Depth16<>, Depth24<>, Depth24<DepthSense::larger_is_nearer>>;
TYPED_TEST_SUITE(PlanarPolygons, Depths);

TYPED_TEST(PlanarPolygons, ShowWhatTheirFansShow) {
  using Depth = TypeParam;
  using Traits = IdTraits<Depth, Counted>;
  const OwnedMesh fans = prisms(), whole = marked(prisms());
  ASSERT_TRUE(validate(whole.view()).ok());
  Random random(160);
  PolygonCounts sum;
  long pixels = 0, other = 0, uncovered = 0, other_triangles = 0;
  std::int64_t farthest = 0;
  for (int round = 0; round < rounds(480); ++round) {
    const AnyView view(random);
    PolygonCounts of_whole, of_fans;
    const auto a = view.draw<Traits>(whole, 4096, &of_whole);
    const auto b = view.draw<Traits>(fans, 4096, &of_fans);
    ASSERT_EQ(of_whole.total, of_fans.total);
    ASSERT_EQ(of_fans.whole, 0U);
    sum.whole += of_whole.whole;
    sum.total += of_whole.total;
    other_triangles += a.covered == b.covered ? 0 : 1;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
      if ((a.depth[i] == Depth::clear) != (b.depth[i] == Depth::clear)) ++uncovered;
      if (a.depth[i] == Depth::clear || b.depth[i] == Depth::clear) continue;
      ++pixels;
      other += a.pixels[i] != b.pixels[i] ? 1 : 0;
      if (a.pixels[i] == b.pixels[i])
        farthest = std::max(
            farthest, std::abs(std::int64_t{Depth::integer(a.depth[i])} - std::int64_t{Depth::integer(b.depth[i])}));
    }
  }
  EXPECT_GT(sum.whole, 0U);
  EXPECT_GT(pixels, 0);
  std::printf(
      "%u whole of %u triangles, %ld of %ld pixels show another triangle, %ld covered differently, %ld views with "
      "other triangles, depths differ by %lld\n",
      sum.whole, sum.total, other, pixels, uncovered, other_triangles, static_cast<long long>(farthest));
}

TYPED_TEST(PlanarPolygons, AreTheSameBytesByAllAlgorithms) {
  using Depth = TypeParam;
  const OwnedMesh whole = marked(prisms());
  Random random(161);
  for (int round = 0; round < rounds(160); ++round) {
    const AnyView view(random);
    const auto ids = view.draw<IdTraits<Depth, Counted>>(whole, 4096);
    const auto colours = view.draw<GouraudTraits<Rgb565, Depth>>(whole, 4096);
    for (const int lines : {1, 7, 40}) {
      ASSERT_TRUE((view.draw<IdTraits<Depth, Counted>>(whole, lines)) == ids)
          << "round " << round << " lines " << lines;
      ASSERT_TRUE((view.draw<GouraudTraits<Rgb565, Depth>>(whole, lines)) == colours) << "round " << round;
    }
    const auto bounded = view.draw<IdTraits<Depth, Counted, BoundedZBuffer>>(whole, 40);
    ASSERT_EQ(bounded.pixels, ids.pixels) << "round " << round;
    ASSERT_EQ(bounded.depth, ids.depth) << "round " << round;
    ASSERT_EQ((view.draw<IdTraits<Depth, Counted, Deferred<4>>>(whole, 16).pixels), ids.pixels) << "round " << round;
    ASSERT_EQ((view.draw<GouraudTraits<Rgb565, Depth, Deferred<>>>(whole, 16).pixels), colours.pixels);
    if constexpr (Depth::bits == 24) {
      const auto by_spans = view.draw<IdTraits<Depth, Counted, Spanning>>(whole, 16);
      ASSERT_EQ(by_spans.pixels, ids.pixels) << "round " << round;
      ASSERT_EQ(by_spans.depth, ids.depth) << "round " << round;
      ASSERT_EQ(by_spans.covered, ids.covered) << "round " << round;
      ASSERT_EQ((view.draw<GouraudTraits<Rgb565, Depth, Spanning>>(whole, 1).pixels), colours.pixels);
    }
  }
}

/// A room seen from within, the eye turned 20 ways: nearly all quads that show are one entry each, those that planes
/// clip among them.
TEST(PlanarRoom, IsOfWholeQuads) {
  ASSERT_TRUE(validate(scenes::room).ok());
  using Traits = TextureTraits<Rgb565, Depth24<>, Spanning>;
  std::uint32_t whole = 0, quads = 0;
  for (int turn = 0; turn < 20; ++turn) {
    Studio<Traits> studio({.vertices = 500, .textures = 500, .polygons = 300, .fans = 400, .awake = 100});
    studio.begin(scenes::room_settings(Angle::from_degrees(18 * turn), 240));
    studio.add(scenes::room, {}, scenes::room_material);
    const auto by_spans = studio.draw();
    ASSERT_TRUE(studio.status().ok()) << to_string(studio.status().pool);
    const PolygonCounts counts = studio.statistics().polygons;
    // Each quad that shows is one entry, or two triangles.
    const std::uint32_t triangles = counts.total - counts.outside - counts.back;
    whole += counts.whole;
    quads += counts.whole + (triangles - 2 * counts.whole + 1) / 2;
    Studio<TextureTraits<Rgb565, Depth24<>>> same(
        {.band_lines = 17, .vertices = 500, .textures = 500, .polygons = 300, .fans = 400, .active = 100});
    same.begin(scenes::room_settings(Angle::from_degrees(18 * turn), 240));
    same.add(scenes::room, {}, scenes::room_material);
    ASSERT_EQ(same.draw().pixels, by_spans.pixels) << "turn " << turn;
  }
  EXPECT_GE(whole * 100, quads * 95) << whole << " of " << quads;
  EXPECT_GT(quads, 200U);
}

}  // namespace
}  // namespace spanline::test
