#pragma once
#include <spanline/frame/ready_made_traits.hpp>

#include "algorithm_drawer.hpp"
#include "draw_with.hpp"

namespace spanline::contract {

/// Flat shading, opaque and see-through.
template <class Depth, class Visibility>
using LayerTraits = RendererTraits<Rgb565, ShaderList<FlatShader<Rgb565>, SeeThroughShader<Rgb565, FlatShader<Rgb565>>>,
                                   Depth, Visibility>;

template <class Visibility, DepthSense Sense>
Drawing draw_in(const Scene& scene, const Manner& manner) {
  if (manner.content == Manner::Content::ids)
    return draw_with<IdTraits<Depth24<Sense>, Counted, Visibility>>(scene, manner);
  if (manner.content == Manner::Content::layers)
    return draw_with<LayerTraits<Depth24<Sense>, Visibility>>(scene, manner);
  return draw_with<GouraudTraits<Rgb565, Depth24<Sense>, Visibility>>(scene, manner);
}

template <class Visibility>
Drawing draw_by(const Scene& scene, const Manner& manner) {
  return manner.sense == DepthSense::smaller_is_nearer
             ? draw_in<Visibility, DepthSense::smaller_is_nearer>(scene, manner)
             : draw_in<Visibility, DepthSense::larger_is_nearer>(scene, manner);
}

template <class Visibility>
AlgorithmDrawer drawer_by() {
  return {draw_by<Visibility>, draw_with<IdTraits<Depth16<>, Counted, Visibility>>};
}

template <class Visibility>
Drawing draw_surfaces_by(const Scene& scene, const Manner& manner) {
  return draw_with<GeneralSeeThroughTraits<Rgb565, Depth24<>, Visibility>>(scene, manner);
}

}  // namespace spanline::contract
