#pragma once
#include <cstdint>

namespace spanline::sim {

enum class ModelFormat : std::uint8_t { obj, gltf, glb, ply, stl };

}  // namespace spanline::sim
