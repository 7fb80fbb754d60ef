// From the ring oscillator to 125 MHz: crystal 12 MHz, PLL 1500 MHz over 6 and 2, which clocks the cores and the
// peripherals (RP2040 data sheet, sections 2.15 to 2.18). A crystal or PLL that does not come up leaves nothing to
// report with: the loops here have no end, and the board stays dark.
#include "linker.hpp"
#include "registers.hpp"
#include "start.hpp"

namespace {

using namespace spanline::board;

constexpr std::uintptr_t crystal_control = 0x40024000, crystal_status = 0x40024004, crystal_startup = 0x4002400c;
constexpr std::uintptr_t pll_control = 0x40028000, pll_power = 0x40028004, pll_feedback = 0x40028008,
                         pll_dividers = 0x4002800c;
constexpr std::uintptr_t reference_control = 0x40008030, reference_selected = 0x40008038, system_control = 0x4000803c,
                         system_divider = 0x40008040, system_selected = 0x40008044, peripheral_control = 0x40008048;

void wait_for(std::uintptr_t address, std::uint32_t bits) {
  while ((io(address) & bits) == 0) {
  }
}

void start_crystal() {
  constexpr std::uint32_t range_1_to_15_mhz = 0xaa0, enable = 0xfab << 12, stable = 1U << 31;
  io(crystal_startup) = crystal_hz / 1000 / 256 + 1;  // 1 ms in units of 256 periods
  io(crystal_control) = range_1_to_15_mhz | enable;
  wait_for(crystal_status, stable);
}

void start_pll() {
  constexpr std::uint32_t times = 125, divide_first = 6, divide_second = 2;
  static_assert(crystal_hz * times / divide_first / divide_second == system_clock_hz);
  constexpr std::uint32_t power_down = 1U << 0, post_dividers_down = 1U << 3, oscillator_down = 1U << 5;
  constexpr std::uint32_t locked = 1U << 31;
  resets::restart(resets::pll_sys);
  io(pll_control) = 1;  // reference divided by 1
  io(pll_feedback) = times;
  clear_bits(pll_power, power_down | oscillator_down);
  wait_for(pll_control, locked);
  io(pll_dividers) = divide_first << 16 | divide_second << 12;
  clear_bits(pll_power, post_dividers_down);
}

/// The system clock leaves the PLL before the PLL is touched, and comes back when that is steady: a reset by the
/// watchdog finds it running. Sources are switched without glitches only where the multiplexer has said so.
void use_reference() {
  constexpr std::uint32_t crystal = 2, source_is_reference = 1U << 0;
  clear_bits(system_control, 1);
  wait_for(system_selected, source_is_reference);
  io(reference_control) = crystal;
  wait_for(reference_selected, 1U << crystal);
}

void use_pll() {
  constexpr std::uint32_t auxiliary = 1, auxiliary_is_pll = 0, source_is_auxiliary = 1U << 1, undivided = 1U << 8;
  constexpr std::uint32_t peripheral_enable = 1U << 11;  // from the system clock
  io(system_divider) = undivided;
  io(system_control) = auxiliary_is_pll;
  io(system_control) = auxiliary_is_pll | auxiliary;
  wait_for(system_selected, source_is_auxiliary);
  io(peripheral_control) = peripheral_enable;
}

/// Below RAM lie the registers of the flash interface, where an overflow of the stack would not fault by itself. So the
/// lowest 256 bytes of the stack may be read and not written (Armv6-M Architecture Reference Manual, B3.5).
void guard_stack() {
  constexpr std::uintptr_t mpu_control = 0xe000ed94, mpu_base = 0xe000ed9c, mpu_attributes = 0xe000eda0;
  constexpr std::uint32_t region_valid = 1U << 4, privileged_read_only = 5U << 24, never_execute = 1U << 28,
                          size_256 = 7U << 1, enable = 1U << 0, default_map = 1U << 2;
  io(mpu_base) = static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(ld_stack_limit)) | region_valid;
  io(mpu_attributes) = privileged_read_only | never_execute | size_256 | enable;
  io(mpu_control) = default_map | enable;
}

}  // namespace

extern "C" void board_set_up() {
  guard_stack();
  start_crystal();
  use_reference();
  start_pll();
  use_pll();
  io(power_on::watchdog_select) = power_on::all_but_oscillators;
  io(watchdog::tick) = watchdog::tick_enable | crystal_hz / 1'000'000;
  resets::release(resets::io_bank0 | resets::pads_bank0 | resets::timer);
}
