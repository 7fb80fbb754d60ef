#include "convert/flash_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/failure.hpp"
#include "scene/core_values.hpp"
#include "scene/fan_joining.hpp"

namespace spanline::sim {
namespace {

constexpr int finest_step = -30, coarsest_step = 14;  // Mesh::step_exponent
constexpr double offset_limit = 1 << 30;
constexpr std::int64_t vertex_values = 65536;
constexpr std::size_t most_triangles = 65535;  ///< of all fans, which 16 bits number on boards

std::int64_t in_steps(double value, int exponent) { return std::llround(std::ldexp(value, -exponent)); }

bool spans(double low, double high, int exponent) {
  const double greatest = std::max(std::fabs(low), std::fabs(high));
  return std::ldexp(greatest, -exponent) <= offset_limit - vertex_values &&
         in_steps(high, exponent) - in_steps(low, exponent) < vertex_values;
}

int choose_step(const BoundingBox& box) {
  for (int exponent = finest_step; exponent <= coarsest_step; ++exponent)
    if (spans(box.low.x, box.high.x, exponent) && spans(box.low.y, box.high.y, exponent) &&
        spans(box.low.z, box.high.z, exponent))
      return exponent;
  throw Failure("reaches beyond 2^29 units, which the core's numbers cannot hold");
}

/// What is added to every 16-bit coordinate of an axis: the steps in the middle of the model.
std::int32_t choose_offset(double low, double high, int exponent) {
  const std::int64_t first = in_steps(low, exponent), last = in_steps(high, exponent);
  return static_cast<std::int32_t>((first + last + 1) >> 1);
}

void check_limit(const char* what, std::size_t count, std::size_t limit) {
  if (count > limit)
    throw Failure("has " + std::to_string(count) + " " + what + ", and a mesh holds at most " + std::to_string(limit));
}

}  // namespace

CoreMesh to_flash_mesh(const Scene& scene) {
  check_limit("vertices", scene.positions.size(), Mesh::max_vertices);
  check_limit("triangles", scene.triangles.size(), most_triangles);
  const BoundingBox box = bounding_box(scene);
  CoreMesh mesh;
  mesh.step_exponent = choose_step(box);
  const int step = mesh.step_exponent;
  mesh.offset = {choose_offset(box.low.x, box.high.x, step), choose_offset(box.low.y, box.high.y, step),
                 choose_offset(box.low.z, box.high.z, step)};
  std::vector<Vec3<std::int64_t>> points;
  for (const Vector3 p : scene.positions) {
    const Vec3<std::int64_t> steps{in_steps(p.x, step) - mesh.offset.x, in_steps(p.y, step) - mesh.offset.y,
                                   in_steps(p.z, step) - mesh.offset.z};
    points.push_back(steps);
    mesh.vertices.push_back(
        {static_cast<std::int16_t>(steps.x), static_cast<std::int16_t>(steps.y), static_cast<std::int16_t>(steps.z)});
  }
  mesh.bounds = bounding_sphere(points);
  for (const Scene::Triangle& triangle : scene.triangles)
    for (const std::uint32_t corner : triangle) mesh.indices.push_back(static_cast<std::uint16_t>(corner));
  for (const Vector3 normal : scene.polygon_normals) mesh.polygon_normals.push_back(to_packed_normal(normal));
  for (const Vector3 normal : scene.vertex_normals) mesh.vertex_normals.push_back(to_packed_normal(normal));
  mesh.polygon_colours = scene.polygon_colours;
  mesh.vertex_colours = scene.vertex_colours;
  mesh.vertex_opacities = scene.vertex_opacities;
  if (!scene.texture_points.empty()) mesh.texture_exponent = texture_exponent_for(scene.texture_points);
  for (const TexturePoint point : scene.texture_points)
    mesh.texture_coordinates.push_back(to_coordinate(point, mesh.texture_exponent));
  if (!scene.polygon_triangles.empty()) join_fans(mesh, scene.polygon_triangles);
  check_limit("polygons", mesh.view().polygon_count(), Mesh::max_polygons);
  return mesh;
}

}  // namespace spanline::sim
