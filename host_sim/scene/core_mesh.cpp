#include "scene/core_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/failure.hpp"
#include "scene/core_values.hpp"
#include "scene/fan_joining.hpp"

namespace spanline::sim {
namespace {

constexpr int wide_step_exponent = -16;
constexpr std::uint32_t no_vertex = std::numeric_limits<std::uint32_t>::max();

/// Fills one mesh after the other with the scene's triangles.
class MeshCutter {
 public:
  MeshCutter(const Scene& scene, const World& world) : scene_(scene), world_(world) {
    local_.assign(scene.positions.size(), no_vertex);
    texture_exponent_ = texture_exponent_for(scene.texture_points);
  }

  std::vector<CoreMesh> cut() {
    const bool by_parts = is_see_through(scene_) || textured() || has_different_highlights(scene_);
    auto part = scene_.parts.begin();
    for (std::size_t i = 0, polygon = 0; i < scene_.triangles.size(); ++polygon) {
      const std::uint8_t count = scene_.polygon_triangles.empty() ? std::uint8_t{1} : scene_.polygon_triangles[polygon];
      const bool part_begins = by_parts && part != scene_.parts.end() && part->first == i;
      if ((part_begins && i != 0) || !fits(i, count)) finish_mesh();
      if (part_begins) part_ = static_cast<std::size_t>(part++ - scene_.parts.begin());
      fans_.push_back(count);
      for (const std::size_t end = i + count; i < end; ++i) add_triangle(i);
    }
    finish_mesh();
    const BoundingSphere bounds = bounding_sphere(points_);
    for (CoreMesh& mesh : meshes_) mesh.bounds = bounds;
    return std::move(meshes_);
  }

 private:
  [[nodiscard]] bool textured() const { return !scene_.texture_points.empty(); }

  /// Whether the mesh has room for a fan, even if its triangles have to stand alone. Corners that they share count once
  /// for each of them, which is too often at worst.
  [[nodiscard]] bool fits(std::size_t first, std::size_t count) const {
    std::size_t fresh = 0;
    for (std::size_t i = first; i < first + count; ++i)
      for (const std::uint32_t corner : scene_.triangles[i])
        if (local_[corner] == no_vertex) ++fresh;
    return mesh_.indices.size() / 3 + count <= Mesh::max_polygons && used_.size() + fresh <= Mesh::max_vertices;
  }

  void add_triangle(std::size_t number) {
    for (const std::uint32_t corner : scene_.triangles[number])
      mesh_.indices.push_back(static_cast<std::uint16_t>(local_number(corner)));
    if (!scene_.polygon_normals.empty())
      mesh_.polygon_normals.push_back(to_packed_normal(scene_.polygon_normals[number]));
    if (!scene_.polygon_colours.empty()) mesh_.polygon_colours.push_back(scene_.polygon_colours[number]);
  }

  std::uint32_t local_number(std::uint32_t vertex) {
    if (local_[vertex] != no_vertex) return local_[vertex];
    local_[vertex] = static_cast<std::uint32_t>(used_.size());
    used_.push_back(vertex);
    const Vector3 p = world_.to_world(scene_.positions[vertex]);
    const auto steps = [](double value) { return std::llround(std::ldexp(value, -wide_step_exponent)); };
    const Vec3<std::int64_t> point{steps(p.x), steps(p.y), steps(p.z)};
    points_.push_back(point);
    mesh_.wide_vertices.push_back(
        {static_cast<std::int32_t>(point.x), static_cast<std::int32_t>(point.y), static_cast<std::int32_t>(point.z)});
    if (!scene_.vertex_normals.empty()) mesh_.vertex_normals.push_back(to_packed_normal(scene_.vertex_normals[vertex]));
    if (!scene_.vertex_colours.empty()) mesh_.vertex_colours.push_back(scene_.vertex_colours[vertex]);
    if (!scene_.vertex_opacities.empty()) mesh_.vertex_opacities.push_back(scene_.vertex_opacities[vertex]);
    if (!scene_.texture_points.empty()) {
      mesh_.texture_coordinates.push_back(to_coordinate(scene_.texture_points[vertex], texture_exponent_));
    }
    return local_[vertex];
  }

  void finish_mesh() {
    for (const std::uint32_t vertex : used_) local_[vertex] = no_vertex;
    mesh_.step_exponent = wide_step_exponent;
    mesh_.texture_exponent = texture_exponent_;
    mesh_.colour = scene_.colour;
    mesh_.part = part_;
    if (!scene_.parts.empty()) {
      const Scene::Part& part = scene_.parts[part_];
      mesh_.opacity = static_cast<std::uint8_t>(part.opacity);
      mesh_.highlights = part.highlights;
      if (textured()) mesh_.colour = part.colour;
    }
    if (!scene_.polygon_triangles.empty()) join_fans(mesh_, fans_);
    meshes_.push_back(std::move(mesh_));
    mesh_ = {};
    used_.clear();
    fans_.clear();
  }

  const Scene& scene_;
  const World& world_;
  int texture_exponent_ = -14;
  std::vector<CoreMesh> meshes_;
  CoreMesh mesh_;
  std::vector<std::uint32_t> local_;        ///< number within the mesh of each of the scene's vertices
  std::size_t part_ = 0;                    ///< of the scene
  std::vector<std::uint32_t> used_;         ///< vertices of the mesh
  std::vector<std::uint8_t> fans_;          ///< of the mesh, as Scene::polygon_triangles
  std::vector<Vec3<std::int64_t>> points_;  ///< of all meshes
};

}  // namespace

int texture_exponent_for(const std::vector<TexturePoint>& points) {
  double greatest = 0;
  for (const TexturePoint& p : points) greatest = std::max({greatest, std::fabs(p.s), std::fabs(p.t)});
  int exponent = -14;
  while (std::ldexp(greatest, -exponent) > 32767) ++exponent;
  if (exponent > -5) throw Failure("the model repeats its texture more than a thousand times");
  return exponent;
}

TextureCoordinate to_coordinate(TexturePoint point, int texture_exponent) {
  const auto units = [&](double v) { return static_cast<std::int16_t>(std::lround(std::ldexp(v, -texture_exponent))); };
  return {units(point.s), units(point.t)};
}

Mesh CoreMesh::view() const {
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
  mesh.texture_exponent = static_cast<std::int8_t>(texture_exponent);
  mesh.offset = offset;
  mesh.step_exponent = static_cast<std::int8_t>(step_exponent);
  mesh.bounds = bounds;
  return mesh;
}

std::vector<CoreMesh> to_core_meshes(const Scene& scene, const World& world) { return MeshCutter(scene, world).cut(); }

BoundingSphere bounding_sphere(const std::vector<Vec3<std::int64_t>>& points) {
  if (points.empty()) return {};
  Vec3<std::int64_t> low = points.front(), high = points.front();
  for (const auto& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const Vec3<std::int64_t> centre{(low.x + high.x) / 2, (low.y + high.y) / 2, (low.z + high.z) / 2};
  // Distances stay below 2^31 a component, their squares below 2^62 and the sum below 2^64.
  std::uint64_t farthest = 0;
  for (const auto& p : points) {
    const auto square = [](std::int64_t d) { return static_cast<std::uint64_t>(d * d); };
    farthest = std::max(farthest, square(p.x - centre.x) + square(p.y - centre.y) + square(p.z - centre.z));
  }
  std::uint64_t radius = square_root(farthest);
  if (radius * radius < farthest) ++radius;
  const auto component = [](std::int64_t c) { return static_cast<std::int32_t>(c); };
  return {{component(centre.x), component(centre.y), component(centre.z)}, static_cast<std::uint32_t>(radius)};
}

}  // namespace spanline::sim
