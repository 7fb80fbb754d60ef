#pragma once
#include <array>

#include "scene.hpp"
#include "spanline/math/fixed.hpp"
#include "spanline/model/cull.hpp"
#include "support/random.hpp"

namespace spanline::contract {

using namespace spanline::literals;

inline constexpr std::array<DirectionalLight, 1> light{
    {{{0.4243_q30, 0.5657_q30, 0.7071_q30}, Fixed<16>::from_ratio(8, 10)}}};

// Any of a kind.
[[nodiscard]] ShadingMode any_shading(test::Random& random);
[[nodiscard]] Cull any_cull(test::Random& random);
[[nodiscard]] Angle any_angle(test::Random& random);
[[nodiscard]] Rgb888 any_colour(test::Random& random);

/// A sphere of triangles about the origin; normals point outwards. `radius` in steps of 2^-13.
[[nodiscard]] OwnedMesh sphere(int radius, int rings, int sides);

/// A camera at z = 4 that looks at the origin, and a light.
void look_from_four(Scene& scene);

void add_mesh(Scene& scene, OwnedMesh mesh, const Transform& transform, const Material& material);

}  // namespace spanline::contract
