// An instrument panel with needles and text, for any board with a display of at least 160 × 120 pixels (display.hpp).
// The image that tests run stops after SPANLINE_GAUGES_FRAMES frames; 0 goes on for ever.
#include "scenes/gauges.hpp"

#include <sans_14.hpp>

#include "board.hpp"
#include "display.hpp"
#include "picture_memory.hpp"
#include "spanline/frame/ready_made_traits.hpp"
#include "spanline/frame/renderer.hpp"
#include "spanline/hal/display_sink.hpp"
#include "spanline/model/cull.hpp"

namespace {

using namespace spanline;

using Panel = board::DisplayPanel;
using Picture = Renderer<FlatTraits<Rgb565Swapped>>;
using Display = hal::DisplaySink<Panel, board::DisplayClock>;
static_assert(Panel::pixel_order == hal::PixelOrder::high_byte_first);

constexpr std::uint32_t frames_to_show = SPANLINE_GAUGES_FRAMES;
constexpr Capacity capacity{.width = Panel::width,
                            .height = Panel::height,
                            .band_lines = board::display_bands.lines,
                            .colour_bands = board::display_bands.count,
                            .polygons = scenes::Gauges::most_triangles,
                            .active = scenes::Gauges::most_triangles};
constexpr std::size_t memory_needed = Picture::bytes_needed(capacity);
static_assert(memory_needed + sizeof(scenes::Gauges) <= board::picture_memory);

alignas(Arena::alignment) std::byte memory[memory_needed];
scenes::Gauges gauges;

/// Writes the text of finished bands before the display gets them.
struct TextSink {
  Display& display;
  bool acquire(unsigned buffer) { return display.acquire(buffer); }
  bool operator()(const Picture::BandView& band) {
    Canvas<Rgb565Swapped> canvas(band.pixels, Panel::width, band.y0, band.y1);
    gauges.write(canvas, spanline_fonts::sans_14);
    return display(band);
  }
};

Status draw(std::uint32_t frame, Picture& renderer, Display& display) {
  gauges.make(frame, Panel::width, Panel::height);
  FrameSettings settings;
  settings.cull = Cull::none;
  settings.background = scenes::Gauges::background;
  const bool good = renderer.begin(settings).ok() && renderer.add_screen(gauges.vertices(), gauges.colours()).ok();
  if (!good) board::write("gauges: a pool is full\n");
  return renderer.draw(TextSink{display});
}

}  // namespace

int main() {
  static board::DisplayBus bus;
  static board::DisplayClock clock;
  static Panel panel(bus, clock);
  static Picture renderer(capacity, memory);
  static Display display(panel, clock, renderer);
  for (std::uint32_t frame = 0; frames_to_show == 0 || frame < frames_to_show; ++frame) {
    const auto draw_frame = [&](Display& sink) { return draw(frame, renderer, sink); };
    const bool last = frame + 1 == frames_to_show;
    const hal::ShownFrame<Status> shown = last ? display.show(draw_frame) : display.show_and_go_on(draw_frame);
    board::frame_done();
    if (shown.drawing.fault == Fault::pool_full) board::write("gauges: a pool is full\n");
    if (shown.display == hal::DisplayStatus::ok) continue;
    board::write("gauges: display ");
    board::write(to_string(shown.display));
    board::write("\n");
  }
  board::write("gauges: all shown, stack ");
  board::write_unsigned(board::stack_used());
  board::write(" of ");
  board::write_unsigned(board::stack_size());
  board::write("\n");
  for (;;) {
    clock.delay_us(100'000);
    board::frame_done();
  }
}
