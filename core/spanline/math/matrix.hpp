#pragma once
#include "spanline/math/trigonometry.hpp"
#include "spanline/math/vector.hpp"

namespace spanline {

/// A rotation matrix of three orthonormal rows, Q2.30.
struct Rotation {
  Direction row[3] = {{Q2_30::from_int(1), {}, {}}, {{}, Q2_30::from_int(1), {}}, {{}, {}, Q2_30::from_int(1)}};

  [[nodiscard]] constexpr Direction column(int i) const {
    const auto pick = [i](const Direction& d) { return i == 0 ? d.x : i == 1 ? d.y : d.z; };
    return {pick(row[0]), pick(row[1]), pick(row[2])};
  }
  [[nodiscard]] constexpr Rotation transposed() const { return {{column(0), column(1), column(2)}}; }
  friend constexpr Direction operator*(const Rotation& m, Direction v) {
    return {dot(m.row[0], v), dot(m.row[1], v), dot(m.row[2], v)};
  }
  friend constexpr Rotation operator*(const Rotation& a, const Rotation& b) {
    const Rotation t = b.transposed();
    Rotation product;
    for (int i = 0; i < 3; ++i) product.row[i] = t * a.row[i];
    return product;
  }
};

/// Rotations about the x, y or z axis, counter-clockwise for a viewer to whom the axis points (right-handed, as in
/// OpenGL).
[[nodiscard]] constexpr Rotation rotation_x(Angle angle) {
  const Q2_30 s = sine(angle), c = cosine(angle), one = Q2_30::from_int(1);
  return {{{one, {}, {}}, {{}, c, -s}, {{}, s, c}}};
}
[[nodiscard]] constexpr Rotation rotation_y(Angle angle) {
  const Q2_30 s = sine(angle), c = cosine(angle), one = Q2_30::from_int(1);
  return {{{c, {}, s}, {{}, one, {}}, {-s, {}, c}}};
}
[[nodiscard]] constexpr Rotation rotation_z(Angle angle) {
  const Q2_30 s = sine(angle), c = cosine(angle), one = Q2_30::from_int(1);
  return {{{c, -s, {}}, {s, c, {}}, {{}, {}, one}}};
}

}  // namespace spanline
