#include "scene/displacement.hpp"

#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "base/failure.hpp"

namespace spanline::sim {
namespace {

Rgb888 mean(Rgb888 a, Rgb888 b) {
  const auto channel = [](int x, int y) { return static_cast<std::uint8_t>((x + y + 1) / 2); };
  return {channel(a.red, b.red), channel(a.green, b.green), channel(a.blue, b.blue)};
}

/// Divides every triangle into four.
class Subdivision {
 public:
  explicit Subdivision(Scene& scene) : scene_(scene) {}

  void run() {
    const std::vector<Scene::Triangle> before = std::move(scene_.triangles);
    const std::vector<Rgb888> colours = std::move(scene_.polygon_colours);
    const std::vector<std::uint32_t> objects = std::move(scene_.triangle_objects);
    scene_.triangles.clear();
    scene_.polygon_colours.clear();
    scene_.triangle_objects.clear();
    for (std::size_t i = 0; i < before.size(); ++i) {
      const auto [a, b, c] = before[i];
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      for (const Scene::Triangle& part : {Scene::Triangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}}) {
        scene_.triangles.push_back(part);
        if (!colours.empty()) scene_.polygon_colours.push_back(colours[i]);
        if (!objects.empty()) scene_.triangle_objects.push_back(objects[i]);
      }
    }
    for (Scene::Part& part : scene_.parts) part.first *= 4;
  }

 private:
  /// The vertex in the middle of an edge; neighbours get the same.
  std::uint32_t middle(std::uint32_t a, std::uint32_t b) {
    const std::uint64_t key = a < b ? std::uint64_t{a} << 32 | b : std::uint64_t{b} << 32 | a;
    const auto [entry, made] = middles_.try_emplace(key, static_cast<std::uint32_t>(scene_.positions.size()));
    if (made) {
      scene_.positions.push_back((scene_.positions[a] + scene_.positions[b]) * 0.5);
      const TexturePoint p = scene_.texture_points[a], q = scene_.texture_points[b];
      scene_.texture_points.push_back({(p.s + q.s) / 2, (p.t + q.t) / 2});
      if (!scene_.vertex_colours.empty())
        scene_.vertex_colours.push_back(mean(scene_.vertex_colours[a], scene_.vertex_colours[b]));
      if (!scene_.vertex_opacities.empty())
        scene_.vertex_opacities.push_back(
            static_cast<std::uint8_t>((scene_.vertex_opacities[a] + scene_.vertex_opacities[b] + 1) / 2));
    }
    return entry->second;
  }

  Scene& scene_;
  std::unordered_map<std::uint64_t, std::uint32_t> middles_;
};

/// A point of the surface and what its vertices, one or more, say of it.
struct SurfacePoint {
  Vector3 normal{};
  double height = 0;
  int vertices = 0;
};

void move(Scene& scene, const HeightImage& heights, double amount) {
  using Key = std::tuple<double, double, double>;
  const auto key = [](Vector3 p) { return Key{p.x + 0.0, p.y + 0.0, p.z + 0.0}; };  // −0 is 0
  std::map<Key, SurfacePoint> points;
  std::vector<SurfacePoint*> point_of;
  for (std::size_t i = 0; i < scene.positions.size(); ++i) {
    SurfacePoint& point = points[key(scene.positions[i])];
    point.height += heights.at(scene.texture_points[i].s, scene.texture_points[i].t);
    ++point.vertices;
    point_of.push_back(&point);
  }
  for (const auto& [a, b, c] : scene.triangles) {
    const Vector3 twice_area = cross(scene.positions[b] - scene.positions[a], scene.positions[c] - scene.positions[a]);
    for (const std::uint32_t corner : {a, b, c}) point_of[corner]->normal = point_of[corner]->normal + twice_area;
  }
  for (std::size_t i = 0; i < scene.positions.size(); ++i) {
    const SurfacePoint& point = *point_of[i];
    scene.positions[i] = scene.positions[i] + normalised(point.normal) * (amount * point.height / point.vertices);
  }
}

}  // namespace

Scene displaced(const Scene& scene, const HeightImage& heights, const DisplacementRequest& request) {
  if (scene.texture_points.empty()) throw Failure("has no texture coordinates, which displacement wants");
  const double triangles = static_cast<double>(scene.triangles.size()) * std::pow(4, request.levels);
  if (triangles > static_cast<double>(most_displaced_triangles))
    throw Failure("would have " + std::to_string(static_cast<long long>(triangles)) +
                  " triangles after so many subdivisions; at most " + std::to_string(most_displaced_triangles) +
                  " are made");
  Scene result = scene;
  result.vertex_normals.clear();
  result.polygon_triangles.clear();
  for (int level = 0; level < request.levels; ++level) Subdivision(result).run();
  move(result, heights, request.amount);
  result.polygon_normals.clear();
  for (const auto& [a, b, c] : result.triangles) {
    const Vector3 origin = result.positions[a];
    result.polygon_normals.push_back(normalised(cross(result.positions[b] - origin, result.positions[c] - origin)));
  }
  complete_vertex_normals(result);
  return result;
}

}  // namespace spanline::sim
