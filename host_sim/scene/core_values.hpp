#pragma once
#include "base/vector.hpp"
#include "scene/lighting.hpp"
#include "spanline/model/light.hpp"
#include "spanline/model/mesh.hpp"

/// The doors from doubles to the core's fixed point. Rounding is to nearest, halves away from zero, on every host.
namespace spanline::sim {

/// `value` · 2^fraction_bits, rounded; the caller states a range that fits.
template <class Format>
[[nodiscard]] Format to_fixed(double value) {
  return Format::from_raw(static_cast<typename Format::rep>(std::llround(std::ldexp(value, Format::fraction_bits))));
}

[[nodiscard]] inline Direction to_direction(Vector3 unit) {
  return {to_fixed<Q2_30>(unit.x), to_fixed<Q2_30>(unit.y), to_fixed<Q2_30>(unit.z)};
}

/// A unit vector in ten bits a component; the zero vector stays zero.
[[nodiscard]] inline PackedNormal to_packed_normal(Vector3 unit) {
  const auto component = [](double value) { return static_cast<int>(std::lround(value * 511)); };
  return {component(unit.x), component(unit.y), component(unit.z)};
}

}  // namespace spanline::sim
