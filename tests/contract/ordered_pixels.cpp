#include "ordered_pixels.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "support/exact_triangle.hpp"

namespace spanline::contract {
namespace {

using DepthRange = std::pair<std::int32_t, std::int32_t>;

bool are_apart(std::vector<DepthRange>& ranges) {
  constexpr std::int32_t rounding = 4;  // a plane may leave its corners' depths by two units
  std::sort(ranges.begin(), ranges.end());
  for (std::size_t i = 1; i < ranges.size(); ++i)
    if (ranges[i].first <= ranges[i - 1].second + rounding) return false;
  return true;
}

}  // namespace

std::vector<bool> ordered_pixels(const Scene& scene) {
  std::vector<bool> ordered(scene.pixel_count(), scene.parts.empty());
  if (!scene.parts.empty()) return ordered;
  std::vector<std::vector<DepthRange>> ranges(scene.pixel_count());
  for (const Corners& t : scene.triangles)
    test::ExactTriangle(t).for_each_pixel(scene.width, scene.height, [&](int x, int y) {
      const auto pixel =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(scene.width) + static_cast<std::size_t>(x);
      ranges[pixel].push_back(std::minmax({t[0].z, t[1].z, t[2].z}));
    });
  for (std::size_t i = 0; i < ordered.size(); ++i) ordered[i] = are_apart(ranges[i]);
  return ordered;
}

}  // namespace spanline::contract
