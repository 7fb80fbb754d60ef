#pragma once
#include "scene/core_mesh.hpp"

namespace spanline::sim {

/// The scene as one mesh of 16-bit vertices for flash: positions as in the file, rounded to the finest power of two
/// whose steps span the model. Fans that can be are polygons (scene/fan_joining.hpp). Throws Failure, without the
/// file's name, that names the limit a model breaks.
[[nodiscard]] CoreMesh to_flash_mesh(const Scene& scene);

}  // namespace spanline::sim
