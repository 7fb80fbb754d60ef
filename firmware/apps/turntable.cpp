// A model on a turntable, for any board with a display (display.hpp) and 43 KB to spare. The images that tests run
// stop after SPANLINE_TURNTABLE_FRAMES frames; 0 goes on for ever. SPANLINE_TURNTABLE_MODEL is bunny or teapot, and
// SPANLINE_TURNTABLE_SHADING flat or gouraud.
#include "turntable.hpp"

#include <bunny.hpp>
#include <teapot.hpp>

#include "board.hpp"
#include "display.hpp"
#include "picture_memory.hpp"

namespace {

using namespace spanline;

using Turntable = apps::Turntable<board::DisplayPanel, board::DisplayClock, ShadingMode::SPANLINE_TURNTABLE_SHADING,
                                  board::BandFiller>;

constexpr const Mesh& mesh = spanline_models::SPANLINE_TURNTABLE_MODEL;
constexpr std::uint32_t frames_to_show = SPANLINE_TURNTABLE_FRAMES;

// Enough for either model from every side; tests/selftest holds all frames against it.
constexpr Capacity capacity = Turntable::capacity(mesh, board::display_bands.lines, board::display_bands.count, 1700,
                                                  100, board::display_bands.depth_count);
constexpr std::size_t memory_needed = Turntable::Picture::bytes_needed(capacity);
static_assert(memory_needed <= board::picture_memory);

alignas(Arena::alignment) std::byte memory[memory_needed];

/// Says what is wrong when that changes.
void report(const Turntable::Result& result) {
  static Turntable::Result last;
  if (result.display != last.display) {
    board::write("turntable: display ");
    board::write(to_string(result.display));
    board::write("\n");
  }
  if (result.drawing != last.drawing) {
    board::write("turntable: drawing ");
    board::write(to_string(result.drawing.fault));
    board::write(" ");
    board::write(to_string(result.drawing.pool));
    board::write("\n");
  }
  last = result;
}

/// A divider that gives less than the board's support asked for costs time, not the picture.
template <class Bus>
void report_clock(const Bus& bus) {
  if constexpr (requires { bus.clock_status(); }) {
    if (bus.clock_status() == hal::DisplayStatus::ok) return;
    board::write("turntable: display ");
    board::write(to_string(bus.clock_status()));
    board::write(", ");
    board::write_unsigned(bus.clock_hz());
    board::write(" Hz\n");
  }
}

/// Warns of a panel that gave another identity than its driver expects: it is driven all the same.
template <class Panel>
void report_identity(const Panel& panel) {
  if constexpr (requires { panel.identity_status(); }) {
    static hal::DisplayStatus last = hal::DisplayStatus::ok;
    if (panel.identity_status() == last) return;
    last = panel.identity_status();
    board::write("turntable: display ");
    board::write(to_string(last));
    board::write("\n");
  }
}

/// `before` is what the display had done when the frame began: the last one that nobody waited for to its end.
void report_shown(std::uint32_t frame, const hal::PresentStatistics& before) {
  board::write("turntable: frame ");
  board::write_unsigned(frame);
  board::write(" shown, the one before took ");
  board::write_unsigned(before.last_frame_us);
  board::write(" us, ");
  board::write_unsigned(before.last_wait_us);
  board::write(" of them waiting; stack ");
  board::write_unsigned(board::stack_used());
  board::write(" of ");
  board::write_unsigned(board::stack_size());
  board::write("\n");
}

}  // namespace

int main() {
  static board::DisplayBus bus;
  static board::DisplayClock clock;
  static board::DisplayPanel panel(bus, clock);
  static Turntable turntable(panel, clock, mesh, capacity, memory);
  report_clock(bus);
  hal::PresentStatistics before;
  for (std::uint32_t frame = 0;; ++frame) {
    const bool last = frame + 1 == frames_to_show;
    before = turntable.statistics();
    const Turntable::Result result = last ? turntable.show(frame) : turntable.show_and_go_on(frame);
    board::frame_done();
    report(result);
    report_identity(panel);
    if (result.ok() && (last || (frame == 0 && frames_to_show == 0))) report_shown(frame, before);
    if (last) break;
  }
  for (;;) {
    clock.delay_us(100'000);
    board::frame_done();
  }
}
