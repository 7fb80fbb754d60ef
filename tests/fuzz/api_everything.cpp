#include "api_drawing.hpp"
#include "spanline/frame/ready_made_traits.hpp"

namespace spanline::fuzz {

Run draw_everything(const ApiFrame& frame) {
  Run run;
  Drawing<GeneralSeeThroughTraits<Rgb565, Depth24<>>>(frame, run).draw("zbuffer");
  Drawing<GeneralSeeThroughTraits<Rgb565, Depth24<>, Spanning>>(frame, run).draw("span");
  return run;
}

}  // namespace spanline::fuzz
