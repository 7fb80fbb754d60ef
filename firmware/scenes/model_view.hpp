#pragma once
#include <algorithm>
#include <array>
#include <cstdint>

#include "spanline/frame/renderer.hpp"

namespace spanline::scenes {

using namespace spanline::literals;

/// A model on a turntable: benchmark scenes S4 and S5, the firmware's turntable and the simulator's picture of it.
///
/// The model is centred and scaled to a height of 2, turned about y, and seen from 4 units away with a focal length of
/// 320 pixels on a picture 240 lines high, near 0.5, far 16, one light.
struct ModelView {
  FrameSettings settings;
  Transform transform;
  Material material;
};

inline constexpr std::array<DirectionalLight, 1> model_view_lights{
    {{{0.4243_q30, 0.5657_q30, 0.7071_q30}, Fixed<16>::from_ratio(8, 10)}}};

/// What the vertices of a 16-bit mesh span, in its steps.
struct MeshBox {
  Vec3<std::int32_t> low{32767, 32767, 32767}, high{-32768, -32768, -32768};

  [[nodiscard]] static MeshBox of(const Mesh& mesh) {
    MeshBox box;
    for (const Vertex16& v : mesh.vertices) {
      box.low = {std::min<std::int32_t>(box.low.x, v.x), std::min<std::int32_t>(box.low.y, v.y),
                 std::min<std::int32_t>(box.low.z, v.z)};
      box.high = {std::max<std::int32_t>(box.high.x, v.x), std::max<std::int32_t>(box.high.y, v.y),
                  std::max<std::int32_t>(box.high.z, v.z)};
    }
    return box;
  }
};

/// Turns `mesh` by `angle`, for a picture `height` lines high. Only 16-bit meshes. Programs that draw it again and
/// again find its box once.
inline ModelView model_view(const Mesh& mesh, const MeshBox& box, Angle angle, int height, ShadingMode shading) {
  const auto& [low, high] = box;
  ModelView view;
  view.settings.camera.eye = {{}, {}, 4.0_q16};
  view.settings.camera.focal = Q16_16::from_ratio(320 * height, 240);
  view.settings.camera.near_plane = 0.5_q16;
  view.settings.camera.far_plane = 16.0_q16;
  view.settings.lighting = {Fixed<16>::from_ratio(2, 10), model_view_lights};
  view.material = {{255, 200, 150}, shading};

  // world = translation + scale · R · (v + offset) · 2^e; the scale makes the height 2, the translation undoes the
  // centre.
  const std::int64_t extent = std::max<std::int64_t>(1, high.y - low.y);
  const int exponent = mesh.step_exponent;
  const auto power = [](std::int64_t value, int by) { return by >= 0 ? value << by : value >> -by; };
  view.transform.rotation = rotation_y(angle);
  view.transform.scale =
      Fixed<24>::from_raw(static_cast<std::int32_t>(power((std::int64_t{2} << 40) / extent, -16 - exponent)));
  const auto centred = [&](std::int32_t a, std::int32_t b, std::int32_t offset) {
    // −centre in world units, Q16: −(a + b + 2·offset)/2 · 2/extent
    return -((static_cast<std::int64_t>(a) + b + 2 * std::int64_t{offset}) * 65536 / extent);
  };
  const std::int64_t x = centred(low.x, high.x, mesh.offset.x), y = centred(low.y, high.y, mesh.offset.y),
                     z = centred(low.z, high.z, mesh.offset.z);
  const auto turned = [&](const Direction& row) {
    return Q16_16::from_raw(static_cast<std::int32_t>((row.x.raw() * x + row.y.raw() * y + row.z.raw() * z) >> 30));
  };
  const Rotation& r = view.transform.rotation;
  view.transform.translation = {turned(r.row[0]), turned(r.row[1]), turned(r.row[2])};
  return view;
}
inline ModelView model_view(const Mesh& mesh, Angle angle, int height, ShadingMode shading) {
  return model_view(mesh, MeshBox::of(mesh), angle, height, shading);
}

}  // namespace spanline::scenes
