#pragma once
/// @file
/// Fog of a frame, for renderers with the general shader or one for fog.
///
/// ```cpp
/// #include <spanline/frame/frame_settings.hpp>
///
/// FrameSettings settings;
/// settings.fog = {.curve = FogCurve::linear, .start = 5.0_q16, .end = 20.0_q16, .colour = {120, 130, 140}};
/// settings.background = settings.fog.colour;
/// ```
#include <cstdint>

#include "spanline/math/fixed.hpp"
#include "spanline/model/colour.hpp"

namespace spanline {

/// How fog grows with the distance along the viewing axis, from its start to its end.
enum class FogCurve : std::uint8_t {
  none,         ///< no fog
  linear,       ///< linearly
  exponential,  ///< visibility halves every sixth of the way, scaled so that it is 0 at the end
};

/// Fog of a frame. The background is not fogged, so it should have the fog's colour.
struct Fog {
  FogCurve curve = FogCurve::none;  ///< none by default
  Q16_16 start{};  ///< distance up to which there is no fog: world units from the eye, [0, end); 0 by default
  Q16_16 end = Q16_16::from_int(1);  ///< from here on only fog is visible: world units, (start, 32768); 1 by default
  Rgb888 colour{};                   ///< white by default
};

}  // namespace spanline
