#pragma once
/// @file
/// What a frame shows besides its instances.
///
/// ```cpp
/// FrameSettings settings;
/// settings.camera.look_at({{}, 2.0_q16, 5.0_q16}, {}, {{}, 1.0_q30, {}});
/// settings.background = {20, 24, 40};
/// const Status begun = renderer.begin(settings);
/// ```
#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "spanline/frame/status.hpp"
#include "spanline/model/camera.hpp"
#include "spanline/model/colour.hpp"
#include "spanline/model/cull.hpp"
#include "spanline/model/fog.hpp"
#include "spanline/model/light.hpp"

namespace spanline {

/// What a frame shows besides its instances.
struct FrameSettings {
  Camera camera{};                ///< the origin of the world by default
  Lighting lighting{};            ///< fully lit by default
  Rgb888 background{0, 0, 0};     ///< colour of pixels that no polygon covers; black by default
  Cull cull = Cull::back;         ///< which side of polygons is not drawn; the back by default
  std::uint8_t stipple_seed = 0;  ///< seed of the random patterns of stochastic transparency, [0, 127]; 0 by default
  Fog fog{};                      ///< needs GeneralShader or a shader for fog; none by default
  bool dither = false;            ///< ordered dither; needs GeneralShader; off by default
};

/// The first reason why a frame cannot be drawn with these settings, or ok.
[[nodiscard]] constexpr Status check_settings(const FrameSettings& settings) {
  const Camera& camera = settings.camera;
  const bool before_the_eye = camera.projection == Projection::orthographic || camera.near_plane.raw() > 0;
  if (!(camera.near_plane < camera.far_plane) || !before_the_eye) return Fault::bad_planes;
  if (camera.focal.raw() <= 0) return Fault::bad_focal;
  const std::size_t lights = std::max(settings.lighting.lights.size(), settings.lighting.point_lights.size());
  if (lights > Lighting::max_lights) return {Fault::too_many_lights, Pool::none, static_cast<std::uint32_t>(lights)};
  return {};
}

}  // namespace spanline
