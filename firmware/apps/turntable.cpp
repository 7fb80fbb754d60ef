// The bunny on a turntable, for any board with a display (display.hpp) and 43 KB to spare. The image that tests run
// stops after SPANLINE_TURNTABLE_FRAMES frames; 0 goes on for ever.
#include "turntable.hpp"

#include <bunny.hpp>

#include "board.hpp"
#include "display.hpp"
#include "picture_memory.hpp"

namespace {

using namespace spanline;

using Turntable = apps::Turntable<board::DisplayPanel, board::DisplayClock>;

constexpr std::uint32_t frames_to_show = SPANLINE_TURNTABLE_FRAMES;

// Enough for the bunny from every side; tests/selftest holds all frames against it.
constexpr Capacity capacity = Turntable::capacity(spanline_models::bunny, 8, 1700, 100);
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

void report_shown(std::uint32_t frame) {
  board::write("turntable: frame ");
  board::write_unsigned(frame);
  board::write(" shown, stack ");
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
  static Turntable turntable(panel, clock, spanline_models::bunny, capacity, memory);
  for (std::uint32_t frame = 0; frames_to_show == 0 || frame < frames_to_show; ++frame) {
    const Turntable::Result result = turntable.show(frame);
    report(result);
    if (result.ok() && frame + 1 == (frames_to_show == 0 ? 1 : frames_to_show)) report_shown(frame);
  }
  for (;;) asm volatile("wfi");
}
