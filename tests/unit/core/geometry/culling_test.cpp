// Culling leaves out nothing that shows: bounding spheres against the frustum, orientation, and the counts of the sets.
#include "spanline/geometry/polygon_assembly.hpp"
#include "spanline/model/cull.hpp"
#include "spanline/raster/band_of_row.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/effort.hpp"
#include "support/exact_view.hpp"
#include "support/random_instance.hpp"
#include "support/ready_made_studios.hpp"

namespace spanline::test {
namespace {

struct Drawn {
  Picture<Ids> picture;
  Statistics statistics;
};

Drawn draw(const FrameView& view, const std::vector<Mesh>& meshes, const Transform& transform, Cull cull) {
  std::size_t vertices = 0, triangles = 0;
  for (const Mesh& mesh : meshes) {
    vertices += mesh.vertex_count();
    triangles += mesh.triangle_count();
  }
  Studio<Ids> studio(mesh_capacity(view.viewport.width, view.viewport.height, meshes.size(), vertices, triangles));
  FrameSettings settings;
  settings.camera = view.camera;
  settings.cull = cull;
  studio.begin(settings);
  for (const Mesh& mesh : meshes) studio.add(mesh, transform, {});
  Drawn drawn{studio.draw(), studio.statistics()};
  EXPECT_TRUE(studio.status().ok()) << to_string(studio.status().fault) << " " << to_string(studio.status().pool);
  return drawn;
}

RandomInstance::Wish anywhere(Random& random) {
  return {.wide = random.chance(3),
          .orthographic = random.chance(3),
          .closest = 0.1,
          .farthest = 20,
          .aside = random.real(0, 5),
          .range_around = random.chance(2),
          .vertices = 18,
          .depth_bits = 16};
}

/// Pixels at which two id pictures differ although no other id is next to them in either: more than a matter of
/// rounding.
std::size_t real_differences(const Picture<Ids>& a, const Picture<Ids>& b) {
  std::size_t found = 0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      if (a.pixels[a.at(x, y)] == b.pixels[b.at(x, y)]) continue;
      bool edge = false;
      for (const Picture<Ids>* p : {&a, &b})
        for (int ny = std::max(0, y - 1); ny <= std::min(a.height - 1, y + 1); ++ny)
          for (int nx = std::max(0, x - 1); nx <= std::min(a.width - 1, x + 1); ++nx)
            edge |= p->pixels[p->at(nx, ny)] != p->pixels[p->at(x, y)];
      found += edge ? 0U : 1U;
    }
  return found;
}

TEST(FrustumCulling, AnInstanceThatIsLeftOutShowsNothingWithAnySphere) {
  Random random(1);
  int left_out = 0;
  for (int i = 0; i < rounds(2400); ++i) {
    RandomInstance r(random, anywhere(random));
    if (draw(r.view, {r.mesh}, r.transform, Cull::none).statistics.polygons.outside != r.mesh.triangle_count())
      continue;
    ++left_out;
    // A sphere that holds the eye as well is never outside.
    OwnedMesh large = r.owned;
    large.bounds.radius = static_cast<std::uint32_t>(std::min(2147483647.0, large.bounds.radius * 60.0));
    const auto whole = draw(r.view, {large.view()}, r.transform, Cull::none);
    ASSERT_EQ(whole.picture.drawn_count(), 0U) << "round " << i;
  }
  EXPECT_GT(left_out, rounds(2400) / 10);
  std::printf("%d of %d instances were left out\n", left_out, rounds(2400));
}

TEST(FrustumCulling, PicturesAreThoseOfTheMeshSplitIntoSingleTriangles) {
  Random random(2);
  for (int i = 0; i < rounds(500); ++i) {
    const RandomInstance r(random, anywhere(random));
    std::vector<OwnedMesh> parts;
    for (std::size_t k = 0; k < r.mesh.indices.size(); k += 3) {
      OwnedMesh part;
      for (std::size_t c = 0; c < 3; ++c) {
        if (r.mesh.vertices.empty())
          part.wide_vertices.push_back(r.mesh.wide_vertices[r.mesh.indices[k + c]]);
        else
          part.vertices.push_back(r.mesh.vertices[r.mesh.indices[k + c]]);
      }
      part.triangle(0, 1, 2);
      part.offset = r.owned.offset;
      part.step_exponent = r.owned.step_exponent;
      part.fit_bounds();
      parts.push_back(std::move(part));
    }
    std::vector<Mesh> meshes;
    for (const OwnedMesh& part : parts) meshes.push_back(part.view());
    const auto one = draw(r.view, {r.mesh}, r.transform, Cull::none);
    const auto many = draw(r.view, meshes, r.transform, Cull::none);
    // Single triangles have exponents of their own, so corners may fall on the next sixteenth of a pixel.
    ASSERT_EQ(real_differences(one.picture, many.picture), 0U) << "round " << i;
  }
}

TEST(FrustumCulling, WhatIsFarOutsideIsLeftOut) {
  // Not only conservative: a sphere clear of the frustum on one side is refused.
  const OwnedMesh owned = tetrahedron();
  FrameView view;
  view.viewport = {320, 240};
  const double across = 0.5 * 320 / 240;  // half the width of the view at distance 1, focal 240
  for (const double side : {-1.0, 1.0})
    for (double distance = 3; distance < 80; distance *= 1.7) {
      Transform transform;
      const double reach = 1.8 / std::cos(std::atan(across));
      transform.translation = {nearest<Q16_16>(side * (across * distance + reach)), {}, nearest<Q16_16>(-distance)};
      EXPECT_EQ(draw(view, {owned.view()}, transform, Cull::none).statistics.polygons.outside, 4U) << side * distance;
    }
}

TEST(FaceCulling, FrontAndBackShareOutWhatIsInside) {
  Random random(3);
  for (int i = 0; i < rounds(500); ++i) {
    const RandomInstance r(random, anywhere(random));
    const auto both = draw(r.view, {r.mesh}, r.transform, Cull::none);
    const auto front = draw(r.view, {r.mesh}, r.transform, Cull::back);
    const auto back = draw(r.view, {r.mesh}, r.transform, Cull::front);
    const PolygonCounts &n = both.statistics.polygons, &f = front.statistics.polygons, &b = back.statistics.polygons;
    ASSERT_EQ(n.total, r.mesh.triangle_count());
    ASSERT_TRUE(f.total == n.total && b.total == n.total);
    ASSERT_TRUE(f.outside == n.outside && b.outside == n.outside);
    ASSERT_EQ(n.back, 0U);
    ASSERT_LE(f.back + b.back, n.total - n.outside);
    // V = ((P \\ F) \\ B) \\ O: whatever is seen was counted neither outside nor back.
    ASSERT_LE(front.picture.covered.size(), n.total - n.outside - f.back);
    ASSERT_LE(back.picture.covered.size(), n.total - n.outside - b.back);
    // Pieces of one clipped triangle may turn over in rounding, so that a triangle is in both sets.
    auto either = front.picture.covered;
    either.insert(back.picture.covered.begin(), back.picture.covered.end());
    ASSERT_EQ(either, both.picture.covered) << "round " << i;
    ASSERT_EQ(front.statistics.visibility.depth_tests + back.statistics.visibility.depth_tests,
              both.statistics.visibility.depth_tests);
  }
}

TEST(FaceCulling, CounterClockwiseFacesAreTheFront) {
  OwnedMesh owned;
  owned.vertices = {{-8192, -8192, 0}, {8192, -8192, 0}, {0, 8192, 0}};
  owned.triangle(0, 1, 2);
  owned.fit_bounds();
  Transform transform;
  transform.translation.z = Q16_16::from_int(-4);
  FrameView view;
  view.viewport = {64, 64};
  view.camera.focal = Q16_16::from_int(64);
  EXPECT_GT(draw(view, {owned.view()}, transform, Cull::back).picture.drawn_count(), 0U);
  EXPECT_EQ(draw(view, {owned.view()}, transform, Cull::front).picture.drawn_count(), 0U);
  // Seen from behind.
  view.camera.look_at({{}, {}, Q16_16::from_int(-8)}, {{}, {}, Q16_16::from_int(-4)}, {{}, Q2_30::from_int(1), {}});
  EXPECT_EQ(draw(view, {owned.view()}, transform, Cull::back).picture.drawn_count(), 0U);
  EXPECT_GT(draw(view, {owned.view()}, transform, Cull::front).picture.drawn_count(), 0U);
}

TEST(BandOfRow, IsTheQuotientForEveryHeightAndRow) {
  for (std::uint32_t lines = 1; lines <= 2047; ++lines) {
    const BandOfRow band_of_row(lines);
    for (std::int32_t row = 0; row <= 2047; ++row)
      ASSERT_EQ(band_of_row(row), row / static_cast<std::int32_t>(lines)) << "row " << row << ", lines " << lines;
  }
}

}  // namespace
}  // namespace spanline::test
