#include "system_clock.hpp"

#include "board.hpp"
#include "registers.hpp"
#include "start.hpp"

namespace {

using spanline::board::io;
using spanline::board::system_clock_hz;

constexpr std::uint32_t ticks_a_microsecond = system_clock_hz / 1'000'000;
constexpr std::uint32_t ticks_a_millisecond = system_clock_hz / 1'000;

// SysTick (Armv7-M Architecture Reference Manual, B3.3).
constexpr std::uintptr_t systick_control = 0xe000e010, systick_reload = 0xe000e014, systick_value = 0xe000e018;

// System control (LM3S6965 data sheet, chapter "System Control").
constexpr std::uintptr_t raw_interrupt_status = 0x400fe050, run_mode_clock = 0x400fe060;

volatile std::uint32_t milliseconds = 0;

/// From the internal oscillator to the PLL: the 8 MHz crystal, and 200 MHz over four. The steps are those of the data
/// sheet's section "Initialization and Configuration" of that chapter.
void start_pll() {
  constexpr std::uint32_t crystal_off = 1U << 0, oscillator_source = 3U << 4, crystal = 15U << 6, bypass = 1U << 11,
                          pll_off = 1U << 13, use_divider = 1U << 22, divider = 15U << 23;
  constexpr std::uint32_t crystal_8_mhz = 14U << 6, divide_by_4 = 3U << 23, pll_locked = 1U << 6;
  constexpr int polls = 1'000'000;

  std::uint32_t clock = (io(run_mode_clock) | bypass) & ~use_divider;
  io(run_mode_clock) = clock;
  clock = (clock & ~(crystal | oscillator_source | pll_off | crystal_off)) | crystal_8_mhz;
  io(run_mode_clock) = clock;
  clock = (clock & ~divider) | divide_by_4 | use_divider;
  io(run_mode_clock) = clock;
  for (int poll = 0; poll < polls; ++poll) {
    if ((io(raw_interrupt_status) & pll_locked) != 0) {
      io(run_mode_clock) = clock & ~bypass;
      return;
    }
  }
  spanline::board::write("lm3s6965evb: the PLL does not lock\n");
  spanline::board::exit(1);
}

void start_ticking() {
  constexpr std::uint32_t enable = 1U << 0, interrupt = 1U << 1, core_clock = 1U << 2;
  io(systick_reload) = ticks_a_millisecond - 1;
  io(systick_value) = 0;
  io(systick_control) = enable | interrupt | core_clock;
}

}  // namespace

extern "C" void systick_handler() { milliseconds = milliseconds + 1; }

extern "C" void board_set_up() {
  start_pll();
  start_ticking();
}

namespace spanline::board {

std::uint32_t SystemClock::now_us() const {
  // The tick may come between the two readings: read until the millisecond is the same before and after.
  std::uint32_t before = 0, ticks_left = 0;
  do {
    before = milliseconds;
    ticks_left = io(systick_value);
  } while (before != milliseconds);
  return before * 1'000 + (ticks_a_millisecond - 1 - ticks_left) / ticks_a_microsecond;
}

void SystemClock::delay_us(std::uint32_t us) const {
  // The current microsecond has begun already: one more makes sure.
  const std::uint32_t start = now_us();
  while (now_us() - start <= us) {
  }
}

}  // namespace spanline::board
