// Triangles that share edges, depths or places.
#include <array>
#include <cmath>
#include <numbers>

#include "generators.hpp"
#include "sizes.hpp"

namespace spanline::contract {
namespace {

/// Two triangles between four corners in order.
void add_quad(Scene& scene, const std::array<Corner, 4>& c, bool other_diagonal = false) {
  if (other_diagonal) {
    scene.triangles.push_back({c[3], c[0], c[1]});
    scene.triangles.push_back({c[1], c[2], c[3]});
  } else {
    scene.triangles.push_back({c[0], c[1], c[2]});
    scene.triangles.push_back({c[0], c[2], c[3]});
  }
}

void add_grid(Random& random, Scene& scene) {
  const int columns = random.between(1, 8), rows = random.between(1, 8);
  const std::int32_t middle = random.between(nearest_depth, farthest_depth), reach = 1 << random.between(0, 22);
  std::vector<Corner> corners;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i)
      corners.push_back(corner_near(i * 16 * scene.width / columns + random.between(-30, 30),
                                    j * 16 * scene.height / rows + random.between(-30, 30),
                                    std::int64_t{middle} + random.between(-reach, reach)));
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const auto at = [&](int di, int dj) {
        return corners[static_cast<std::size_t>((j + dj) * (columns + 1) + i + di)];
      };
      add_quad(scene, {at(0, 0), at(1, 0), at(1, 1), at(0, 1)}, random.chance(2));
    }
}

}  // namespace

/// Watertight sheets, one over another.
Scene shared_grids(Random& random) {
  Scene scene = sized(random);
  const int layers = random.between(1, 4);
  for (int i = 0; i < layers; ++i) add_grid(random, scene);
  if (random.chance(2)) shuffle(random, scene.triangles);
  return scene;
}

/// Triangles of one plane, copies, and copies that are off by a few units: ties everywhere.
Scene coplanar_ties(Random& random) {
  Scene scene = sized(random);
  const int count = random.between(2, 60);
  const std::int64_t middle = random.between(1 << 20, 1 << 23);
  const bool level = random.chance(3);
  const int dx = level ? 0 : random.between(-8, 8), dy = level ? 0 : random.between(-8, 8);
  const auto on_plane = [&] {
    const int x = random.between(0, 16 * scene.width), y = random.between(0, 16 * scene.height);
    return corner_near(x, y, middle + dx * x + dy * y);
  };
  for (int i = 0; i < count; ++i) {
    const Corners t{on_plane(), on_plane(), on_plane()};
    scene.triangles.push_back(t);
    if (random.chance(2)) {
      Corners copy = t;
      copy[static_cast<std::size_t>(random.between(0, 2))].z += random.between(-1, 1) * random.between(0, 300);
      scene.triangles.push_back(copy);
    }
    if (random.chance(4))
      scene.triangles.push_back(
          scene.triangles[static_cast<std::size_t>(random.between(0, static_cast<int>(scene.triangles.size()) - 1))]);
  }
  return scene;
}

/// Upright rectangles whose edges lie on pixel centres or between pixels, at few depths: equal keys, edges and depths.
Scene quads_on_centres(Random& random) {
  Scene scene = sized(random);
  const int count = random.between(5, 120);
  for (int i = 0; i < count; ++i) {
    int x0 = random.between(0, scene.width) * 16 + random.between(0, 1) * 8,
        y0 = random.between(0, scene.height) * 16 + random.between(0, 1) * 8;
    int x1 = x0 + random.between(1, scene.width) * 16, y1 = y0 + random.between(1, scene.height) * 16;
    if (random.chance(3)) {
      x0 = 0;
      x1 = 16 * scene.width;
    }
    if (random.chance(3)) {
      y0 = 0;
      y1 = 16 * scene.height;
    }
    const std::int32_t z = 1000 * random.between(1, 20);
    add_quad(scene, {corner_near(x0, y0, z), corner_near(x1, y0, z), corner_near(x1, y1, z), corner_near(x0, y1, z)},
             random.chance(2));
  }
  return scene;
}

/// Three to nine bars, each over the next and the last over the first.
Scene cyclic_bars(Random& random) {
  Scene scene = sized(random);
  const int bars = random.between(3, 9);
  const double turn = random.real(0, 2 * std::numbers::pi), reach = random.real(3, 10) * scene.height,
               width = random.real(10, 150);
  for (int i = 0; i < bars; ++i) {
    const double angle = turn + i * 2 * std::numbers::pi / bars;
    const double ux = std::cos(angle), uy = std::sin(angle);
    const double x = 8.0 * scene.width - uy * reach * 0.4, y = 8.0 * scene.height + ux * reach * 0.4;
    std::int64_t near = 1 << 20, far = 14 << 20;
    if (random.chance(8)) std::swap(near, far);  // sometimes the circle is broken
    const auto corner = [&](int along, int across, std::int64_t z) {
      return corner_near(static_cast<int>(x + along * ux * reach - across * uy * width),
                         static_cast<int>(y + along * uy * reach + across * ux * width), z);
    };
    add_quad(scene, {corner(-1, -1, near), corner(1, -1, far), corner(1, 1, far), corner(-1, 1, near)});
  }
  return scene;
}

/// No two triangles overlap in depth: painter's algorithm must be right here.
Scene depth_layers(Random& random) {
  Scene scene = sized(random);
  test::TriangleMaker make(static_cast<std::uint32_t>(random.between(0, 1 << 30)), scene.width, scene.height,
                           nearest_depth, farthest_depth);
  const int count = random.between(2, 120);
  const std::int32_t thickness = farthest_depth / count;
  for (int i = 0; i < count; ++i) {
    Corners t = make(test::all_triangle_kinds[static_cast<std::size_t>(i) % test::all_triangle_kinds.size()]);
    for (Corner& c : t) c.z = depth_near(i * std::int64_t{thickness} + random.between(16, thickness - 16));
    scene.triangles.push_back(t);
  }
  shuffle(random, scene.triangles);
  return scene;
}

/// Half the screen a hundred to four hundred times over: from front to back, from back to front, in any order, or all
/// at nearly one depth.
Scene stack(Random& random) {
  Scene scene = sized(random);
  const int count = random.between(100, 420), order = random.between(0, 3);
  for (int i = 0; i < count; ++i) {
    const std::int64_t depths[] = {16 + std::int64_t{i} * (farthest_depth / count),
                                   farthest_depth - std::int64_t{i} * (farthest_depth / count),
                                   random.between(nearest_depth, farthest_depth), random.between(5000, 5100)};
    const int reach = random.chance(2) ? 0 : 1 << random.between(0, 16), frame = random.between(0, 200);
    const auto corner = [&](int x, int y) {
      return corner_near(x + random.between(-frame, frame), y + random.between(-frame, frame),
                         depths[order] + random.between(-reach, reach));
    };
    const int right = 16 * scene.width;
    scene.triangles.push_back(
        {corner(0, 0), corner(right, 0), corner(random.chance(2) ? right : 0, 16 * scene.height)});
  }
  return scene;
}

}  // namespace spanline::contract
