#pragma once
#include <string>

#include "scene/scene.hpp"

namespace spanline::sim {

/// Reads a model: OBJ, glTF, GLB, PLY or STL by the ending of its name. Transforms of all nodes are applied.
///
/// Throws Failure that names the file for whatever is missing, broken, truncated, empty or without a triangle. The
/// importer runs in a process of its own, so that a hostile file can crash or fill nothing but that.
[[nodiscard]] Scene import_model(const std::string& path);

}  // namespace spanline::sim
