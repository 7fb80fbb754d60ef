#pragma once
#include <array>
#include <cmath>
#include <spanline/frame/ready_made_traits.hpp>
#include <spanline/model/cull.hpp>
#include <vector>

#include "support/exact_triangle.hpp"
#include "support/instance_picture.hpp"

namespace spanline::test {

/// Channels of an RGB565 pixel.
struct Channels {
  int red, green, blue;
  explicit Channels(std::uint16_t pixel) : red(pixel >> 11), green((pixel >> 5) & 63), blue(pixel & 31) {}
};

/// A triangle whose corners fall on given sixteenths of a picture of 64 × 64 pixels: an orthographic view, a pixel a
/// unit, and steps of a sixteenth.
struct ShadedTriangle {
  static constexpr int size = 64;
  OwnedMesh owned;
  Transform transform;
  FrameSettings settings;
  Corners corners{};  ///< sixteenths of a pixel; z is free for the test

  explicit ShadedTriangle(Random& random) {
    settings.cull = Cull::none;
    settings.camera.projection = Projection::orthographic;
    settings.camera.focal = Q16_16::from_int(1);
    settings.camera.near_plane = Q16_16::from_int(1);
    settings.camera.far_plane = Q16_16::from_int(1000);
    transform.translation.z = Q16_16::from_int(-100);
    owned.step_exponent = -4;
    const int reach = 1 << random.between(5, 9);
    for (Corner& c : corners) {
      c = {512 + random.between(-reach, reach), 512 + random.between(-reach, reach), 0};
      owned.vertices.push_back({static_cast<std::int16_t>(c.x - 512), static_cast<std::int16_t>(512 - c.y),
                                static_cast<std::int16_t>(random.between(-200, 200))});
    }
    owned.triangle(0, 1, 2);
    owned.fit_bounds();
  }

  template <class Format>
  [[nodiscard]] Picture<GouraudTraits<Format>> draw(const Material& material) const {
    Studio<GouraudTraits<Format>> studio(mesh_capacity(size, size, 1, 3, 1));
    const Mesh mesh = owned.view();
    studio.begin(settings);
    studio.add(mesh, transform, material);
    auto picture = studio.draw();
    EXPECT_TRUE(studio.status().ok());
    return picture;
  }
};

/// A unit vector that a packed normal stands for, as nearly as it does.
struct RealNormal {
  PackedNormal packed;
  double x, y, z;
};

[[nodiscard]] inline RealNormal random_normal(Random& random) {
  double v[3], length = 0;
  do {
    length = 0;
    for (double& c : v) {
      c = random.real(-1, 1);
      length += c * c;
    }
  } while (length < 0.01 || length > 1);
  int n[3];
  for (int i = 0; i < 3; ++i) n[i] = static_cast<int>(std::lround(v[i] / std::sqrt(length) * 511));
  return {PackedNormal(n[0], n[1], n[2]), n[0] / 511.0, n[1] / 511.0, n[2] / 511.0};
}

/// Lights for a frame, and what they give by the formula min(1, ambient + Σ intensity · max(0, n·l)).
struct RandomLights {
  std::vector<DirectionalLight> lights;
  Fixed<16> ambient;

  explicit RandomLights(Random& random, int count) : ambient(nearest<Fixed<16>>(random.real(0, 0.4))) {
    for (int i = 0; i < count; ++i) {
      const RealNormal n = random_normal(random);
      lights.push_back({normalise(n.packed.x(), n.packed.y(), n.packed.z()),
                        nearest<Fixed<16>>(random.chance(4) ? random.real(0, 4) : random.real(0, 0.9))});
    }
  }
  [[nodiscard]] Lighting lighting() const { return {ambient, lights}; }

  /// The light on a normal of a mesh that is turned by `rotation`.
  [[nodiscard]] double on(const RealNormal& n, const Rotation& rotation) const {
    const auto q = [](Q2_30 v) { return v.raw() * 0x1p-30; };
    double world[3];
    for (int i = 0; i < 3; ++i)
      world[i] = q(rotation.row[i].x) * n.x + q(rotation.row[i].y) * n.y + q(rotation.row[i].z) * n.z;
    double sum = std::ldexp(ambient.raw(), -16);
    for (const DirectionalLight& light : lights)
      sum +=
          std::ldexp(light.intensity.raw(), -16) *
          std::max(0.0, world[0] * q(light.towards.x) + world[1] * q(light.towards.y) + world[2] * q(light.towards.z));
    return std::min(1.0, sum);
  }
};

[[nodiscard]] inline Rgb888 random_colour(Random& random) {
  const auto channel = [&] { return static_cast<std::uint8_t>(random.between(0, 255)); };
  return {channel(), channel(), channel()};
}

/// Dither or none, fog or none.
inline void add_effects(Random& random, FrameSettings& settings) {
  settings.dither = random.chance(2);
  if (random.chance(2))
    settings.fog = {FogCurve::exponential, settings.camera.near_plane, settings.camera.far_plane,
                    random_colour(random)};
}

/// Triangles before and around a camera, with texture coordinates and normals of all kinds, and lights.
struct ShadedInstance {
  static constexpr int vertices = 20;
  RandomInstance instance;
  RandomLights lights;
  FrameSettings settings;

  explicit ShadedInstance(Random& random)
      : instance(random, {.wide = random.chance(4),
                          .orthographic = random.chance(6),
                          .closest = 0.5,
                          .farthest = 6,
                          .range_around = false,
                          .vertices = vertices}),
        lights(random, 2) {
    OwnedMesh& owned = instance.owned;
    add_texture_coordinates(random, owned);
    for (int v = 0; v < vertices; ++v) owned.vertex_normals.push_back(random_normal(random).packed);
    for (int t = 0; t < vertices / 3; ++t) owned.polygon_normals.push_back(random_normal(random).packed);
    instance.mesh = owned.view();
    settings.camera = instance.view.camera;
    settings.cull = Cull::none;
    settings.lighting = lights.lighting();
  }
};

}  // namespace spanline::test
