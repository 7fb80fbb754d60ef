#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "spanline/model/mesh.hpp"

namespace spanline::test {

/// A mesh that owns its tables.
struct OwnedMesh {
  std::vector<Vertex16> vertices;
  std::vector<Vertex32> wide_vertices;
  std::vector<std::uint16_t> indices;
  std::vector<std::uint8_t> corners;
  std::vector<PackedNormal> polygon_normals, vertex_normals;
  std::vector<Rgb888> polygon_colours, vertex_colours;
  std::vector<TextureCoordinate> texture_coordinates;
  std::vector<std::uint8_t> vertex_opacities;
  std::int8_t texture_exponent = -14;
  Vec3<std::int32_t> offset{};
  std::int8_t step_exponent = -13;
  BoundingSphere bounds{};

  [[nodiscard]] Mesh view() const {
    Mesh mesh;
    mesh.vertices = vertices;
    mesh.wide_vertices = wide_vertices;
    mesh.indices = indices;
    mesh.corners = corners;
    mesh.polygon_normals = polygon_normals;
    mesh.vertex_normals = vertex_normals;
    mesh.polygon_colours = polygon_colours;
    mesh.vertex_colours = vertex_colours;
    mesh.texture_coordinates = texture_coordinates;
    mesh.vertex_opacities = vertex_opacities;
    mesh.texture_exponent = texture_exponent;
    mesh.offset = offset;
    mesh.step_exponent = step_exponent;
    mesh.bounds = bounds;
    return mesh;
  }

  void triangle(std::size_t a, std::size_t b, std::size_t c) {
    for (const std::size_t i : {a, b, c}) indices.push_back(static_cast<std::uint16_t>(i));
  }

  /// A sphere around the middle of the vertices' box.
  void fit_bounds() { bounds = vertices.empty() ? sphere_around(wide_vertices) : sphere_around(vertices); }

 private:
  template <class Vertex>
  static BoundingSphere sphere_around(const std::vector<Vertex>& table) {
    const auto middle = [&](auto member) {
      const auto [low, high] = std::minmax_element(
          table.begin(), table.end(), [member](const Vertex& a, const Vertex& b) { return a.*member < b.*member; });
      return static_cast<std::int32_t>((static_cast<std::int64_t>((*low).*member) + (*high).*member) / 2);
    };
    BoundingSphere sphere{{middle(&Vertex::x), middle(&Vertex::y), middle(&Vertex::z)}, 0};
    double greatest = 0;
    for (const Vertex& v : table) {
      const double x = static_cast<double>(v.x) - sphere.centre.x, y = static_cast<double>(v.y) - sphere.centre.y,
                   z = static_cast<double>(v.z) - sphere.centre.z;
      greatest = std::max(greatest, x * x + y * y + z * z);
    }
    sphere.radius = static_cast<std::uint32_t>(std::ceil(std::sqrt(greatest))) + 1;
    return sphere;
  }
};

/// A tetrahedron, `size` steps from the origin to each corner's coordinates; faces counter-clockwise from outside.
[[nodiscard]] inline OwnedMesh tetrahedron(std::int16_t size = 8192) {
  const auto s = size;
  const auto m = static_cast<std::int16_t>(-size);
  OwnedMesh mesh;
  mesh.vertices = {{s, s, s}, {m, m, s}, {m, s, m}, {s, m, m}};
  mesh.triangle(0, 2, 1);
  mesh.triangle(0, 1, 3);
  mesh.triangle(0, 3, 2);
  mesh.triangle(1, 2, 3);
  mesh.fit_bounds();
  return mesh;
}

}  // namespace spanline::test
