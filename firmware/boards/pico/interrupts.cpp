#include "interrupts.hpp"

#include <cstdint>

/// All of the chip's interrupts come here; IPSR says which one it is.
extern "C" [[gnu::section(".time_critical.interrupt_handler")]] void interrupt_handler() {
  constexpr std::uint32_t first_interrupt = 16, timer_0 = first_interrupt + 0;
  std::uint32_t number = 0;
  asm volatile("mrs %0, ipsr" : "=r"(number));
  if (number == timer_0) {
    spanline::board::timer_alarm();
  } else {
    spanline::board::band_sent();
  }
}
