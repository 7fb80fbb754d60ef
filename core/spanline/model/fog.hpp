#pragma once
#include <cstdint>

#include "spanline/math/fixed.hpp"
#include "spanline/model/colour.hpp"

namespace spanline {

/// How fog thickens with the distance along the axis of view, between its start and its end.
enum class FogCurve : std::uint8_t {
  none,
  linear,       ///< evenly
  exponential,  ///< by a sixth of the way it halves what is left to be seen, scaled so that nothing is left at the end
};

/// Fog of a frame. The background is not fogged: it should have the fog's colour.
struct Fog {
  FogCurve curve = FogCurve::none;
  Q16_16 start{}, end = Q16_16::from_int(1);  ///< world units, start < end
  Rgb888 colour{};
};

}  // namespace spanline
