#include "scene/view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "base/failure.hpp"
#include "scene/planes.hpp"

namespace spanline::sim {
namespace {

constexpr double default_field_of_view = 45;
/// From the model towards the eye: from the front, a little from the right and from above.
constexpr Vector3 default_direction{0.45, 0.35, 1};
/// Free space around a framed model, a share of the picture.
constexpr double margin = 1.05;
/// Sines of angles below this count as parallel.
constexpr double parallel_limit = 1e-9;

bool parallel(Vector3 a, Vector3 b) { return length(cross(normalised(a), normalised(b))) < parallel_limit; }

/// y is up, unless the view runs along y.
Vector3 default_up(Vector3 backwards) {
  if (!parallel(backwards, {0, 1, 0})) return {0, 1, 0};
  return {0, 0, backwards.y > 0 ? -1.0 : 1.0};
}

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// The greatest distance of a vertex from a point.
double radius_about(const Scene& scene, Vector3 centre) {
  double radius = 0;
  for (const Scene::Triangle& triangle : scene.triangles)
    for (const std::uint32_t corner : triangle) radius = std::max(radius, length(scene.positions[corner] - centre));
  return radius;
}

/// Places eye and distance so that the model fits.
class Framing {
 public:
  Framing(const Scene& scene, Size size, bool turns)
      : scene_(scene), aspect_(static_cast<double>(size.width) / size.height), turns_(turns) {}

  /// How far the eye must stand from the target for every vertex to lie inside the picture.
  [[nodiscard]] double perspective_distance(const View& view) const {
    const double tangent_v = std::tan(radians(view.field_of_view) / 2);
    const double tangent_h = tangent_v * aspect_;
    const double radius = radius_about(scene_, view.target);
    if (turns_) return margin * radius / std::sin(std::atan(std::min(tangent_v, tangent_h)));
    double distance = 0;
    for_each_vertex([&](Vector3 p) {
      const Vector3 d = p - view.target;
      const double depth = dot(d, view.backwards);
      distance = std::max({distance, depth + margin * std::fabs(dot(d, view.right)) / tangent_h,
                           depth + margin * std::fabs(dot(d, view.above)) / tangent_v});
    });
    // A narrow model seen end on must not reach the eye.
    return std::max(distance, margin * radius);
  }

  [[nodiscard]] DepthRange depths(const View& view) const {
    DepthRange range;
    if (turns_) {
      const double radius = radius_about(scene_, view.target);
      range.include(view.depth(view.target) - radius);
      range.include(view.depth(view.target) + radius);
    } else {
      for_each_vertex([&](Vector3 p) { range.include(view.depth(p)); });
    }
    return range;
  }

 private:
  template <class Visit>
  void for_each_vertex(Visit visit) const {
    for (const Scene::Triangle& triangle : scene_.triangles)
      for (const std::uint32_t corner : triangle) visit(scene_.positions[corner]);
  }

  const Scene& scene_;
  double aspect_;
  bool turns_;
};

/// Squares of distances must be numbers.
void check_place(const std::string& option, const std::optional<Vector3>& place) {
  constexpr double greatest = 1e100;
  if (place && !(std::max({std::fabs(place->x), std::fabs(place->y), std::fabs(place->z)}) < greatest))
    throw UsageError(option + ": too far away");
}

/// A still view has the same picture wherever on its line of sight the target lies, and the core's world must reach
/// that far.
void bring_target_near(View& view, double limit) {
  if (length(view.eye - view.target) > limit) view.target = view.eye - view.backwards * limit;
}

}  // namespace

void View::look_at(Vector3 from, Vector3 to, Vector3 up_direction) {
  eye = from;
  target = to;
  up = normalised(up_direction);
  backwards = normalised(from - to);
  right = normalised(cross(up, backwards));
  above = cross(backwards, right);
}

void check_request(const ViewRequest& request) {
  check_place("--eye", request.eye);
  check_place("--target", request.target);
  if (request.ortho_height && request.field_of_view) throw UsageError("--fov and --ortho exclude each other");
  if (request.ortho_height && *request.ortho_height <= 0) throw UsageError("--ortho: the height must be above 0");
  if (request.field_of_view && (*request.field_of_view <= 0 || *request.field_of_view >= 180))
    throw UsageError("--fov: the angle must lie between 0 and 180 degrees");
  if (!request.ortho_height) {
    if (request.near_plane && *request.near_plane <= 0) throw UsageError("--near: must be above 0");
    if (request.far_plane && *request.far_plane <= 0) throw UsageError("--far: must be above 0");
  }
  if (request.near_plane && request.far_plane && *request.near_plane >= *request.far_plane)
    throw UsageError("--near: must be less than --far");
  if (request.eye && request.target && *request.eye == *request.target)
    throw UsageError("--eye and --target are the same point");
  if (request.up && *request.up == Vector3{}) throw UsageError("--up: has no direction");
  if (request.up && request.eye && request.target && parallel(*request.up, *request.eye - *request.target))
    throw UsageError("--up: is parallel to the line of sight");
}

View resolve_view(const ViewRequest& request, const Scene& scene, Size size, bool turns) {
  const Framing framing(scene, size, turns);
  View view;
  view.orthographic = request.ortho_height.has_value();
  view.distance_option = request.eye ? "--eye" : request.target ? "--target" : "--fov";
  view.ortho_height = request.ortho_height.value_or(1);
  view.field_of_view = request.field_of_view.value_or(default_field_of_view);
  const Vector3 centre = bounding_box(scene).centre();
  Vector3 target = request.target.value_or(centre);
  if (request.eye && *request.eye == target) target = *request.eye - default_direction;  // an eye inside the model
  const Vector3 backwards = normalised(request.eye ? *request.eye - target : default_direction);
  const Vector3 up = request.up.value_or(default_up(backwards));
  if (parallel(up, backwards)) throw UsageError("--up: is parallel to the line of sight");
  const double radius = radius_about(scene, target);
  const double scale = radius > 0 ? radius : 1;
  view.look_at(request.eye.value_or(target + backwards * (2 * scale)), target, up);
  if (!request.eye && !view.orthographic) {
    double distance = framing.perspective_distance(view);
    if (!(distance > 0)) distance = 2 * scale;
    view.look_at(target + backwards * distance, target, up);
  }
  const double own_radius = radius_about(scene, centre);
  if (!turns) bring_target_near(view, length(view.eye - centre) + own_radius);
  choose_planes(view, request, framing.depths(view), own_radius > 0 ? own_radius : 1);
  return view;
}

View turned(const View& view, double turns) {
  View result = view;
  const Vector3 arm = turned(view, view.eye - view.target, turns);
  result.look_at(view.target + arm, view.target, view.up);
  return result;
}

Vector3 turned(const View& view, Vector3 direction, double turns) {
  return rotated(direction, view.up, -turns * 2 * std::numbers::pi);
}

}  // namespace spanline::sim
