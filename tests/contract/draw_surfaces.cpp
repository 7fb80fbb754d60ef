#include "draw_surfaces.hpp"
#include <spanline/frame/ready_made_traits.hpp>

#include "draw_with.hpp"
#include "registry/visibility_list.hpp"

namespace spanline::contract {
namespace {

template <class Visibility>
Drawing draw_by(const Scene& scene, const Manner& manner) {
  return draw_with<GeneralSeeThroughTraits<Rgb565, Depth24<>, Visibility>>(scene, manner);
}

}  // namespace

Drawing draw_surfaces(const sim::VisibilityEntry& algorithm, const Scene& scene, const Manner& manner) {
  const Manner own = manner_for(algorithm, manner);
  return sim::with_visibility(algorithm, [&]<class Visibility>() { return draw_by<Visibility>(scene, own); });
}

Drawing reference_of_surfaces(const Scene& scene, Manner manner) {
  return draw_by<ZBuffer>(scene, manner_for_reference(manner));
}

}  // namespace spanline::contract
