#pragma once
#include <algorithm>
#include <array>
#include <cstdint>

#include "scene.hpp"
#include "spanline/raster/depth_format.hpp"
#include "support/random.hpp"

namespace spanline::contract {

inline constexpr auto nearest_depth = static_cast<std::int32_t>(Depth24<>::nearest);
inline constexpr auto farthest_depth = static_cast<std::int32_t>(Depth24<>::farthest);
inline constexpr int guard = ScreenVertex::guard_pixels * 16;  ///< sixteenths

/// A depth that polygons may have.
[[nodiscard]] inline std::int32_t depth_near(std::int64_t z) {
  return static_cast<std::int32_t>(std::clamp<std::int64_t>(z, nearest_depth, farthest_depth));
}

/// A corner within the guard band.
[[nodiscard]] inline Corner corner_near(int x, int y, std::int64_t z) {
  return {std::clamp(x, -guard, guard), std::clamp(y, -guard, guard), depth_near(z)};
}

/// An empty scene of some usual size.
[[nodiscard]] inline Scene sized(test::Random& random) {
  constexpr std::array<std::array<int, 2>, 6> sizes{{{96, 64}, {40, 30}, {160, 120}, {320, 40}, {33, 77}, {64, 200}}};
  const auto [width, height] = sizes[static_cast<std::size_t>(random.between(0, static_cast<int>(sizes.size()) - 1))];
  return {width, height};
}

/// Puts triangles into any order of submission.
inline void shuffle(test::Random& random, std::vector<Corners>& triangles) {
  for (std::size_t i = triangles.size(); i > 1; --i)
    std::swap(triangles[i - 1], triangles[static_cast<std::size_t>(random.wide(0, static_cast<std::int64_t>(i) - 1))]);
}

}  // namespace spanline::contract
