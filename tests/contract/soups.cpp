// Triangles of all kinds, anywhere.
#include <array>

#include "generators.hpp"
#include "sizes.hpp"

namespace spanline::contract {
namespace {

using test::TriangleKind;
using test::TriangleMaker;

TriangleMaker maker(Random& random, const Scene& scene) {
  return {static_cast<std::uint32_t>(random.between(0, 1 << 30)), scene.width, scene.height, nearest_depth,
          farthest_depth};
}

TriangleKind any_kind(Random& random) {
  return test::all_triangle_kinds[static_cast<std::size_t>(
      random.between(0, static_cast<int>(test::all_triangle_kinds.size()) - 1))];
}

/// Brings a triangle's depths to within `reach` of a common one.
void flatten(Random& random, Corners& triangle, std::int32_t middle, std::int32_t reach) {
  for (Corner& c : triangle) c.z = depth_near(middle + random.between(-reach, reach));
}

void fill_mixed(Random& random, Scene& scene, int most) {
  TriangleMaker make = maker(random, scene);
  const int count = random.between(1, most);
  for (int i = 0; i < count; ++i) scene.triangles.push_back(make(any_kind(random)));
}

}  // namespace

Scene soup(Random& random, TriangleKind kind) {
  Scene scene = sized(random);
  TriangleMaker make = maker(random, scene);
  const bool small = kind <= TriangleKind::medium || kind == TriangleKind::right_angled;
  const bool giant = kind == TriangleKind::giant || kind == TriangleKind::giant_sliver;  // few of which come into view
  const int count = giant ? random.between(40, 250) : random.between(2, small ? 400 : 90);
  for (int i = 0; i < count; ++i) {
    scene.triangles.push_back(make(kind));
    // Half of the soups are thin in depth: few orders are decided by bounds.
    if (count % 2 == 0) flatten(random, scene.triangles.back(), 1 << 23, 1 << (8 + count % 13));
  }
  return scene;
}

Scene mixed_soup(Random& random) {
  Scene scene = sized(random);
  fill_mixed(random, scene, 200);
  return scene;
}

/// Large triangles through one another about one depth.
Scene penetrating_soup(Random& random) {
  Scene scene = sized(random);
  TriangleMaker make = maker(random, scene);
  const int count = random.between(2, 120);
  for (int i = 0; i < count; ++i) {
    Corners t = make(random.chance(3) ? TriangleKind::large : TriangleKind::screen);
    flatten(random, t, 1 << 23, 1 << random.between(3, 22));
    scene.triangles.push_back(t);
  }
  return scene;
}

/// Corners at both ends of the range of depths, where the rounding of a plane could wrap.
Scene extreme_depths(Random& random) {
  Scene scene = sized(random);
  TriangleMaker make = maker(random, scene);
  const int count = random.between(2, 80);
  for (int i = 0; i < count; ++i) {
    Corners t = make(any_kind(random));
    for (Corner& c : t) {
      const int step = random.between(0, 2);
      c.z = random.chance(2) ? nearest_depth + step : farthest_depth - step;
    }
    scene.triangles.push_back(t);
  }
  return scene;
}

Scene odd_size(Random& random) {
  constexpr std::array<std::array<int, 2>, 7> sizes{
      {{1, 1}, {1, 240}, {320, 1}, {33, 77}, {639, 37}, {2047, 3}, {3, 2047}}};
  const auto [width, height] = sizes[static_cast<std::size_t>(random.between(0, static_cast<int>(sizes.size()) - 1))];
  Scene scene(width, height);
  fill_mixed(random, scene, 120);
  return scene;
}

}  // namespace spanline::contract
