#pragma once
#include <optional>

#include "base/parse.hpp"
#include "base/vector.hpp"
#include "scene/scene.hpp"

namespace spanline::sim {

/// What the user said about the camera; what is missing is chosen so that the whole model is seen.
struct ViewRequest {
  std::optional<Vector3> eye, target, up;
  std::optional<double> field_of_view;  ///< vertical, degrees
  std::optional<double> ortho_height;   ///< height of an orthographic view, model units
  std::optional<double> near_plane, far_plane;
};

/// A camera, complete, in model units and doubles.
struct View {
  Vector3 eye, target, up;
  Vector3 right, above, backwards;  ///< unit axes of the picture
  bool orthographic = false;
  double field_of_view = 45;                           ///< perspective: vertical, degrees
  double ortho_height = 1;                             ///< orthographic: model units
  double near_plane = 1, far_plane = 2;                ///< what the picture is drawn between
  double stated_near_plane = 1, stated_far_plane = 2;  ///< what was asked for: depths are told by these
  bool planes_stated = false;                          ///< either of them by the user
  const char* distance_option = "--eye";               ///< what the distance from the model comes from
  double nearest_surface = 1;                          ///< perspective: least depth of what may be seen

  /// Turns the camera: sets eye, target, up and the axes. `up` must not be parallel to the line of sight.
  void look_at(Vector3 from, Vector3 to, Vector3 up_direction);
  /// Depth of a point along the line of sight.
  [[nodiscard]] double depth(Vector3 point) const { return dot(eye - point, backwards); }
};

/// Finds what is wrong with a request without knowing the model. Throws UsageError.
void check_request(const ViewRequest& request);

/// The camera of a request. A view that turns about its target keeps the whole model in sight at every angle.
/// Throws UsageError for what only the model shows (the eye at its centre, near beyond everything).
[[nodiscard]] View resolve_view(const ViewRequest& request, const Scene& scene, Size size, bool turns);

/// The view when the model has turned by `turns` (1 is full circle) about the upward axis through the target,
/// counter-clockwise when seen from above.
[[nodiscard]] View turned(const View& view, double turns);

/// A direction that belongs to the viewer, such as the light, under the same turn.
[[nodiscard]] Vector3 turned(const View& view, Vector3 direction, double turns);

}  // namespace spanline::sim
