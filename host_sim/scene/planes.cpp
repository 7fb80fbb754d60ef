#include "scene/planes.hpp"

#include <cmath>

namespace spanline::sim {
namespace {

/// A far plane more than so many times as far away as the model costs it more bits of its place than a picture can do
/// without.
constexpr double greatest_reach = 64;
/// The share of the range of depth that the model must have: 256 of the 65,536 depths of 16 bits.
constexpr double least_share = 1.0 / 256;

/// The share of the range of depth at a distance z > 0.
double depth_share(const View& view, double z) {
  const double near_plane = view.stated_near_plane, far_plane = view.stated_far_plane;
  if (view.orthographic) return (z - near_plane) / (far_plane - near_plane);
  return (1 - near_plane / z) / (1 - near_plane / far_plane);
}

/// The planes asked for, or planes around the model.
void state_planes(View& view, const ViewRequest& request, DepthRange model, double scale) {
  const double slack = std::max((model.high - model.low) * 0.01, scale * 1e-4);
  double behind_model = model.high + slack;
  if (!view.orthographic && behind_model <= 0) behind_model = scale;  // all of the model lies behind the eye
  double far_plane = request.far_plane.value_or(behind_model);
  double near_plane = model.low - slack;
  if (!view.orthographic) near_plane = std::max(near_plane, std::min(far_plane, behind_model) / 1000);
  if (request.near_plane) near_plane = *request.near_plane;
  if (near_plane >= far_plane && !request.far_plane) far_plane = near_plane + std::max(scale, std::fabs(near_plane));
  if (near_plane >= far_plane && !request.near_plane)
    near_plane = view.orthographic ? far_plane - scale : far_plane / 1000;
  view.stated_near_plane = near_plane;
  view.stated_far_plane = far_plane;
}

/// Planes with nothing of the model between them, where the planes asked for are none that the core could take.
void show_nothing(View& view, DepthRange model, double scale) {
  if (view.orthographic) {
    view.near_plane = model.high + scale;
    view.far_plane = view.near_plane + scale;
  } else {
    view.near_plane = std::max(2 * model.high, scale);
    view.far_plane = 2 * view.near_plane;
  }
  view.nearest_surface = view.near_plane;
}

}  // namespace

void choose_planes(View& view, const ViewRequest& request, DepthRange model, double scale) {
  state_planes(view, request, model, scale);
  view.planes_stated = request.near_plane || request.far_plane;
  view.near_plane = view.stated_near_plane;
  view.far_plane = view.stated_far_plane;
  if (model.high < view.near_plane || model.low > view.far_plane) return show_nothing(view, model, scale);
  // Half a model's size of room, so that a flat one that faces the eye has some depth as well.
  const double room = std::max((model.high - model.low) / 32, scale / 4);
  const double behind = std::min(view.far_plane, model.high + room);
  double before = model.low - room;
  if (!view.orthographic) before = std::max(before, model.low / 2);
  before = std::max(view.near_plane, before);
  view.nearest_surface = std::max(view.near_plane, model.low);
  const bool too_far = !view.orthographic && view.far_plane > greatest_reach * behind;
  if (!too_far && depth_share(view, behind) - depth_share(view, before) >= least_share) return;
  view.near_plane = before;
  view.far_plane = behind;
}

DepthScale::DepthScale(const View& view)
    : changes_(view.near_plane >= view.stated_near_plane && view.far_plane <= view.stated_far_plane &&
               (view.near_plane != view.stated_near_plane || view.far_plane != view.stated_far_plane)) {
  if (!changes_) return;
  offset_ = depth_share(view, view.near_plane);
  factor_ = depth_share(view, view.far_plane) - offset_;
}

std::uint32_t DepthScale::operator()(std::uint32_t depth, int bits, DepthSense sense) const {
  const std::uint32_t greatest = (std::uint32_t{1} << bits) - 1;
  const std::uint32_t nearest = bits == 16 ? Depth16<>::nearest : Depth24<>::nearest;
  const std::uint32_t farthest = bits == 16 ? Depth16<>::farthest : Depth24<>::farthest;
  // The other sense complements the integers.
  const auto towards_far = [&](std::uint32_t d) { return sense == DepthSense::smaller_is_nearer ? d : greatest - d; };
  const double stated = offset_ * greatest + factor_ * towards_far(depth);
  const auto rounded = static_cast<std::uint32_t>(std::llround(std::clamp(stated, 0.0, 1.0 * greatest)));
  return towards_far(std::clamp(rounded, nearest, farthest));
}

}  // namespace spanline::sim
