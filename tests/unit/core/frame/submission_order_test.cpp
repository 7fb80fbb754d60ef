// Orders of submission: instances and polygons come as somebody else has ordered them.
#include <gtest/gtest.h>

#include <spanline/frame/ready_made_traits.hpp>
#include <vector>

#include "scenes/prisms_mesh.hpp"
#include "scenes/torus_mesh.hpp"
#include "spanline/world/submission_order.hpp"
#include "support/ready_made_studios.hpp"

namespace spanline::test {
namespace {

using namespace spanline::literals;

Transform at(Q16_16 x, Q16_16 z) {
  Transform transform;
  transform.translation = {x, {}, z};
  return transform;
}

Submission part(std::uint32_t instance, const Mesh& mesh, std::uint32_t first, std::uint32_t count) {
  return {instance, false, PolygonRange::of(mesh, first, count)};
}

class Orders : public ::testing::Test {
 protected:
  using Picture = test::Picture<Ids>;

  Picture draw(const std::vector<Submission>& order) {
    studio_.begin({});
    const Status added = studio_.renderer().add_in_order(ListedOrder(order), instances_);
    EXPECT_TRUE(added.ok()) << to_string(added.fault) << ", " << to_string(added.pool) << ", wanted " << added.wanted;
    return studio_.draw();
  }
  /// In the order of the list, without anybody's order.
  Picture draw_as_listed() {
    studio_.begin({});
    for (const OrderedInstance& instance : instances_)
      studio_.add(*instance.mesh, instance.transform, instance.material);
    return studio_.draw();
  }
  static std::uint32_t polygons(const Mesh& mesh) { return PolygonRange::whole(mesh).count; }

  const Mesh& torus_ = scenes::torus;    ///< of triangles
  const Mesh& prisms_ = scenes::prisms;  ///< of polygons with corners of their own number
  /// Two that penetrate each other, and one behind them.
  std::vector<OrderedInstance> instances_{{&torus_, at(-0.5_q16, -4.0_q16), {}},
                                          {&prisms_, at(0.5_q16, -4.0_q16), {}},
                                          {&torus_, at(0.2_q16, -6.0_q16), {}}};
  Studio<Ids> studio_{mesh_capacity(96, 64, 16, 4000, 1200)};
};

TEST_F(Orders, TheOrderOfTheListIsThatOfPlainCalls) {
  const Picture want = draw_as_listed();
  EXPECT_GT(want.drawn_count(), 500U);
  EXPECT_TRUE(draw({{0}, {1}, {2}}) == want);
}

/// No two depths are the same here but where one polygon ends and its neighbour begins.
TEST_F(Orders, AnyOrderShowsTheSameAndKeepsTheNumbersOfTheList) {
  const Picture want = draw_as_listed();
  for (const std::vector<Submission>& order : std::vector<std::vector<Submission>>{{{2}, {1}, {0}}, {{1}, {2}, {0}}}) {
    const Picture got = draw(order);
    EXPECT_EQ(got.depth, want.depth);
    EXPECT_EQ(got.covered, want.covered);
  }
}

TEST_F(Orders, PolygonsComeInPartsThatInterleave) {
  const Picture want = draw_as_listed();
  const std::uint32_t triangles = polygons(torus_), faces = polygons(prisms_), third = triangles / 3, half = faces / 2;
  const Picture got = draw({part(0, torus_, 0, third),
                            part(0, torus_, third, 5),
                            part(1, prisms_, half, faces - half),
                            part(0, torus_, third + 5, triangles - third - 5),
                            part(1, prisms_, 0, half),
                            {2}});
  EXPECT_TRUE(got == want);
  EXPECT_EQ(got.covered, want.covered);
}

TEST_F(Orders, PartsOfOneInstanceThatFollowOneAnotherShareItsVertices) {
  const std::uint32_t triangles = polygons(torus_);
  studio_.begin({});
  const std::vector<Submission> order{part(0, torus_, 0, 7), part(0, torus_, 7, triangles - 7)};
  ASSERT_TRUE(studio_.renderer().add_in_order(ListedOrder(order), instances_).ok());
  (void)studio_.draw();
  EXPECT_EQ(studio_.renderer().peaks().vertices, torus_.vertex_count() * sizeof(ScreenVertex));
}

TEST_F(Orders, TiesAreSettledByTheOrder) {
  instances_ = {{&torus_, at(0.0_q16, -4.0_q16), {}}, {&torus_, at(0.0_q16, -4.0_q16), {}}};
  const auto count = static_cast<std::uint32_t>(torus_.triangle_count());
  const Picture first = draw({{0}, {1}}), second = draw({{1}, {0}});
  for (std::size_t i = 0; i < first.pixels.size(); ++i) {
    if (first.pixels[i] == 0) continue;
    ASSERT_LE(first.pixels[i], count);
    ASSERT_EQ(second.pixels[i], first.pixels[i] + count);
  }
}

TEST_F(Orders, ASubmissionMeansAllOfTheFirstInstanceUnlessItSaysOtherwise) {
  const Picture got = draw({Submission{}}), want = draw({{0}});
  EXPECT_EQ(got.pixels, want.pixels);
  EXPECT_GT(want.drawn_count(), 200U);
}

TEST_F(Orders, WhatFindsNoRoomIsToldOfAndTheRestIsDrawn) {
  Studio<Ids> small(mesh_capacity(96, 64, 1, 4000, 1200));
  small.begin({});
  const std::vector<Submission> order{{0}, {1}, {2}};
  const Status added = small.renderer().add_in_order(ListedOrder(order), instances_);
  EXPECT_EQ(added.fault, Fault::pool_full);
  EXPECT_EQ(added.pool, Pool::instances);
  EXPECT_EQ(added.wanted, 3U);
  EXPECT_GT(small.draw().drawn_count(), 200U);
}

TEST_F(Orders, NumbersAndPartsThatDoNotExistAreRefused) {
  studio_.begin({});
  for (const Submission& wrong :
       {Submission{3}, part(0, torus_, 0, polygons(torus_) + 1), Submission{0, false, {polygons(torus_), 1, 0, 0}}}) {
    const std::vector<Submission> order{wrong};
    EXPECT_EQ(studio_.renderer().add_in_order(ListedOrder(order), instances_).fault, Fault::bad_order);
  }
  EXPECT_EQ(studio_.draw().drawn_count(), 0U);
}

}  // namespace
}  // namespace spanline::test
