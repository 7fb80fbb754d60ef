#pragma once
#include <algorithm>
#include <cmath>

#include "spanline/geometry/view_space.hpp"
#include "support/owned_mesh.hpp"
#include "support/random.hpp"

namespace spanline::test {

/// The fixed-point number nearest to a real one, kept in its format.
template <class F>
[[nodiscard]] F nearest(double value) {
  const double raw = std::ldexp(value, F::fraction_bits);
  return F::from_raw(static_cast<typename F::rep>(std::clamp(std::round(raw), -2147483647.0, 2147483647.0)));
}

[[nodiscard]] inline Rotation random_rotation(Random& random) {
  const auto angle = [&] { return Angle::from_raw(static_cast<std::uint32_t>(random.wide(0, 0xffffffff))); };
  return rotation_x(angle()) * rotation_y(angle()) * rotation_z(angle());
}

/// A camera, an instance before it, and a picture size: at any scale and from any side.
struct RandomInstance {
  OwnedMesh owned;
  Mesh mesh;
  Transform transform;
  FrameView view;

  /// How the instance is to lie.
  struct Wish {
    bool wide = false;  ///< 32-bit vertices
    bool orthographic = false;
    double closest = 1.05;  ///< distance of the centre, radii
    double farthest = 40;
    double aside = 0.9;        ///< how far from the middle of the picture, half pictures
    bool range_around = true;  ///< near and far leave the instance whole; else they may cut it
    int vertices = 60;
    int depth_bits = 24;
  };

  RandomInstance(Random& random, const Wish& wish) {
    make_vertices(random, wish);
    // The instance's radius in world units; everything else is relative to it.
    const double radius = std::exp2(random.real(-5, 7));
    const double steps = owned.bounds.radius;
    // radius = steps · 2^e · scale, the exponent being free within the range of the scale.
    const double step = radius / steps;
    const int exponent = std::clamp(static_cast<int>(std::floor(std::log2(step))) + random.between(-4, 4), -30, 14);
    owned.step_exponent = static_cast<std::int8_t>(exponent);
    mesh = owned.view();
    transform.scale = nearest<Fixed<24>>(std::clamp(step / std::exp2(exponent), 0x1p-20, 127.9));
    transform.rotation = random_rotation(random);
    const double real_radius = steps * std::exp2(exponent) * std::ldexp(transform.scale.raw(), -24);

    view.viewport = {random.between(16, 1000), random.between(16, 800)};
    view.depth_bits = wish.depth_bits;
    view.nearest_depth = wish.depth_bits == 16 ? 0 : 16;
    view.farthest_depth = wish.depth_bits == 16 ? 65534 : (1u << 24) - 17;
    Camera& camera = view.camera;
    camera.projection = wish.orthographic ? Projection::orthographic : Projection::perspective;
    const double distance = real_radius * std::exp2(random.real(std::log2(wish.closest), std::log2(wish.farthest)));
    // Pixels that the radius takes at the centre's distance: from a few to more than the picture.
    const double size = std::exp2(random.real(2, 9.5));
    const double focal = wish.orthographic ? size / real_radius : size * distance / real_radius;
    camera.focal = nearest<Q16_16>(std::clamp(focal, 0.01, 20000.0));
    const double pixel =
        wish.orthographic ? 1 / std::ldexp(camera.focal.raw(), -16) : distance / std::ldexp(camera.focal.raw(), -16);
    camera.axes = random_rotation(random);
    camera.eye = {nearest<Q16_16>(random.real(-1000, 1000)), nearest<Q16_16>(random.real(-1000, 1000)),
                  nearest<Q16_16>(random.real(-1000, 1000))};
    const double x = random.real(-wish.aside, wish.aside) * view.viewport.width / 2 * pixel,
                 y = random.real(-wish.aside, wish.aside) * view.viewport.height / 2 * pixel;
    place(x, y, distance, step_size());
    if (wish.range_around) {
      const double near = std::max(distance - real_radius * 1.01, distance * 0.01);
      camera.near_plane = nearest<Q16_16>(wish.orthographic ? distance - real_radius * random.real(1.02, 5)
                                                            : near * std::exp2(random.real(-6, -0.03)));
      camera.far_plane = nearest<Q16_16>((distance + real_radius * 1.01) * std::exp2(random.real(0.03, 5)));
    } else {
      camera.near_plane = nearest<Q16_16>(std::max(0.001, distance + real_radius * random.real(-1.5, 0.9)));
      camera.far_plane = nearest<Q16_16>(std::max(0.002, distance + real_radius * random.real(-0.5, 3)));
    }
    const std::int32_t least = wish.orthographic ? -0x7fffff00 : 1;
    camera.near_plane = Q16_16::from_raw(std::clamp(camera.near_plane.raw(), least, 0x7fffff00));
    camera.far_plane = std::max(camera.far_plane, Q16_16::from_raw(camera.near_plane.raw() + 1));
  }

  /// World units a step of the mesh, as the fixed-point numbers have it.
  [[nodiscard]] double step_size() const {
    return std::exp2(owned.step_exponent) * std::ldexp(transform.scale.raw(), -24);
  }

 private:
  void make_vertices(Random& random, const Wish& wish) {
    if (wish.wide) {
      const int reach = 1 << random.between(6, 29);
      for (int i = 0; i < wish.vertices; ++i)
        owned.wide_vertices.push_back(
            {random.between(-reach, reach), random.between(-reach, reach), random.between(-reach, reach)});
    } else {
      const int reach = (1 << random.between(6, 15)) - 1;
      const auto c = [&] { return static_cast<std::int16_t>(random.between(-reach, reach)); };
      for (int i = 0; i < wish.vertices; ++i) owned.vertices.push_back({c(), c(), c()});
    }
    for (std::size_t i = 0; i + 2 < static_cast<std::size_t>(wish.vertices); i += 3) owned.triangle(i, i + 1, i + 2);
    owned.fit_bounds();
    // Where the model's origin lies costs precision: up to some radii away, as converters leave it.
    const int offset =
        random.chance(2) ? 0 : static_cast<int>(std::min<std::int64_t>(1 << 30, 4 * std::int64_t{owned.bounds.radius}));
    owned.offset = {random.between(-offset, offset), random.between(-offset, offset), random.between(-offset, offset)};
  }

  /// Chooses the translation so that the middle of the bounds lies at this place of view space.
  void place(double x, double y, double distance, double step) {
    const auto entry = [](Q2_30 q) { return q.raw() * 0x1p-30; };
    const Rotation& a = view.camera.axes;
    const double view_space[3] = {x, y, -distance};
    double world[3] = {std::ldexp(view.camera.eye.x.raw(), -16), std::ldexp(view.camera.eye.y.raw(), -16),
                       std::ldexp(view.camera.eye.z.raw(), -16)};
    for (int i = 0; i < 3; ++i) {
      world[0] += entry(a.row[i].x) * view_space[i];
      world[1] += entry(a.row[i].y) * view_space[i];
      world[2] += entry(a.row[i].z) * view_space[i];
    }
    const double centre[3] = {(double{1} * owned.bounds.centre.x + owned.offset.x) * step,
                              (double{1} * owned.bounds.centre.y + owned.offset.y) * step,
                              (double{1} * owned.bounds.centre.z + owned.offset.z) * step};
    for (int i = 0; i < 3; ++i) {
      const Direction& row = transform.rotation.row[i];
      world[i] -= entry(row.x) * centre[0] + entry(row.y) * centre[1] + entry(row.z) * centre[2];
    }
    transform.translation = {nearest<Q16_16>(world[0]), nearest<Q16_16>(world[1]), nearest<Q16_16>(world[2])};
  }
};

}  // namespace spanline::test
