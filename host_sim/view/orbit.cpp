#include "view/orbit.hpp"

#include <algorithm>
#include <cmath>

namespace spanline::sim {
namespace {

constexpr double greatest_pitch = 1.55;  ///< radians, just below a right angle
constexpr double farthest_factor = 8;    ///< of the distance at home
constexpr double nearest_factor = 0.1;   ///< of the model's radius

}  // namespace

void Orbit::reset() {
  const Vector3 arm = home_.eye - home_.target;
  distance_ = length(arm);
  yaw_ = std::atan2(arm.x, arm.z);
  pitch_ = std::asin(std::clamp(arm.y / distance_, -1.0, 1.0));
}

void Orbit::turn(double right, double up) {
  yaw_ += right;
  pitch_ = std::clamp(pitch_ + up, -greatest_pitch, greatest_pitch);
}

void Orbit::zoom(double factor) {
  const double home = length(home_.eye - home_.target);
  distance_ = std::clamp(distance_ * factor, std::min(home, nearest_factor * radius_), farthest_factor * home);
}

View Orbit::view() const { return view_at(distance_); }

View Orbit::farthest() const { return view_at(farthest_factor * length(home_.eye - home_.target)); }

View Orbit::view_at(double distance) const {
  View view = home_;
  const Vector3 direction{std::sin(yaw_) * std::cos(pitch_), std::sin(pitch_), std::cos(yaw_) * std::cos(pitch_)};
  view.look_at(home_.target + direction * distance, home_.target, {0, 1, 0});
  view.far_plane = distance + radius_ * 1.01;
  view.near_plane = std::max(distance - radius_ * 1.01, view.far_plane / 1000);
  return view;
}

}  // namespace spanline::sim
