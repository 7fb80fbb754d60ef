// Polygons that span sets aside: hidden on every row until they wake. Records are made of few values, so that edges are
// often alike in all but one part, and often of different kinds.
#include "spanline/visibility/span/sleep.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>

#include "support/effort.hpp"
#include "support/random.hpp"

namespace spanline::test {
namespace {

constexpr std::int32_t row = 100, width = 12;
/// Fixed columns are never negative: they count from a column so far to the left.
constexpr int bias = 128;

template <class T>
T one_of(Random& random, std::initializer_list<T> values) {
  return values.begin()[random.between(0, static_cast<int>(values.size()) - 1)];
}

Edge any_edge(Random& random) {
  const int height = one_of(random, {32, 40, 48});
  return {random.between(-2, width + 2), random.between(-1, 1), -random.between(1, 4) * 8, random.between(0, 3) * 8,
          height};
}

std::uint32_t any_column(Random& random, int bits) {
  return static_cast<std::uint32_t>(2 * bias + random.between(-4, 2 * width + 4)) << (bits - 1);
}
std::uint32_t any_step(Random& random, int bits) {
  return static_cast<std::uint32_t>(random.between(-3, 3)) << (bits - 2);
}

FixedEdges any_fixed_edges(Random& random, int bits) {
  return {any_column(random, bits), any_column(random, bits), any_step(random, bits), any_step(random, bits), 0, 0};
}

/// Gives one part of the record another value. The kind of edge changes with the edges, or without them where both are
/// fixed.
void change(Random& random, AwakePolygon& polygon) {
  const int bits = polygon.fraction_bits;
  switch (random.between(0, 7)) {
    case 0:
      polygon.turn_row = static_cast<std::uint16_t>(row + random.between(1, 60));
      return;
    case 1:
      polygon.origin = static_cast<std::int16_t>(random.between(-2, 2) - bias);
      return;
    case 2:
      if (bits != 0) polygon.fraction_bits = one_of<std::uint8_t>(random, {15, 16});
      return;
    case 3:
      polygon.fraction_bits = one_of<std::uint8_t>(random, {0, 15, 16});
      if (polygon.fraction_bits == 0)
        polygon.large = {any_edge(random), any_edge(random)};
      else
        polygon.fixed = any_fixed_edges(random, polygon.fraction_bits);
      return;
    default:
      break;
  }
  const bool left = random.chance(2);
  if (bits != 0) {
    if (random.chance(2))
      (left ? polygon.fixed.left : polygon.fixed.right) = any_column(random, bits);
    else
      (left ? polygon.fixed.left_step : polygon.fixed.right_step) = any_step(random, bits);
    return;
  }
  const auto part = one_of(random, {&Edge::x, &Edge::step, &Edge::error, &Edge::remainder, &Edge::height});
  (left ? polygon.large.left : polygon.large.right).*part = any_edge(random).*part;
}

/// Whether the columns of `hidden` that lie in the picture are columns of `front`.
::testing::AssertionResult lies_within(AwakePolygon::Columns hidden, AwakePolygon::Columns front) {
  const std::int32_t left = std::max(hidden.left, 0), right = std::min(hidden.right, width);
  if (left >= std::max(front.left, 0) && right <= std::min(front.right, width)) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "[" << hidden.left << ", " << hidden.right << ") beside [" << front.left
                                       << ", " << front.right << ")";
}

TEST(Sleep, WhatSleepsIsHiddenOnEveryRowUntilItWakes) {
  Random random(1);
  int sleeps = 0;
  for (int i = 0; i < rounds(2'000'000); ++i) {
    AwakePolygon front{};
    front.fraction_bits = 16;
    front.origin = -bias;
    front.fixed = any_fixed_edges(random, 16);
    front.turn_row = row + 60;
    for (int parts = random.between(4, 12); parts > 0; --parts) change(random, front);
    AwakePolygon hidden = front;
    for (int parts = random.between(0, 3); parts > 0; --parts) change(random, hidden);
    const std::int32_t until = polygon_sleep::hidden_until(hidden, front, row, width);
    if (until == 0) continue;
    ++sleeps;
    ASSERT_GT(until, row + polygon_sleep::least_rows);
    ASSERT_LE(until, std::min(hidden.turn_row, front.turn_row));
    for (std::int32_t rows = 0; rows < until - row; ++rows)
      ASSERT_TRUE(lies_within(hidden.columns_below(rows), front.columns_below(rows)))
          << "case " << i << ", row " << rows;
  }
  EXPECT_GT(sleeps, rounds(2'000'000) / 20);
}

}  // namespace
}  // namespace spanline::test
