#pragma once
#include <cstddef>
#include <string>

#include "scene/scene.hpp"

namespace spanline::sim {

/// What keeps a model's surface from being the skin of a solid, which hides the backs of its faces. Vertices of equal
/// positions are one, whatever else they say; edges of faces without area alone do not count.
struct SurfaceEdges {
  std::size_t open = 0;    ///< edges that an odd number of faces meets
  std::size_t turned = 0;  ///< edges whose faces do not go along them in turn, there and back
  [[nodiscard]] bool closed() const { return open == 0 && turned == 0; }
};

[[nodiscard]] SurfaceEdges count_edges(const Scene& scene);

/// "12 open edges and 1 edge between faces that turn opposite ways".
[[nodiscard]] std::string to_string(const SurfaceEdges& edges);

}  // namespace spanline::sim
