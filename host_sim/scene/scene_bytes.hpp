#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "scene/scene.hpp"

namespace spanline::sim {

/// A scene as bytes of this machine, to pass between processes.
[[nodiscard]] std::vector<std::byte> to_bytes(const Scene& scene);

/// The scene again; nothing if sizes do not fit together, a number is not finite or a vertex number is out of range.
[[nodiscard]] std::optional<Scene> scene_from_bytes(std::span<const std::byte> bytes);

}  // namespace spanline::sim
