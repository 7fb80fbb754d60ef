#pragma once
#include <optional>
#include <vector>

#include "scene/view.hpp"

namespace spanline::sim {

/// Light in doubles: a surface with normal n gets min(1, ambient + Σ intensity · max(0, n·towards)).
struct SceneLight {
  double ambient = 1;
  double intensity = 1;          ///< of every directional light
  std::vector<Vector3> towards;  ///< unit vectors from the scene to the lights
};

/// The user's lights, or else one over the viewer's left shoulder that together with the ambient light reaches full
/// brightness.
[[nodiscard]] inline SceneLight resolve_light(const std::vector<Vector3>& lights, std::optional<double> ambient,
                                              const View& view) {
  SceneLight result;
  result.ambient = ambient.value_or(0.2);
  for (const Vector3 light : lights) result.towards.push_back(normalised(light));
  if (!lights.empty()) return result;
  result.towards.push_back(normalised(view.right * -0.5 + view.above * 0.7 + view.backwards));
  result.intensity = 1 - result.ambient;
  return result;
}

}  // namespace spanline::sim
