#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "spanline/model/planarity.hpp"
#include "support/owned_mesh.hpp"

namespace spanline::test {

/// Marks every polygon that may be marked as planar.
inline void mark_planar(OwnedMesh& mesh) {
  std::size_t first = 0;
  for (std::size_t i = 0; i < mesh.corners.size(); ++i) {
    const Mesh view = mesh.view();
    if (planarity_of(view, i, first) == Planarity::planar) mesh.corners[i] |= Mesh::planar;
    first += view.corner_count(i);
  }
}

/// A prism about the origin over a regular polygon of `count` corners, 3 … 8; faces counter-clockwise from outside, a
/// normal each. Its top and its sides are polygons. `radius` and `half_height` in steps.
[[nodiscard]] inline OwnedMesh prism(int count, int radius, int half_height) {
  OwnedMesh mesh;
  const auto push = [&](auto value) { mesh.indices.push_back(static_cast<std::uint16_t>(value)); };
  const auto face = [&](int corners, double x, double y, double z) {
    mesh.corners.push_back(static_cast<std::uint8_t>(corners));
    const auto part = [](double v) { return static_cast<int>(std::lround(v * 511)); };
    mesh.polygon_normals.emplace_back(part(x), part(y), part(z));
  };
  for (int i = 0; i < count; ++i) {
    const double around = 2 * std::numbers::pi * i / count;
    const auto at = [&](double v) { return static_cast<std::int16_t>(std::lround(v * radius)); };
    for (const int y : {half_height, -half_height})
      mesh.vertices.push_back({at(std::cos(around)), static_cast<std::int16_t>(y), at(std::sin(around))});
  }
  for (int i = 0; i < count; ++i) push(2 * (count - 1 - i));
  face(count, 0, 1, 0);
  for (int i = 0; i < count; ++i) push(2 * i + 1);
  face(count, 0, -1, 0);
  for (int i = 0; i < count; ++i) {
    const int here = 2 * i, next = 2 * ((i + 1) % count);
    for (const int v : {here, next, next + 1, here + 1}) push(v);
    const double middle = 2 * std::numbers::pi * (i + 0.5) / count;
    face(4, std::cos(middle), 0, std::sin(middle));
  }
  mesh.fit_bounds();
  return mesh;
}

/// The same seen from within.
inline void turn_inside_out(OwnedMesh& mesh) {
  std::size_t first = 0;
  const Mesh view = mesh.view();
  for (std::size_t i = 0; i < mesh.corners.size(); ++i) {
    const auto from = mesh.indices.begin() + static_cast<std::ptrdiff_t>(first);
    std::reverse(from, from + view.corner_count(i));
    first += view.corner_count(i);
  }
  for (PackedNormal& n : mesh.polygon_normals) n = PackedNormal(-n.x(), -n.y(), -n.z());
}

}  // namespace spanline::test
