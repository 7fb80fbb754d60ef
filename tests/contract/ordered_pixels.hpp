#pragma once
#include <vector>

#include "scene.hpp"

namespace spanline::contract {

/// For each pixel of a scene's picture whether an order of the polygons decides it: no two of the polygons that cover
/// it overlap in depth, wherever they lie. Whoever draws polygons from the farthest to the nearest must be right there.
/// Of instances nothing is known here: with one, no pixel is said to be ordered.
[[nodiscard]] std::vector<bool> ordered_pixels(const Scene& scene);

}  // namespace spanline::contract
