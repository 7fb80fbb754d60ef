// Proves clock, bus and interrupt of a board with the OLED: two bands through the panel's driver, each pixel of grey
// level (x + 3y) modulo 16, in a hurry and with overlap. tests/qemu/oled_pattern.py looks at the picture.
#include <array>
#include <board.hpp>
#include <oled_bus.hpp>
#include <spanline/hal/panels/ssd0323.hpp>
#include <spanline/hal/present.hpp>
#include <system_clock.hpp>

namespace {

using namespace spanline;
using Panel = hal::Ssd0323<board::OledBus, board::SystemClock>;

constexpr int band_rows = 8;
constexpr std::size_t band_pixels = band_rows * Panel::width;
std::array<std::uint16_t, band_pixels> first_band, second_band;

constexpr std::uint16_t grey_565(unsigned level) {
  return static_cast<std::uint16_t>((2 * level + 1) << 11 | (4 * level + 2) << 5 | (2 * level + 1));
}

void draw(int row, std::span<std::uint16_t> band) {
  for (unsigned i = 0; i < band.size(); ++i) {
    const unsigned x = i % Panel::width, y = static_cast<unsigned>(row) + i / Panel::width;
    band[i] = grey_565((x + 3 * y) % 16);
  }
}

hal::DisplayStatus show(hal::Present<Panel, board::SystemClock>& present) {
  hal::DisplayStatus status = present.begin_frame();
  for (int row = 0, index = 0; status == hal::DisplayStatus::ok && row < Panel::height; row += band_rows, index ^= 1) {
    status = present.acquire(index);
    if (status != hal::DisplayStatus::ok) break;
    draw(row, present.buffer(index));
    status = present.submit(row, row + band_rows, index);
  }
  return status == hal::DisplayStatus::ok ? present.end_frame() : status;
}

}  // namespace

int main() {
  board::OledBus bus;
  board::SystemClock clock;
  const std::uint32_t start = clock.now_us();
  clock.delay_us(2'500);
  const std::uint32_t waited = clock.now_us() - start;
  if (waited < 2'500 || waited > 2'600) {
    board::write("the clock is wrong\n");
    return 2;
  }
  Panel panel(bus, clock);
  hal::Present<Panel, board::SystemClock> present(panel, clock, first_band, second_band);
  const hal::DisplayStatus status = show(present);
  board::write(status == hal::DisplayStatus::ok ? "picture complete\n" : hal::to_string(status));
  for (;;) asm volatile("wfi");
}
