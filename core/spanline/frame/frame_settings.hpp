#pragma once
#include <cstdint>

#include "spanline/geometry/polygon_assembly.hpp"
#include "spanline/model/camera.hpp"
#include "spanline/model/colour.hpp"
#include "spanline/model/cull.hpp"
#include "spanline/model/fog.hpp"
#include "spanline/model/light.hpp"

namespace spanline {

/// What a frame shows besides its instances.
struct FrameSettings {
  Camera camera{};
  Lighting lighting{};
  Rgb888 background{0, 0, 0};
  Cull cull = Cull::back;
  std::uint8_t stipple_seed = 0;  ///< [0, 127]: of materials that are seen through by random patterns
  Fog fog{};                      ///< for renderers with the general shader
  bool dither = false;            ///< ordered dither, likewise
};

}  // namespace spanline
