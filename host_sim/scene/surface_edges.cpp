#include "scene/surface_edges.hpp"

#include <algorithm>
#include <vector>

namespace spanline::sim {
namespace {

/// One side of a face: the edge by its lower and higher vertex, and whether the face goes from low to high.
struct Side {
  std::uint32_t low, high;
  bool upwards;
  bool of_area;  ///< the face is more than a line
};

bool has_area(Vector3 a, Vector3 b, Vector3 c) {
  constexpr double least_sine = 1e-9;
  const Vector3 along = b - a, across = c - a;
  return length(cross(along, across)) > least_sine * length(along) * length(across);
}

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

}  // namespace

SurfaceEdges count_edges(const Scene& scene) {
  Scene bare;
  bare.positions = scene.positions;
  bare.triangles = scene.triangles;
  std::vector<Side> sides;
  const Scene joined = welded(bare);
  for (const auto& [a, b, c] : joined.triangles) {
    if (a == b || b == c || c == a) continue;
    const bool of_area = has_area(joined.positions[a], joined.positions[b], joined.positions[c]);
    for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}})
      sides.push_back({std::min(from, to), std::max(from, to), from < to, of_area});
  }
  std::sort(sides.begin(), sides.end(),
            [](const Side& a, const Side& b) { return a.low != b.low ? a.low < b.low : a.high < b.high; });
  SurfaceEdges edges;
  for (std::size_t first = 0; first < sides.size();) {
    std::size_t end = first, upwards = 0;
    bool of_area = false;
    for (; end < sides.size() && sides[end].low == sides[first].low && sides[end].high == sides[first].high; ++end) {
      upwards += sides[end].upwards;
      of_area |= sides[end].of_area;
    }
    const std::size_t faces = end - first;
    // Faces that are lines may close a crack between others; nothing is seen of them alone.
    if (of_area && faces % 2 != 0)
      ++edges.open;
    else if (of_area && 2 * upwards != faces)
      ++edges.turned;
    first = end;
  }
  return edges;
}

std::string to_string(const SurfaceEdges& edges) {
  std::string text = edges.open == 0 ? "" : counted(edges.open, "open edge");
  if (edges.turned == 0) return text;
  if (!text.empty()) text += " and ";
  return text + counted(edges.turned, "edge") + " between faces that turn opposite ways";
}

}  // namespace spanline::sim
