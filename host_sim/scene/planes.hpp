#pragma once
#include <algorithm>
#include <cstdint>
#include <limits>

#include "scene/view.hpp"
#include "spanline/raster/depth_format.hpp"

namespace spanline::sim {

/// Depths that a model takes along the axis of view, in its own units.
struct DepthRange {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

/// Sets the planes of a view: those asked for, and where none are, planes around the model with near at least a
/// thousandth of far, as depth loses its precision by that ratio.
///
/// Planes that lie so far from the model that fixed-point numbers or the bits of depth would lose it are moved towards
/// it for drawing. Nothing is there to be cut off, so the picture stays; `DepthScale` tells its depths by the planes
/// asked for. `scale` is a length of the model's size.
void choose_planes(View& view, const ViewRequest& request, DepthRange model, double scale);

/// Makes depth integers of the planes that a picture was drawn between those of the planes asked for: both are linear
/// in 1/z, or in z where the view is orthographic. As the drawn range lies within the stated one, errors shrink.
class DepthScale {
 public:
  explicit DepthScale(const View& view);

  /// A depth integer as the core's formats have it; not the background's.
  [[nodiscard]] std::uint32_t operator()(std::uint32_t depth, int bits, DepthSense sense) const;
  [[nodiscard]] bool changes() const { return changes_; }

 private:
  bool changes_ = false;
  double offset_ = 0, factor_ = 1;  ///< of depths as shares of their range
};

}  // namespace spanline::sim
