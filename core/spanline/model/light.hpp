#pragma once
/// @file
/// The light of a frame.
///
/// ```cpp
/// #include <spanline/frame/frame_settings.hpp>
///
/// static const DirectionalLight sun{{0.48_q30, 0.6_q30, 0.64_q30}, Fixed<16>::from_ratio(8, 10)};  // a unit vector
/// FrameSettings settings;
/// settings.lighting = {.ambient = Fixed<16>::from_ratio(2, 10), .lights = {&sun, 1}};
/// ```
#include <cstdint>
#include <span>

#include "spanline/math/vector.hpp"

namespace spanline {

/// White light from infinitely far away.
struct DirectionalLight {
  Direction towards{
      {},
      {},
      Q2_30::from_int(1)};  ///< unit vector of Q2.30 from the scene towards the light, world space; along z by default
  Fixed<16> intensity = Fixed<16>::from_int(1);  ///< Q16.16, [0, 4]; 1 by default
};

/// White light from a point. At distance d its intensity is intensity · (1 − (d/range)²)², and 0 from the range on.
struct PointLight {
  Position position{};                           ///< world units, Q16.16; the origin by default
  Fixed<16> intensity = Fixed<16>::from_int(1);  ///< Q16.16, [0, 4]; 1 by default
  Q16_16 range{};  ///< world units, [0, 32768); 0, the default, means unlimited and without fading
};

/// The light of a frame: a surface with unit normal n gets min(1, ambient + Σ intensity · max(0, n·towards)).
struct Lighting {
  static constexpr std::size_t max_lights = 4;  ///< of each kind
  Fixed<16> ambient = Fixed<16>::from_int(1);   ///< Q16.16, [0, 1]; 1 by default, with which surfaces look unlit
  std::span<const DirectionalLight> lights{};   ///< at most max_lights; `begin` refuses more
  /// At most max_lights, for renderers with `LocalFlatShader` (shade/local_flat.hpp).
  std::span<const PointLight> point_lights{};
};

}  // namespace spanline
