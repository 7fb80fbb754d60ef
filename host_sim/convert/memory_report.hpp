#pragma once
#include <string>

#include "scene/core_mesh.hpp"

namespace spanline::sim {

/// What `convert` prints: flash by table, and the RAM that a frame of 320×240 with this mesh alone needs.
[[nodiscard]] std::string memory_report(const CoreMesh& mesh);

}  // namespace spanline::sim
