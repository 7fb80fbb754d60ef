#include "api_drawing.hpp"
#include "spanline/frame/ready_made_traits.hpp"
#include "spanline/visibility/sort/depth_sort.hpp"
#include "spanline/visibility/sort/painter.hpp"

namespace spanline::fuzz {

Run draw_everything(const ApiFrame& frame) {
  Run run;
  Drawing<GeneralSeeThroughTraits<Rgb565, Depth24<>>>(frame, run).draw("zbuffer");
  Drawing<GeneralSeeThroughTraits<Rgb565, Depth24<>, Spanning>>(frame, run).draw("span");
  Drawing<GeneralSeeThroughTraits<Rgb565, Depth24<>, DepthSort>>(frame, run).draw("depth-sort");
  return run;
}

Run draw_in_order(const ApiFrame& frame) {
  Run run;
  Drawing<GeneralSeeThroughTraits<Rgb565, Depth24<>, Painter>>(frame, run).draw("painter");
  return run;
}

}  // namespace spanline::fuzz
