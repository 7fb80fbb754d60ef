#include "drawing.hpp"

#include <stdexcept>
#include <string_view>

#include "algorithm_drawer.hpp"
#include "draw_with.hpp"

namespace spanline::contract {
namespace {

AlgorithmDrawer drawer_of(const AlgorithmEntry& algorithm) {
  return with_unit(algorithm.id, []<AlgorithmId Unit>() { return algorithm_drawer<Unit>(); });
}

}  // namespace

std::vector<AlgorithmEntry> algorithms_for(const Scene& scene) {
  std::vector<AlgorithmEntry> entries;
  for (const AlgorithmEntry& entry : algorithm_registry)
    if (scene.triangles.empty() || entry.takes_screen_polygons()) entries.push_back(entry);
  return entries;
}

const AlgorithmEntry& algorithm(const char* name) {
  for (const AlgorithmEntry& entry : algorithm_registry)
    if (std::string_view(entry.name) == name) return entry;
  throw std::logic_error("no such algorithm");
}

Drawing draw(const AlgorithmEntry& algorithm, const Scene& scene, const Manner& manner) {
  return drawer_of(algorithm).draw(scene, manner_for(algorithm, manner));
}

Drawing draw_16_bits(const AlgorithmEntry& algorithm, const Scene& scene) {
  Manner manner;
  manner.band_lines = 16;
  return drawer_of(algorithm).draw_16_bits(scene, manner_for(algorithm, manner));
}

}  // namespace spanline::contract
