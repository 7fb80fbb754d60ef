#pragma once
#include "scene/view.hpp"

namespace spanline::sim {

/// A camera that goes round a model on a sphere and always looks at its middle.
class Orbit {
 public:
  /// Starts at `home`; `radius` is the model's, about the target.
  Orbit(const View& home, double radius) : home_(home), radius_(radius) { reset(); }

  void reset();
  /// Radians; the poles themselves are out of reach.
  void turn(double right, double up);
  /// The distance times `factor`, within bounds.
  void zoom(double factor);

  [[nodiscard]] View view() const;
  /// The view that stands farthest away.
  [[nodiscard]] View farthest() const;

 private:
  [[nodiscard]] View view_at(double distance) const;

  View home_;
  double radius_;
  double yaw_ = 0, pitch_ = 0, distance_ = 0;
};

}  // namespace spanline::sim
