#pragma once
#include <string>

#include "scene/scene.hpp"

struct aiScene;

namespace spanline::sim {

/// All meshes of all nodes, in the order of the nodes, with the nodes' transforms applied. Polygons become fans; points
/// and lines are dropped; every node with a triangle is an object; nodes that mirror turn their triangles over. Throws
/// std::runtime_error for numbers that are not finite, indices out of range and scenes without a triangle. Images that
/// materials name count from the folder of `path`, and are not read.
[[nodiscard]] Scene build_scene(const aiScene& file, const std::string& path, bool keep_normals);

}  // namespace spanline::sim
