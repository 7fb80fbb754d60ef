#pragma once
#include <string>

#include "convert/frame_need.hpp"
#include "scene/core_mesh.hpp"

namespace spanline::sim {

/// What `convert` prints: the bytes of flash by table, and the RAM of a renderer on a 32-bit board that draws this mesh
/// alone, pool by pool.
[[nodiscard]] std::string memory_report(const CoreMesh& mesh, const FrameNeed& need);

}  // namespace spanline::sim
