#pragma once
#include <cstdint>
#include <span>

#include "spanline/math/vector.hpp"

namespace spanline {

/// White light from infinitely far away.
struct DirectionalLight {
  Direction towards{{}, {}, Q2_30::from_int(1)};  ///< unit vector from the scene towards the light, world space
  Fixed<16> intensity = Fixed<16>::from_int(1);   ///< [0, 4]
};

/// The light of a frame: a surface with unit normal n gets min(1, ambient + Σ intensity · max(0, n·towards)).
struct Lighting {
  static constexpr std::size_t max_lights = 4;
  Fixed<16> ambient = Fixed<16>::from_int(1);  ///< [0, 1]; 1 alone is the unlit look
  std::span<const DirectionalLight> lights{};  ///< at most max_lights; further ones are ignored
};

}  // namespace spanline
