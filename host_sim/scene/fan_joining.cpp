#include "scene/fan_joining.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "spanline/model/planarity.hpp"

namespace spanline::sim {
namespace {

/// Corners of a polygon, vertex numbers.
using Corners = std::vector<std::uint16_t>;
using Vector = Vec3<std::int64_t>;

template <class Table>
bool all_equal(const Table& table, std::size_t first, std::size_t count) {
  if (table.empty()) return true;
  const auto begin = table.begin() + static_cast<std::ptrdiff_t>(first);
  return std::all_of(begin, begin + static_cast<std::ptrdiff_t>(count),
                     [begin](const auto& value) { return value == *begin; });
}

Vector difference(const Vertex32& a, const Vertex32& b) {
  return {std::int64_t{b.x} - a.x, std::int64_t{b.y} - a.y, std::int64_t{b.z} - a.z};
}
Vector cross_product(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
std::int64_t size_of(std::int64_t value) { return value < 0 ? -value : value; }

/// Whether a planar polygon is convex: seen from its front, no three of its corners turn clockwise, taken in their
/// order. So it does not wind twice about anything, either. Corners in a line are allowed.
///
/// Coordinates of the command's meshes are within a ball of 2^30 steps, so that products are at most 2^62 and the areas
/// of convex polygons below 2^63.
bool is_convex(const Mesh& mesh, const Corners& corners) {
  const auto twice_area = [&](std::size_t a, std::size_t b, std::size_t c) {
    const Vertex32 origin = mesh.vertex(corners[a]);
    return cross_product(difference(origin, mesh.vertex(corners[b])), difference(origin, mesh.vertex(corners[c])));
  };
  Vector whole{};
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const Vector part = twice_area(0, i, i + 1);
    whole = {whole.x + part.x, whole.y + part.y, whole.z + part.z};
  }
  // Along the axis that the normal leans to most, the projection is largest.
  const std::int64_t x = size_of(whole.x), y = size_of(whole.y), z = size_of(whole.z);
  const auto along_axis = [&](const Vector& v) { return x >= y && x >= z ? v.x : y >= z ? v.y : v.z; };
  const bool upwards = along_axis(whole) > 0;
  for (std::size_t a = 0; a < corners.size(); ++a) {
    for (std::size_t b = a + 1; b < corners.size(); ++b) {
      for (std::size_t c = b + 1; c < corners.size(); ++c) {
        const std::int64_t area = along_axis(twice_area(a, b, c));
        if (upwards ? area < 0 : area > 0) return false;
      }
    }
  }
  return true;
}

/// Whether the corners may be a polygon of the mesh with the mark.
bool may_be_marked(const Mesh& mesh, const Corners& corners) {
  const auto corner_count = static_cast<std::uint8_t>(corners.size() | Mesh::planar);
  Mesh polygon = mesh;
  polygon.indices = corners;
  polygon.corners = {&corner_count, 1};
  return planarity_of(polygon, 0, 0) == Planarity::planar && is_convex(mesh, corners);
}

class FanJoining {
 public:
  explicit FanJoining(CoreMesh& mesh) : mesh_(mesh), view_(mesh.view()) {}

  void run(std::span<const std::uint8_t> fans) {
    std::size_t first = 0;
    for (const std::uint8_t count : fans) {
      if (const std::optional<Corners> corners = corners_of(first, count))
        add(*corners, Mesh::planar, first);
      else
        for (std::size_t i = first; i < first + count; ++i) add(triangle(i), 0, i);
      first += count;
    }
    if (corners_.size() == first) return;
    mesh_.indices = std::move(indices_);
    mesh_.corners = std::move(corners_);
    mesh_.polygon_normals = std::move(normals_);
    mesh_.polygon_colours = std::move(colours_);
  }

 private:
  [[nodiscard]] Corners triangle(std::size_t number) const {
    const auto first = view_.indices.begin() + static_cast<std::ptrdiff_t>(3 * number);
    return {first, first + 3};
  }

  /// The corners of the polygon that a fan can be, if it can.
  [[nodiscard]] std::optional<Corners> corners_of(std::size_t first, std::size_t count) const {
    if (count < 2 || !all_equal(view_.polygon_normals, first, count) || !all_equal(view_.polygon_colours, first, count))
      return std::nullopt;
    Corners corners = triangle(first);
    for (std::size_t i = first + 1; i < first + count; ++i) {
      const Corners next = triangle(i);
      if (next[0] != corners[0] || next[1] != corners.back()) return std::nullopt;
      corners.push_back(next[2]);
    }
    return may_be_marked(view_, corners) ? std::optional(corners) : std::nullopt;
  }

  /// `number` is that of the polygon's first triangle.
  void add(const Corners& corners, unsigned mark, std::size_t number) {
    indices_.insert(indices_.end(), corners.begin(), corners.end());
    corners_.push_back(static_cast<std::uint8_t>(corners.size() | mark));
    if (!view_.polygon_normals.empty()) normals_.push_back(view_.polygon_normals[number]);
    if (!view_.polygon_colours.empty()) colours_.push_back(view_.polygon_colours[number]);
  }

  CoreMesh& mesh_;
  const Mesh view_;  ///< of the triangles
  std::vector<std::uint16_t> indices_;
  std::vector<std::uint8_t> corners_;
  std::vector<PackedNormal> normals_;
  std::vector<Rgb888> colours_;
};

}  // namespace

void join_fans(CoreMesh& mesh, std::span<const std::uint8_t> fans) { FanJoining(mesh).run(fans); }

}  // namespace spanline::sim
