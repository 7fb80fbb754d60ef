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

/// White light from a point: at the distance d it is intensity · (1 − (d/range)²)², and nothing from the range on.
struct PointLight {
  Position position{};                           ///< world space
  Fixed<16> intensity = Fixed<16>::from_int(1);  ///< [0, 4]
  Q16_16 range{};                                ///< world units; 0: it reaches everywhere and does not fade
};

/// The light of a frame: a surface with unit normal n gets min(1, ambient + Σ intensity · max(0, n·towards)).
struct Lighting {
  static constexpr std::size_t max_lights = 4;  ///< of each kind
  Fixed<16> ambient = Fixed<16>::from_int(1);   ///< [0, 1]; 1 alone is the unlit look
  std::span<const DirectionalLight> lights{};   ///< at most max_lights; further ones are ignored
  /// At most max_lights, for renderers with `LocalFlatShader` (shade/local_flat.hpp).
  std::span<const PointLight> point_lights{};
};

}  // namespace spanline
