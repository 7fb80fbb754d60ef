#include "spanline/model/planarity.hpp"

#include "spanline/math/vector.hpp"

namespace spanline {
namespace {

using Vector = Vec3<std::int64_t>;

std::int64_t size_of(std::int64_t value) { return value < 0 ? -value : value; }

/// The corners of a polygon, from its first corner on. Each component is at most 2^17 units, so that components of the
/// normal are below 2^38, and distances times the normal's length below 2^57. A unit is a step of the mesh, or the
/// least power of two of steps in which the polygon reaches no farther.
class Corners {
 public:
  Corners(const Mesh& mesh, std::size_t first_index, unsigned count) : count_(count) {
    const Vertex32 a = mesh.vertex(mesh.indices[first_index]);
    std::int64_t farthest = 0;
    for (unsigned i = 0; i < count; ++i) {
      const Vertex32 b = mesh.vertex(mesh.indices[first_index + i]);
      corner_[i] = {std::int64_t{b.x} - a.x, std::int64_t{b.y} - a.y, std::int64_t{b.z} - a.z};
      for (const std::int64_t c : {corner_[i].x, corner_[i].y, corner_[i].z})
        farthest = size_of(c) > farthest ? size_of(c) : farthest;
    }
    int shift = 0;
    while (farthest > reach << shift) ++shift;
    if (shift == 0) return;
    const std::int64_t half = std::int64_t{1} << (shift - 1);
    for (Vector& c : corner_) c = {(c.x + half) >> shift, (c.y + half) >> shift, (c.z + half) >> shift};
  }

  [[nodiscard]] unsigned count() const { return count_; }
  [[nodiscard]] const Vector& operator[](unsigned number) const { return corner_[number]; }

 private:
  static constexpr std::int64_t reach = std::int64_t{1} << 17;  ///< units

  Vector corner_[Mesh::max_corners]{};
  unsigned count_;
};

/// The polygon's normal by M. Newell's method (Sutherland, Sproull and Schumacker, "A Characterization of Ten
/// Hidden-Surface Algorithms", 1974): twice the areas of its projections along the axes, square units. It is null if
/// the polygon has no area.
Vector normal(const Corners& corners) {
  Vector sum{};
  for (unsigned i = 2; i < corners.count(); ++i) {
    const Vector &before = corners[i - 1], &p = corners[i];
    sum.x += before.y * p.z - before.z * p.y;
    sum.y += before.z * p.x - before.x * p.z;
    sum.z += before.x * p.y - before.y * p.x;
  }
  return sum;
}

/// Whether all corners lie within half a unit of the plane with this normal that lies midway between the outermost of
/// them. Lengths are compared by their highest 31 bits, so that squares fit 64 bits; rounding decides against the
/// polygon.
bool is_flat(const Corners& corners, const Vector& n) {
  std::int64_t lowest = 0, highest = 0;
  for (unsigned i = 1; i < corners.count(); ++i) {
    const Vector& p = corners[i];
    const std::int64_t height = n.x * p.x + n.y * p.y + n.z * p.z;
    lowest = height < lowest ? height : lowest;
    highest = height > highest ? height : highest;
  }
  const std::int64_t length_bound = size_of(n.x) + size_of(n.y) + size_of(n.z), thickness = highest - lowest;
  if (length_bound == 0 || thickness > length_bound) return false;
  int shift = 0;
  while (length_bound >> shift >= std::int64_t{1} << 31) ++shift;
  const auto square = [](std::int64_t v) { return static_cast<std::uint64_t>(v * v); };
  const std::int64_t rounding = (std::int64_t{1} << shift) - 1;
  return square((thickness + rounding) >> shift) <=
         square(size_of(n.x) >> shift) + square(size_of(n.y) >> shift) + square(size_of(n.z) >> shift);
}

/// A corner on the plane of the two axes that the polygon's normal leans on least, where its area is largest.
struct Point {
  std::int64_t x, y;
};
std::int64_t area(Point a, Point b) { return a.x * b.y - a.y * b.x; }

/// Whether `value_of(corner)` is a linear function over the polygon: the one through the three corners of the fan's
/// largest triangle is, at every corner, within two of its numbers and what two units aside change. So much the
/// rounding of four corners and four values may amount to.
template <class ValueOf>
bool is_linear(const Corners& corners, const Vector& n, ValueOf value_of) {
  const std::int64_t x = size_of(n.x), y = size_of(n.y), z = size_of(n.z);
  const auto point = [&](unsigned i) -> Point {
    const Vector& p = corners[i];
    return x >= y && x >= z ? Point{p.y, p.z} : y >= z ? Point{p.z, p.x} : Point{p.x, p.y};
  };
  const auto value = [&](unsigned i) { return std::int64_t{value_of(i)} - value_of(0); };
  unsigned largest = 1;
  for (unsigned i = 2; i + 1 < corners.count(); ++i)
    if (size_of(area(point(i), point(i + 1))) > size_of(area(point(largest), point(largest + 1)))) largest = i;
  const Point b = point(largest), c = point(largest + 1);
  const std::int64_t whole = area(b, c), value_b = value(largest), value_c = value(largest + 1);
  const std::int64_t slope_x = value_b * c.y - value_c * b.y, slope_y = value_c * b.x - value_b * c.x;  // times `whole`
  const std::int64_t allowed = 2 * (size_of(whole) + size_of(slope_x) + size_of(slope_y));
  for (unsigned i = 1; i < corners.count(); ++i) {
    const Point p = point(i);
    if (size_of(slope_x * p.x + slope_y * p.y - value(i) * whole) > allowed) return false;
  }
  return true;
}

}  // namespace

Planarity planarity_of(const Mesh& mesh, std::size_t polygon, std::size_t first_index) {
  const Corners corners(mesh, first_index, mesh.corner_count(polygon));
  const Vector n = normal(corners);
  if (!is_flat(corners, n)) return Planarity::bent;
  const auto linear = [&](auto value_of) {
    return is_linear(corners, n, [&](unsigned corner) { return value_of(mesh.indices[first_index + corner]); });
  };
  if (!mesh.texture_coordinates.empty()) {
    if (!linear([&](std::size_t v) { return mesh.texture_coordinates[v].s; })) return Planarity::unlinear;
    if (!linear([&](std::size_t v) { return mesh.texture_coordinates[v].t; })) return Planarity::unlinear;
  }
  if (!mesh.vertex_colours.empty()) {
    if (!linear([&](std::size_t v) { return mesh.vertex_colours[v].red; })) return Planarity::unlinear;
    if (!linear([&](std::size_t v) { return mesh.vertex_colours[v].green; })) return Planarity::unlinear;
    if (!linear([&](std::size_t v) { return mesh.vertex_colours[v].blue; })) return Planarity::unlinear;
  }
  if (!mesh.vertex_opacities.empty() && !linear([&](std::size_t v) { return mesh.vertex_opacities[v]; }))
    return Planarity::unlinear;
  return Planarity::planar;
}

}  // namespace spanline
