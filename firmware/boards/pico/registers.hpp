#pragma once

#include <cstdint>

/// The few registers of the RP2040 that this board support uses, by the names of its data sheet.
namespace spanline::board {

inline constexpr std::uint32_t crystal_hz = 12'000'000;
/// Frequency of the cores and of the peripheral clock once start-up has set the PLL, hertz.
inline constexpr std::uint32_t system_clock_hz = 125'000'000;

inline volatile std::uint32_t& io(std::uintptr_t address) {
  return *reinterpret_cast<volatile std::uint32_t*>(address);
}

/// Reads for the reading's own effect.
inline void touch(std::uintptr_t address) { [[maybe_unused]] const std::uint32_t value = io(address); }

/// Every register of the peripheral buses has aliases that set or clear bits in one write (section 2.1.2).
inline void set_bits(std::uintptr_t address, std::uint32_t bits) { io(address + 0x2000) = bits; }
inline void clear_bits(std::uintptr_t address, std::uint32_t bits) { io(address + 0x3000) = bits; }

/// Subsystem resets (section 2.14): takes blocks out of reset, and waits until they are.
namespace resets {
inline constexpr std::uintptr_t base = 0x4000c000, done = base + 0x8;
inline constexpr std::uint32_t dma = 1U << 2, io_bank0 = 1U << 5, pads_bank0 = 1U << 8, pll_sys = 1U << 12,
                               spi0 = 1U << 16, timer = 1U << 21, uart0 = 1U << 22;
inline void release(std::uint32_t blocks) {
  clear_bits(base, blocks);
  while ((io(done) & blocks) != blocks) {
  }
}
/// Puts blocks back to how they are after power-up.
inline void restart(std::uint32_t blocks) {
  set_bits(base, blocks);
  release(blocks);
}
}  // namespace resets

/// What the watchdog resets, a bit a block of the power-on state machine (section 2.13). After power-up no bit is set,
/// and a watchdog that runs out resets nothing. The oscillators stay: a reset must not stop the clock that it runs on.
namespace power_on {
inline constexpr std::uintptr_t watchdog_select = 0x40010008;
inline constexpr std::uint32_t all_blocks = (1U << 17) - 1, ring_oscillator = 1U << 0, crystal_oscillator = 1U << 1;
inline constexpr std::uint32_t all_but_oscillators = all_blocks & ~(ring_oscillator | crystal_oscillator);
}  // namespace power_on

/// Pins (section 2.19): the function select of a pin's control register.
namespace pins {
inline constexpr std::uint32_t spi = 1, uart = 2, sio = 5;
inline void select(unsigned pin, std::uint32_t function) { io(0x40014000 + 8 * pin + 4) = function; }
/// Pad control: pull the pin up, input enabled, 4 mA.
inline void pull_up(unsigned pin) { io(0x4001c000 + 4 + 4 * pin) = 1U << 6 | 1U << 4 | 1U << 3 | 1U << 1; }
/// Pad control: 8 mA and fast edges, for a serial clock of 62.5 MHz.
inline void drive_fast(unsigned pin) { io(0x4001c000 + 4 + 4 * pin) = 1U << 6 | 2U << 4 | 1U << 1 | 1U << 0; }
}  // namespace pins

/// Single-cycle IO (section 2.3.1): output levels and directions, a bit a pin.
namespace sio {
inline constexpr std::uintptr_t out_set = 0xd0000014, out_clear = 0xd0000018, direction_set = 0xd0000024;
}  // namespace sio

/// Watchdog (section 4.7), which also makes the microsecond tick of the timer.
namespace watchdog {
inline constexpr std::uintptr_t control = 0x40058000, load = 0x40058004, tick = 0x4005802c;
inline constexpr std::uint32_t enable = 1U << 30, tick_enable = 1U << 9;
}  // namespace watchdog

/// Interrupts of the core: set-enable and clear-pending, a bit an interrupt.
namespace nvic {
inline constexpr std::uintptr_t set_enable = 0xe000e100, clear_pending = 0xe000e280;
inline constexpr std::uint32_t timer_0 = 1U << 0, dma_0 = 1U << 11;
}  // namespace nvic

}  // namespace spanline::board
