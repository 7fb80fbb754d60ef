#pragma once
#include <cstdint>
#include <span>

#include "spanline/model/camera.hpp"
#include "spanline/model/mesh.hpp"
#include "spanline/model/transform.hpp"

namespace spanline {

/// An instance with its place in world space.
struct PlacedInstance {
  const Mesh* mesh = nullptr;
  Transform transform{};
  std::uint32_t group = 0;  ///< number of the instance's group in the frame's polygon table
};

/// The part of a frame's input that lies in world space. Algorithms that walk a tree or cast rays need it, and so does
/// code that sorts instances before they are submitted.
struct World {
  Camera camera{};
  std::span<const PlacedInstance> instances{};  ///< in order of submission, without the instances outside the view
};

}  // namespace spanline
