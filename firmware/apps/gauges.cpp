// An instrument panel with needles and text, for any board with a display of at least 160 × 120 pixels (display.hpp).
// The image that tests run stops after SPANLINE_GAUGES_FRAMES frames; 0 goes on for ever.
#include "scenes/gauges.hpp"

#include <sans_14.hpp>

#include "board.hpp"
#include "display.hpp"
#include "picture_memory.hpp"
#include "spanline/frame/ready_made_traits.hpp"
#include "spanline/frame/renderer.hpp"
#include "spanline/hal/present.hpp"
#include "spanline/model/cull.hpp"

namespace {

using namespace spanline;

using Panel = board::DisplayPanel;
using Picture = Renderer<FlatTraits<Rgb565Swapped>>;
using Present = hal::Present<Panel, board::DisplayClock>;
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

/// Hands finished bands with their text to the present loop, whose buffers are the renderer's colour bands.
struct Sink {
  Present& present;
  bool acquire(unsigned buffer) { return present.acquire(static_cast<int>(buffer)) == hal::DisplayStatus::ok; }
  bool operator()(const Picture::BandView& band) {
    Canvas<Rgb565Swapped> canvas(band.pixels, Panel::width, band.y0, band.y1);
    gauges.write(canvas, spanline_fonts::sans_14);
    return present.submit(band.y0, band.y1, static_cast<int>(band.buffer)) == hal::DisplayStatus::ok;
  }
};

hal::DisplayStatus show(std::uint32_t frame, Picture& renderer, Present& present, bool last) {
  if (const hal::DisplayStatus begun = present.begin_frame(); begun != hal::DisplayStatus::ok) return begun;
  gauges.make(frame, Panel::width, Panel::height);
  FrameSettings settings;
  settings.cull = Cull::none;
  settings.background = scenes::Gauges::background;
  const bool good = renderer.begin(settings).ok() && renderer.add_screen(gauges.vertices(), gauges.colours()).ok();
  if (!good) board::write("gauges: a pool is full\n");
  const Status drawn = renderer.draw(Sink{present});
  if (drawn.fault == Fault::pool_full) board::write("gauges: a pool is full\n");
  return last ? present.end_frame() : present.end_frame_early();
}

}  // namespace

int main() {
  static board::DisplayBus bus;
  static board::DisplayClock clock;
  static Panel panel(bus, clock);
  static Picture renderer(capacity, memory);
  std::array<std::span<std::uint16_t>, Present::most_buffers> buffers{};
  for (unsigned i = 0; i < buffers.size(); ++i) buffers[i] = renderer.colour_band(i);
  static Present present(panel, clock, buffers);
  for (std::uint32_t frame = 0; frames_to_show == 0 || frame < frames_to_show; ++frame) {
    const hal::DisplayStatus status = show(frame, renderer, present, frame + 1 == frames_to_show);
    board::frame_done();
    if (status == hal::DisplayStatus::ok) continue;
    board::write("gauges: display ");
    board::write(to_string(status));
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
