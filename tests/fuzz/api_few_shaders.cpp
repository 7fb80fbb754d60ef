// Renderers that lack shaders, each for reasons of its own.
#include "api_drawing.hpp"
#include "spanline/frame/ready_made_traits.hpp"
#include "spanline/visibility/sort/depth_sort.hpp"
#include "spanline/visibility/sort/painter.hpp"

namespace spanline::fuzz {
namespace {

/// A z-buffer that asks for the world.
struct InWorld {
  template <class Depth, class Pixel, class Shaders, bool Counting>
  struct Algorithm : DepthBuffer<Depth, Pixel, Shaders, Counting> {
    using Base = DepthBuffer<Depth, Pixel, Shaders, Counting>;
    using Base::Base;
    static constexpr AlgorithmNeeds needs = AlgorithmNeeds::world;
  };
};

/// No flat shading, and textures with holes that spans do not show without layers.
using Opaque = RendererTraits<Rgb565, ShaderList<GouraudShader<Rgb565>, GeneralShader<Rgb565>>, Depth24<>, Spanning>;

}  // namespace

Run draw_plain(const ApiFrame& frame) {
  Run run;
  Drawing<GouraudTraits<Rgb565, Depth16<>, Counted, BoundedZBuffer>>(frame, run).draw("plain");
  return run;
}

Run draw_opaque(const ApiFrame& frame) {
  Run run;
  Drawing<Opaque>(frame, run).draw("opaque");
  return run;
}

Run draw_world(const ApiFrame& frame) {
  Run run;
  Drawing<FlatTraits<Rgb565, InWorld>>(frame, run).draw("world");
  return run;
}

Run draw_ids(const ApiFrame& frame) {
  Run run;
  Drawing<IdTraits<Depth24<>, Counted>>(frame, run).draw("ids by zbuffer");
  Drawing<IdTraits<Depth24<>, Counted, Spanning>>(frame, run).draw("ids by span");
  Drawing<IdTraits<Depth24<>, Counted, DepthSort>>(frame, run).draw("ids by depth-sort");
  return run;
}

Run draw_ids_in_order(const ApiFrame& frame) {
  Run run;
  Drawing<IdTraits<Depth24<>, Counted, Painter>>(frame, run).draw("ids by painter");
  return run;
}

}  // namespace spanline::fuzz
