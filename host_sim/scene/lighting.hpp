#pragma once
#include <optional>
#include <vector>

#include "scene/view.hpp"

namespace spanline::sim {

/// A light at a point, in units of the model.
struct ScenePointLight {
  Vector3 position;
  double range = 0;  ///< where it has faded to nothing; 0: it does not fade
};

/// Light in doubles: a surface with normal n gets min(1, ambient + Σ intensity · max(0, n·towards)), and from point
/// lights as the core's `PointLight` says.
struct SceneLight {
  double ambient = 1;
  double intensity = 1;          ///< of every light
  std::vector<Vector3> towards;  ///< unit vectors from the scene to the lights
  std::vector<ScenePointLight> points;
};

/// The user's lights, or else one over the viewer's left shoulder that together with the ambient light reaches full
/// brightness.
[[nodiscard]] inline SceneLight resolve_light(const std::vector<Vector3>& lights,
                                              const std::vector<ScenePointLight>& points, std::optional<double> ambient,
                                              const View& view) {
  SceneLight result;
  result.ambient = ambient.value_or(0.2);
  for (const Vector3 light : lights) result.towards.push_back(normalised(light));
  result.points = points;
  if (!lights.empty() || !points.empty()) return result;
  result.towards.push_back(normalised(view.right * -0.5 + view.above * 0.7 + view.backwards));
  result.intensity = 1 - result.ambient;
  return result;
}

}  // namespace spanline::sim
