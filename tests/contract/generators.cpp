#include "generators.hpp"

#include <cstdlib>
#include <stdexcept>

namespace spanline::contract {

const std::vector<Generator>& screen_generators() {
  static const std::vector<Generator> list = [] {
    std::vector<Generator> all;
    for (const test::TriangleKind kind : test::all_triangle_kinds)
      all.push_back(
          {std::string("soup_") + test::name_of(kind), [kind](Random& random) { return soup(random, kind); }, 80});
    all.insert(all.end(), {{"mixed_soup", mixed_soup, 300},
                           {"penetrating", penetrating_soup, 300},
                           {"extreme_depths", extreme_depths, 200},
                           {"odd_size", odd_size, 200},
                           {"shared_grids", shared_grids, 200},
                           {"coplanar_ties", coplanar_ties, 200},
                           {"quads_on_centres", quads_on_centres, 200},
                           {"cyclic_bars", cyclic_bars, 200},
                           {"depth_layers", depth_layers, 200},
                           {"stack", stack, 80},
                           {"nested", nested_polygons, 1000},
                           {"shared_corners", shared_corners, 400}});
    return all;
  }();
  return list;
}

const std::vector<Generator>& mesh_generators() {
  static const std::vector<Generator> list{{"bunny", bunny, 16},
                                           {"teapot", teapot, 16},
                                           {"terrain", terrain, 60},
                                           {"nested_spheres", nested_spheres, 60},
                                           {"crossing_tori", crossing_tori, 60},
                                           {"clipped_soup", clipped_soup, 160},
                                           {"polygon_bodies", polygon_bodies, 400}};
  return list;
}

const Generator& surface_generator() {
  static const Generator surfaces_of_all_kinds{"surfaces", surfaces, 600};
  return surfaces_of_all_kinds;
}

const Generator& generator(const std::string& name) {
  for (const auto* list : {&screen_generators(), &mesh_generators()})
    for (const Generator& one : *list)
      if (one.name == name) return one;
  throw std::logic_error("no such generator: " + name);
}

std::uint32_t seed_of(const Generator& generator, int round) {
  static const char* const chosen = std::getenv("SPANLINE_CONTRACT_SEED");
  static const auto first = static_cast<std::uint32_t>(chosen != nullptr ? std::strtoul(chosen, nullptr, 10) : 1);
  std::uint32_t seed = first * 1'000'003u + static_cast<std::uint32_t>(round);
  for (const char letter : generator.name) seed = seed * 31u + static_cast<unsigned char>(letter);
  return seed;
}

}  // namespace spanline::contract
