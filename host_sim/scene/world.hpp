#pragma once
#include <optional>

#include "base/parse.hpp"
#include "base/vector.hpp"
#include "scene/scene.hpp"
#include "scene/view.hpp"
#include "spanline/model/camera.hpp"
#include "spanline/model/fog.hpp"
#include "spanline/model/volume.hpp"

namespace spanline::sim {

/// Where a scene stands in the core's world of Q16.16: world = (model − origin) · 2^exponent. A power of two changes
/// neither the picture nor, as depth depends on ratios only, any depth.
struct World {
  Vector3 origin{};
  int exponent = 0;

  [[nodiscard]] Vector3 to_world(Vector3 model) const {
    const Vector3 d = model - origin;
    return {std::ldexp(d.x, exponent), std::ldexp(d.y, exponent), std::ldexp(d.z, exponent)};
  }
};

/// Linear fog, in units of the model along the axis of view.
struct FogRequest {
  double start = 0, end = 1;
  Rgb888 colour;
};

/// The world that holds the scene, an eye that turns about its target, and the end of a fog that can be seen, as large
/// as Q16.16 allows.
[[nodiscard]] World choose_world(const View& view, const Scene& scene, Size size,
                                 const std::optional<FogRequest>& fog = std::nullopt);

/// The core's fog for that view; none where it is too thin to be seen.
[[nodiscard]] Fog to_fog(const FogRequest& fog, const View& view, const World& world);

/// The model cut from a solid that is as large as its box, whose middle it has in common.
[[nodiscard]] Volume to_volume(const VolumeTexture& solid, const Scene& scene, const World& world);

/// The core's camera. Throws UsageError if the view is too narrow or its planes lie too far apart for fixed point.
[[nodiscard]] Camera to_camera(const View& view, const World& world, Size size);

}  // namespace spanline::sim
