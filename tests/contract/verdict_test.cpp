// The checks of the three classes, on pictures made by hand: each lets through what its class allows, and nothing else.
#include "verdict.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace spanline::contract {
namespace {

/// 20 × 20 pixels, 1 on the left half and 2 on the right one.
Drawing halves() {
  Drawing d;
  d.width = d.height = 20;
  for (int i = 0; i < 400; ++i) d.pixels.push_back(i % 20 < 10 ? 1 : 2);
  d.depths.assign(400, 1000);
  return d;
}

TEST(Verdict, ExactMeansEveryByteOfPixelsAndDepths) {
  const Drawing want = halves();
  EXPECT_EQ(difference(want, halves()), "");
  Drawing got = halves();
  got.pixels[got.at(3, 4)] = 9;
  EXPECT_EQ(difference(want, got), "1 pixels of 400 differ, the first at column 3, row 4: wanted 1, got 9");
  got = halves();
  ++got.depths[399];
  EXPECT_NE(difference(want, got), "");
  got.depths.clear();
  EXPECT_EQ(difference(want, got), "") << "no depths were asked for";
  got.pixels.pop_back();
  EXPECT_NE(difference(want, got), "");
}

TEST(Verdict, NearExactAllowsPixelsAtEdgesAndNoOthers) {
  const Drawing want = halves();
  for (int x = 0; x < 20; ++x) {
    Drawing got = halves();
    got.pixels[got.at(x, 7)] = 5;
    EXPECT_EQ(far_difference(want, got, want).empty(), x == 9 || x == 10) << x;
  }
  EXPECT_EQ(far_difference(want, halves(), want), "");
}

TEST(Verdict, NearExactAllowsAPixelDiagonallyAcrossACorner) {
  Drawing want = halves();
  want.pixels[want.at(4, 4)] = 7;
  Drawing got = want;
  got.pixels[got.at(3, 3)] = 7;
  EXPECT_EQ(far_difference(want, got, want), "");
  got.pixels[got.at(2, 3)] = 7;
  EXPECT_NE(far_difference(want, got, want), "") << "two pixels away";
}

TEST(Verdict, NearExactAllowsOnePixelInAHundred) {
  const Drawing want = halves();
  Drawing got = halves();
  for (int y = 0; y < 4; ++y) got.pixels[got.at(9, y)] = 2;
  EXPECT_EQ(far_difference(want, got, want), "");
  got.pixels[got.at(9, 4)] = 2;
  EXPECT_NE(far_difference(want, got, want), "");
}

TEST(Verdict, NearExactColoursAreHeldAgainstTheEdgesOfIds) {
  Drawing owners = halves(), want = halves(), got = halves();
  want.pixels.assign(400, 3);  // both polygons have one colour
  got.pixels.assign(400, 3);
  got.pixels[got.at(10, 0)] = 4;
  EXPECT_EQ(far_difference(want, got, owners), "");
  got.pixels[got.at(12, 0)] = 4;
  EXPECT_NE(far_difference(want, got, owners), "");
}

TEST(Verdict, OrderBoundIsHeldToScenesWithoutOverlapInDepth) {
  const Drawing want = halves();
  Drawing got = halves();
  got.pixels[5] = 3;
  EXPECT_EQ(fault_of(Exactness::order_bound, want, got, want, true), "");
  EXPECT_NE(fault_of(Exactness::order_bound, want, got, want, false), "");
  EXPECT_EQ(fault_of(Exactness::order_bound, want, halves(), want, false), "");
}

TEST(Verdict, ClassesAreHeldToTheirOwnChecks) {
  const Drawing want = halves();
  Drawing got = halves();
  got.pixels[got.at(9, 0)] = 2;
  EXPECT_NE(fault_of(Exactness::exact, want, got, want, true), "");
  EXPECT_EQ(fault_of(Exactness::near_exact, want, got, want, true), "");
}

TEST(Verdict, AClassIsReadFromTheList) {
  EXPECT_EQ(exactness_of({"a", "exact", "", false, 24}), Exactness::exact);
  EXPECT_EQ(exactness_of({"b", "near-exact", "", false, 24}), Exactness::near_exact);
  EXPECT_EQ(exactness_of({"c", "order-bound", "", false, 24}), Exactness::order_bound);
  EXPECT_THROW((void)exactness_of({"d", "good", "", false, 24}), std::logic_error);
}

TEST(Verdict, DepthsOverlapWhereRangesMeet) {
  const auto at = [](std::int32_t low, std::int32_t high) {
    return Corners{Corner{0, 0, low}, Corner{160, 0, high}, Corner{0, 160, high}};
  };
  Scene scene;
  scene.triangles = {at(500, 600), at(100, 200), at(300, 400)};
  EXPECT_FALSE(scene.depths_overlap());
  scene.triangles.push_back(at(350, 360));
  EXPECT_TRUE(scene.depths_overlap());
}

}  // namespace
}  // namespace spanline::contract
