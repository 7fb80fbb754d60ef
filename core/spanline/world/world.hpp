#pragma once
#include <cstdint>
#include <span>

#include "spanline/model/camera.hpp"
#include "spanline/model/mesh.hpp"
#include "spanline/model/transform.hpp"

namespace spanline {

/// An instance as it stands in space.
struct PlacedInstance {
  const Mesh* mesh = nullptr;
  Transform transform{};
  std::uint32_t group = 0;  ///< number of its group in the frame's polygon table
};

/// What of a frame lies in world space: for algorithms that walk a tree or cast rays, and for what orders instances
/// before they are submitted.
struct World {
  Camera camera{};
  std::span<const PlacedInstance> instances{};  ///< in order of submission; those outside the view are left out
};

}  // namespace spanline
