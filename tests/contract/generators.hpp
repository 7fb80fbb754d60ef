#pragma once
#include <cstdint>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "scene.hpp"
#include "support/random.hpp"
#include "support/triangle_kinds.hpp"

namespace spanline::contract {

using test::Random;

/// A kind of random scenes. The same seed makes the same scene on every machine.
struct Generator {
  std::string name;  ///< letters, digits and underlines
  std::function<Scene(Random&)> make;
  int rounds;  ///< scenes in a plain run
};
/// For the report of a failure.
inline std::ostream& operator<<(std::ostream& out, const Generator& generator) { return out << generator.name; }

/// Scenes of triangles on screen.
[[nodiscard]] const std::vector<Generator>& screen_generators();
/// Scenes of meshes before a camera.
[[nodiscard]] const std::vector<Generator>& mesh_generators();
/// Scenes of meshes with every kind of surface, for renderers that have them all.
[[nodiscard]] const Generator& surface_generator();
[[nodiscard]] const Generator& generator(const std::string& name);

/// The seed of a generator's scene number `round`. SPANLINE_CONTRACT_SEED in the environment chooses other scenes than
/// every run has.
[[nodiscard]] std::uint32_t seed_of(const Generator& generator, int round);

// The makers, by file.

[[nodiscard]] Scene soup(Random& random, test::TriangleKind kind);
[[nodiscard]] Scene mixed_soup(Random& random);
[[nodiscard]] Scene penetrating_soup(Random& random);
[[nodiscard]] Scene extreme_depths(Random& random);
[[nodiscard]] Scene odd_size(Random& random);

[[nodiscard]] Scene shared_grids(Random& random);
[[nodiscard]] Scene coplanar_ties(Random& random);
[[nodiscard]] Scene quads_on_centres(Random& random);
[[nodiscard]] Scene cyclic_bars(Random& random);
[[nodiscard]] Scene depth_layers(Random& random);
[[nodiscard]] Scene stack(Random& random);

[[nodiscard]] Scene nested_polygons(Random& random);
[[nodiscard]] Scene shared_corners(Random& random);

[[nodiscard]] Scene bunny(Random& random);
[[nodiscard]] Scene teapot(Random& random);
[[nodiscard]] Scene terrain(Random& random);
[[nodiscard]] Scene nested_spheres(Random& random);
[[nodiscard]] Scene crossing_tori(Random& random);
[[nodiscard]] Scene clipped_soup(Random& random);
[[nodiscard]] Scene polygon_bodies(Random& random);

[[nodiscard]] Scene surfaces(Random& random);

}  // namespace spanline::contract
