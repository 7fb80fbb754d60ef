#pragma once
#include <string>

#include "import/model_format.hpp"
#include "scene/scene.hpp"

namespace spanline::sim {

/// Reads a model through Assimp: `content` is the main file, `path` its name; files that it refers to are opened beside
/// it. Throws std::exception with what is wrong, without the file's name. May crash on hostile content: run it
/// isolated.
[[nodiscard]] Scene read_with_assimp(const std::string& path, ModelFormat format, const std::string& content);

}  // namespace spanline::sim
