#include "draw_surfaces.hpp"

#include "drawer_by.hpp"

namespace spanline::contract {

Drawing draw_surfaces(const AlgorithmEntry& algorithm, const Scene& scene, const Manner& manner) {
  return with_unit(algorithm.id, []<AlgorithmId Unit>() { return algorithm_surface_drawer<Unit>(); })(
      scene, manner_for(algorithm, manner));
}

Drawing reference_of_surfaces(const Scene& scene, Manner manner) {
  return draw_surfaces_by<ZBuffer>(scene, manner_for_reference(manner));
}

}  // namespace spanline::contract
