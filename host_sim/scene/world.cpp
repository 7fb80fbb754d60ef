#include "scene/world.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "base/failure.hpp"
#include "scene/core_values.hpp"

namespace spanline::sim {
namespace {

/// Coordinates and distances stay within 2^14 of the 2^15 that Q16.16 holds: differences must fit, too.
constexpr int world_exponent = 14;
constexpr double greatest_focal = 32767;
/// How far off a vertex may be, in world units: its own rounding, and that of the 30 bits of the turn on its way.
constexpr double vertex_error = 1.0 / 32768;
/// How far off it may be in the picture, pixels.
constexpr double greatest_picture_error = 0.25;
/// Binary digits of the world that an orthographic view may give up for the scale of its picture: 2^4 units with their
/// 16 fraction bits are left for the farthest depth.
constexpr int depth_reserve = 10;

/// The least n with value < 2^n.
int exponent_of(double value) {
  int exponent = 0;
  std::frexp(value, &exponent);
  return exponent;
}

/// An orthographic eye may stand anywhere along its line of sight: this moves it so that the near plane lies a little
/// in front of it.
View with_positive_near(View view) {
  if (!view.orthographic) return view;
  const double wanted = (view.far_plane - view.near_plane) / 16;
  const double shift = wanted - view.near_plane;
  view.eye = view.eye + view.backwards * shift;
  view.target = view.target + view.backwards * shift;
  view.near_plane += shift;
  view.far_plane += shift;
  return view;
}

/// The nearer a surface is to the eye, the larger it is in the picture, and the error of its vertices with it.
void check_nearest(const View& view, const World& world, double focal) {
  const double least = std::ldexp(focal * vertex_error / greatest_picture_error, -world.exponent);
  if (view.nearest_surface >= least) return;
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2g", least * 1.05);
  throw UsageError("--near: this near to the eye the model is too large for fixed-point numbers; " +
                   std::string(text.data()) + " is far enough");
}

/// Less than half a step of an 8-bit channel at all that is drawn.
bool too_thin(const FogRequest& fog, const View& view) {
  return (view.far_plane - fog.start) / (fog.end - fog.start) < 1.0 / 512;
}

}  // namespace

World choose_world(const View& given, const Scene& scene, Size size, const std::optional<FogRequest>& fog) {
  const View view = with_positive_near(given);
  const BoundingBox box = bounding_box(scene);
  World world;
  world.origin = box.centre();
  double greatest = std::max({length(box.high - box.low) / 2,
                              length(given.target - world.origin) + length(view.eye - given.target), view.far_plane});
  if (fog && !too_thin(*fog, given)) greatest = std::max(greatest, fog->end / 2);
  world.exponent = world_exponent - exponent_of(greatest);
  if (view.orthographic) {
    // A world unit then is half a pixel to one: the scale of the picture, Q16.16, keeps all its bits. A model that is
    // tiny in the picture keeps those of its depths instead.
    const int of_picture = exponent_of(size.height / view.ortho_height);
    world.exponent = std::max(std::min(world.exponent, of_picture), world.exponent - depth_reserve);
  }
  return world;
}

Camera to_camera(const View& given, const World& world, Size size) {
  const View view = with_positive_near(given);
  Camera camera;
  const double focal = view.orthographic ? std::ldexp(size.height / view.ortho_height, -world.exponent)
                                         : size.height / (2 * std::tan(view.field_of_view * std::numbers::pi / 360));
  const char* const option = view.orthographic ? "--ortho" : "--fov";
  if (!(focal < (view.orthographic ? greatest_picture_error / vertex_error : greatest_focal)))
    throw UsageError(std::string(option) + ": the view is too narrow for this picture");
  camera.focal = to_fixed<Q16_16>(focal);
  if (camera.focal.raw() <= 0) throw UsageError(std::string(option) + ": the view is too wide for this picture");
  camera.projection = view.orthographic ? Projection::orthographic : Projection::perspective;
  const Vector3 eye = world.to_world(view.eye);
  camera.eye = {to_fixed<Q16_16>(eye.x), to_fixed<Q16_16>(eye.y), to_fixed<Q16_16>(eye.z)};
  camera.axes = {{to_direction(view.right), to_direction(view.above), to_direction(view.backwards)}};
  camera.near_plane = to_fixed<Q16_16>(std::ldexp(view.near_plane, world.exponent));
  camera.far_plane = to_fixed<Q16_16>(std::ldexp(view.far_plane, world.exponent));
  if (!view.orthographic) check_nearest(view, world, focal);
  if (camera.near_plane.raw() <= 0 || camera.near_plane >= camera.far_plane)
    throw UsageError(view.planes_stated ? "--near and --far lie too close to each other for fixed-point numbers"
                                        : std::string(view.distance_option) + ": too far away from the model");
  return camera;
}

Volume to_volume(const VolumeTexture& solid, const Scene& scene, const World& world) {
  const BoundingBox box = bounding_box(scene);
  const Vector3 low = world.to_world(box.low), high = world.to_world(box.high), middle = (low + high) * 0.5;
  const double side = std::max({high.x - low.x, high.y - low.y, high.z - low.z, 1.0 / 65536});
  Volume volume;
  volume.source = SolidSource::table;
  volume.texture = &solid;
  int exponent = 0;
  const double scale = std::frexp(1 / side, &exponent);
  volume.scale = to_fixed<Q16_16>(scale);
  volume.exponent = static_cast<std::int8_t>(exponent);
  const auto origin = [&](double centre) { return to_fixed<Q16_16>(0.5 - centre / side); };
  volume.origin = {origin(middle.x), origin(middle.y), origin(middle.z)};
  return volume;
}

Fog to_fog(const FogRequest& fog, const View& view, const World& world) {
  // The eye of an orthographic view may have been moved back.
  const double moved = with_positive_near(view).near_plane - view.near_plane;
  if (too_thin(fog, view)) return {};
  constexpr double greatest = 32767, least = 1.0 / 65536;
  const double start = std::min(std::ldexp(fog.start + moved, world.exponent), greatest - 1);
  const double end = std::clamp(std::ldexp(fog.end + moved, world.exponent), start + least, greatest);
  return {FogCurve::linear, to_fixed<Q16_16>(start), to_fixed<Q16_16>(end), fog.colour};
}

}  // namespace spanline::sim
