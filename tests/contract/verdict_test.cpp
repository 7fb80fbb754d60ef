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

TEST(Verdict, OrderBoundIsHeldToPixelsThatAnOrderDecides) {
  Drawing owners = halves();
  owners.pixels[7] = 0;
  const Drawing want = owners;
  std::vector<bool> ordered(400, false);
  ordered[5] = true;
  EXPECT_EQ(disorder(want, want, owners, ordered), "");
  const auto changed = [&](std::size_t pixel, std::uint32_t id) {
    Drawing got = want;
    got.pixels[pixel] = id;
    return disorder(want, got, owners, ordered);
  };
  EXPECT_EQ(changed(6, 3), "") << "polygons overlap in depth there";
  EXPECT_NE(changed(5, 3), "");
  EXPECT_NE(changed(6, 0), "") << "the background shows through";
  EXPECT_NE(changed(7, 3), "") << "nothing covers it";
}

TEST(Verdict, OrderBoundColoursMayBeThatOfTheBackground) {
  const Drawing owners = halves();
  Drawing want = halves();
  want.pixels.assign(400, 9);
  Drawing got = want;
  got.pixels[3] = 0;
  EXPECT_EQ(disorder(want, got, owners, std::vector<bool>(400, false)), "");
  EXPECT_NE(disorder(want, got, owners, std::vector<bool>(400, true)), "");
}

TEST(Verdict, ClassesAreHeldToTheirOwnChecks) {
  const Drawing want = halves();
  Drawing got = halves();
  got.pixels[got.at(9, 0)] = 2;
  EXPECT_NE(fault_of(Exactness::exact, want, got, want, Scene{}), "");
  EXPECT_EQ(fault_of(Exactness::near_exact, want, got, want, Scene{}), "");
}

}  // namespace
}  // namespace spanline::contract
