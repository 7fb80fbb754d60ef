#include "scene/scene_bytes.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace spanline::sim {
namespace {

template <class T>
void put(std::vector<std::byte>& bytes, const std::vector<T>& table) {
  const std::uint64_t count = table.size();
  const auto* head = reinterpret_cast<const std::byte*>(&count);
  bytes.insert(bytes.end(), head, head + sizeof count);
  const auto* body = reinterpret_cast<const std::byte*>(table.data());
  bytes.insert(bytes.end(), body, body + count * sizeof(T));
}

template <class T>
bool take(std::span<const std::byte>& bytes, std::vector<T>& table) {
  std::uint64_t count = 0;
  if (bytes.size() < sizeof count) return false;
  std::memcpy(&count, bytes.data(), sizeof count);
  bytes = bytes.subspan(sizeof count);
  if (count > bytes.size() / sizeof(T)) return false;
  table.resize(count);
  if (count > 0) std::memcpy(table.data(), bytes.data(), count * sizeof(T));
  bytes = bytes.subspan(count * sizeof(T));
  return true;
}

void put(std::vector<std::byte>& bytes, const ImageSource& source) {
  put(bytes, std::vector<char>(source.name.begin(), source.name.end()));
  put(bytes, std::vector<char>(source.path.begin(), source.path.end()));
  put(bytes, source.bytes);
}

bool take(std::span<const std::byte>& bytes, ImageSource& source) {
  std::vector<char> name, path;
  if (!take(bytes, name) || !take(bytes, path) || !take(bytes, source.bytes)) return false;
  source.name.assign(name.begin(), name.end());
  source.path.assign(path.begin(), path.end());
  return true;
}

void put(std::vector<std::byte>& bytes, const std::vector<SceneImage>& images) {
  put(bytes, std::vector<std::uint8_t>(images.size()));
  for (const SceneImage& image : images) {
    put(bytes, image.colours);
    put(bytes, image.opacities);
  }
}

bool take(std::span<const std::byte>& bytes, std::vector<SceneImage>& images) {
  std::vector<std::uint8_t> count;
  if (!take(bytes, count)) return false;
  images.resize(count.size());
  return std::all_of(images.begin(), images.end(), [&bytes](SceneImage& image) {
    return take(bytes, image.colours) && take(bytes, image.opacities);
  });
}

bool finite_point(TexturePoint p) { return std::isfinite(p.s) && std::isfinite(p.t); }

/// Parts begin at the first triangle, one behind the other.
bool in_order(const std::vector<Scene::Part>& parts, std::size_t triangles, std::size_t images) {
  std::uint64_t least = 0;
  for (const Scene::Part& part : parts) {
    if ((part.image >= images && part.image != Scene::Part::no_image) || part.alpha > AlphaUse::blend ||
        part.wrap_s > PartWrap::mirror || part.wrap_t > PartWrap::mirror)
      return false;
    if (part.highlights.shininess < 1 || part.highlights.shininess > 128) return false;
    if ((least == 0 && part.first != 0) || part.first < least || part.first >= triangles || part.opacity > 255)
      return false;
    least = std::uint64_t{part.first} + 1;
  }
  return true;
}

/// Fans are all triangles, one behind the other, and every part begins with a fan.
bool in_fans(const Scene& scene) {
  if (scene.polygon_triangles.empty()) return true;
  std::size_t first = 0;
  auto part = scene.parts.begin();
  for (const std::uint8_t count : scene.polygon_triangles) {
    if (count < 1 || count > Scene::most_fan_triangles) return false;
    if (part != scene.parts.end() && part->first == first) ++part;
    first += count;
  }
  return first == scene.triangles.size() && part == scene.parts.end();
}

bool consistent(const Scene& scene) {
  const auto none_or = [](std::size_t size, std::size_t wanted) { return size == 0 || size == wanted; };
  const std::size_t vertices = scene.positions.size();
  const std::size_t triangles = scene.triangles.size();
  return none_or(scene.vertex_normals.size(), vertices) && none_or(scene.vertex_colours.size(), vertices) &&
         none_or(scene.vertex_opacities.size(), vertices) && none_or(scene.texture_points.size(), vertices) &&
         none_or(scene.polygon_colours.size(), triangles) && none_or(scene.triangle_objects.size(), triangles) &&
         scene.polygon_normals.size() == triangles && in_order(scene.parts, triangles, scene.images.size()) &&
         in_fans(scene) && std::all_of(scene.positions.begin(), scene.positions.end(), finite) &&
         std::all_of(scene.vertex_normals.begin(), scene.vertex_normals.end(), finite) &&
         std::all_of(scene.texture_points.begin(), scene.texture_points.end(), finite_point) &&
         std::all_of(scene.polygon_normals.begin(), scene.polygon_normals.end(), finite) &&
         std::all_of(scene.triangles.begin(), scene.triangles.end(), [vertices](const Scene::Triangle& t) {
           return t[0] < vertices && t[1] < vertices && t[2] < vertices;
         });
}

}  // namespace

std::vector<std::byte> to_bytes(const Scene& scene) {
  std::vector<std::byte> bytes;
  bytes.reserve(256);
  bytes.push_back(static_cast<std::byte>(scene.normals_from_file));
  put(bytes, scene.positions);
  put(bytes, scene.vertex_normals);
  put(bytes, scene.vertex_colours);
  put(bytes, scene.vertex_opacities);
  put(bytes, scene.texture_points);
  put(bytes, scene.triangles);
  put(bytes, scene.polygon_normals);
  put(bytes, scene.polygon_colours);
  put(bytes, scene.polygon_triangles);
  put(bytes, scene.triangle_objects);
  put(bytes, scene.parts);
  put(bytes, scene.images);
  return bytes;
}

std::optional<Scene> scene_from_bytes(std::span<const std::byte> bytes) {
  Scene scene;
  if (bytes.empty()) return std::nullopt;
  scene.normals_from_file = bytes[0] != std::byte{0};
  bytes = bytes.subspan(1);
  const bool whole = take(bytes, scene.positions) && take(bytes, scene.vertex_normals) &&
                     take(bytes, scene.vertex_colours) && take(bytes, scene.vertex_opacities) &&
                     take(bytes, scene.texture_points) && take(bytes, scene.triangles) &&
                     take(bytes, scene.polygon_normals) && take(bytes, scene.polygon_colours) &&
                     take(bytes, scene.polygon_triangles) && take(bytes, scene.triangle_objects) &&
                     take(bytes, scene.parts) && take(bytes, scene.images) && bytes.empty();
  if (!whole || !consistent(scene)) return std::nullopt;
  return scene;
}

}  // namespace spanline::sim
