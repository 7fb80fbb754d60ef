#include "scene/scene.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <unordered_map>

namespace spanline::sim {
namespace {

/// All that tells one vertex from another, as bits: doubles compare by value (−0 is 0), so equal bits are equal values.
struct VertexKey {
  std::array<std::uint64_t, 9> words{};
  friend bool operator==(const VertexKey&, const VertexKey&) = default;

  void put(std::size_t at, Vector3 v) {
    words[at] = std::bit_cast<std::uint64_t>(v.x + 0.0);
    words[at + 1] = std::bit_cast<std::uint64_t>(v.y + 0.0);
    words[at + 2] = std::bit_cast<std::uint64_t>(v.z + 0.0);
  }
};

struct VertexKeyHash {
  std::size_t operator()(const VertexKey& key) const {
    std::uint64_t hash = 0;
    for (const std::uint64_t word : key.words) {
      // 2^64 divided by the golden ratio: the odd constant of Fibonacci hashing.
      hash = (std::rotl(hash, 23) ^ word) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 32;
    }
    return static_cast<std::size_t>(hash);
  }
};

template <class Table, class Value>
void push_if_used(Table& table, bool used, const Value& value) {
  if (used) table.push_back(value);
}

}  // namespace

bool is_see_through(const Scene& scene) {
  return !scene.vertex_opacities.empty() || std::any_of(scene.parts.begin(), scene.parts.end(),
                                                        [](const Scene::Part& part) { return part.opacity < 255; });
}

bool is_textured(const Scene& scene) {
  return !scene.texture_points.empty() && std::any_of(scene.parts.begin(), scene.parts.end(), [](const Scene::Part& p) {
    return p.image != Scene::Part::no_image;
  });
}

bool has_different_highlights(const Scene& scene) {
  return std::any_of(scene.parts.begin(), scene.parts.end(),
                     [&](const Scene::Part& part) { return part.highlights != scene.parts[0].highlights; });
}

void set_highlights(Scene& scene, const Highlights& highlights) {
  if (scene.parts.empty()) scene.parts.emplace_back();
  for (Scene::Part& part : scene.parts) part.highlights = highlights;
}

void fade(Scene& scene, double opacity) {
  if (scene.parts.empty()) scene.parts.emplace_back();
  for (Scene::Part& part : scene.parts) part.opacity = static_cast<std::uint32_t>(part.opacity * opacity + 0.5);
}

BoundingBox bounding_box(const Scene& scene) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  BoundingBox box{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
  for (const Scene::Triangle& triangle : scene.triangles) {
    for (const std::uint32_t corner : triangle) {
      const Vector3 p = scene.positions[corner];
      box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
      box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
    }
  }
  return box;
}

Scene welded(const Scene& scene) {
  Scene result;
  result.polygon_normals = scene.polygon_normals;
  result.polygon_colours = scene.polygon_colours;
  result.polygon_triangles = scene.polygon_triangles;
  result.triangle_objects = scene.triangle_objects;
  result.parts = scene.parts;
  result.images = scene.images;
  result.colour = scene.colour;
  result.normals_from_file = scene.normals_from_file;
  result.triangles.reserve(scene.triangles.size());
  const bool normals = !scene.vertex_normals.empty();
  const bool colours = !scene.vertex_colours.empty();
  const bool opacities = !scene.vertex_opacities.empty();
  const bool textured = !scene.texture_points.empty();
  std::unordered_map<VertexKey, std::uint32_t, VertexKeyHash> numbers;
  numbers.reserve(scene.positions.size());
  for (const Scene::Triangle& triangle : scene.triangles) {
    Scene::Triangle corners{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t old = triangle[i];
      const Vector3 normal = normals ? scene.vertex_normals[old] : Vector3{};
      const Rgb888 colour = colours ? scene.vertex_colours[old] : Rgb888{};
      VertexKey key;
      key.put(0, scene.positions[old]);
      key.put(3, normal);
      const std::uint8_t opacity = opacities ? scene.vertex_opacities[old] : std::uint8_t{255};
      key.words[6] = std::uint64_t{opacity} << 24 | std::uint64_t{colour.red} << 16 | std::uint64_t{colour.green} << 8 |
                     colour.blue;
      const TexturePoint point = textured ? scene.texture_points[old] : TexturePoint{};
      key.words[7] = std::bit_cast<std::uint64_t>(point.s + 0.0);
      key.words[8] = std::bit_cast<std::uint64_t>(point.t + 0.0);
      const auto [entry, is_new] = numbers.try_emplace(key, static_cast<std::uint32_t>(result.positions.size()));
      if (is_new) {
        result.positions.push_back(scene.positions[old]);
        push_if_used(result.vertex_normals, normals, normal);
        push_if_used(result.vertex_colours, colours, colour);
        push_if_used(result.vertex_opacities, opacities, opacity);
        push_if_used(result.texture_points, textured, point);
      }
      corners[i] = entry->second;
    }
    result.triangles.push_back(corners);
  }
  return result;
}

void complete_vertex_normals(Scene& scene) {
  const auto missing = [](Vector3 n) { return n == Vector3{}; };
  scene.vertex_normals.resize(scene.positions.size());
  if (std::none_of(scene.vertex_normals.begin(), scene.vertex_normals.end(), missing)) return;
  // Sums over all vertices of a position, so that attributes which differ leave no crease.
  Scene bare;
  bare.positions = scene.positions;
  bare.triangles = scene.triangles;
  const Scene joined = welded(bare);
  std::vector<Vector3> sums(joined.positions.size());
  for (const Scene::Triangle& t : joined.triangles) {
    const Vector3 origin = joined.positions[t[0]];
    const Vector3 twice_area = cross(joined.positions[t[1]] - origin, joined.positions[t[2]] - origin);
    for (const std::uint32_t corner : t) sums[corner] = sums[corner] + twice_area;
  }
  for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      Vector3& normal = scene.vertex_normals[scene.triangles[i][k]];
      if (missing(normal)) normal = normalised(sums[joined.triangles[i][k]]);
    }
  }
}

void complete_polygon_colours(Scene& scene) {
  if (!scene.polygon_colours.empty() || scene.vertex_colours.empty()) return;
  for (const Scene::Triangle& t : scene.triangles) {
    const auto mean = [&](auto channel) {
      const int sum = scene.vertex_colours[t[0]].*channel + scene.vertex_colours[t[1]].*channel +
                      scene.vertex_colours[t[2]].*channel;
      return static_cast<std::uint8_t>((sum + 1) / 3);
    };
    scene.polygon_colours.push_back({mean(&Rgb888::red), mean(&Rgb888::green), mean(&Rgb888::blue)});
  }
}

void simplify_colours(Scene& scene) {
  const std::vector<Rgb888>& colours = scene.polygon_colours;
  if (colours.empty() || !std::all_of(colours.begin(), colours.end(), [&](Rgb888 c) { return c == colours[0]; }))
    return;
  scene.colour = colours[0];
  scene.polygon_colours.clear();
}

void polygon_colours_to_vertices(Scene& scene) {
  if (scene.polygon_colours.empty() || !scene.vertex_colours.empty()) return;
  Scene split = scene;
  split.positions.clear();
  split.vertex_normals.clear();
  split.vertex_opacities.clear();
  split.texture_points.clear();
  for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t old = scene.triangles[i][k];
      split.triangles[i][k] = static_cast<std::uint32_t>(split.positions.size());
      split.positions.push_back(scene.positions[old]);
      const auto take_over = [old](const auto& from, auto& to) {
        if (!from.empty()) to.push_back(from[old]);
      };
      take_over(scene.vertex_normals, split.vertex_normals);
      take_over(scene.vertex_opacities, split.vertex_opacities);
      take_over(scene.texture_points, split.texture_points);
      split.vertex_colours.push_back(scene.polygon_colours[i]);
    }
  }
  scene = std::move(split);
}

}  // namespace spanline::sim
