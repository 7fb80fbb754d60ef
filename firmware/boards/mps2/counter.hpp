#pragma once

#include <cstdint>

#include "cycle_markers.hpp"

/// Instruction counter: the board's TIMER0 (CMSDK APB timer, Arm DDI 0479, "APB components"), which counts down at 25
/// MHz. QEMU run with `-icount shift=6` lets 64 ns pass an instruction, so an instruction is 1.6 ticks, exactly. On
/// silicon the figures are ticks of 1.6 and mean time, not instructions.
namespace spanline::board {

inline volatile std::uint32_t& timer0(std::uint32_t offset) {
  return *reinterpret_cast<volatile std::uint32_t*>(0x40000000 + offset);
}

/// Starts counting at zero. Good for 2,600 million instructions.
inline void counter_start() {
  timer0(0x0) = 0;           // CTRL: stop
  timer0(0x8) = 0xffffffff;  // RELOAD
  timer0(0x4) = 0xffffffff;  // VALUE
  timer0(0x0) = 1;           // CTRL: run
  cycles_start();
}

/// Instructions between the timer's start and its reading that are neither the program's nor optional: the two markers
/// and what makes the timer's address.
inline constexpr std::uint32_t counter_overhead = 5;

/// Instructions since `counter_start`, rounded, give or take two.
inline std::uint32_t counter_read() {
  cycles_stop();
  const std::uint32_t ticks = 0xffffffff - timer0(0x4);
  // ticks * 5 / 8 within 32 bits.
  return ticks / 8 * 5 + (ticks % 8 * 5 + 4) / 8 - counter_overhead;
}

/// Has the cycle counter of tests/qemu/cycles, where there is one, report what it counted since the last call.
inline void counter_report() { cycles_report(); }

}  // namespace spanline::board
