#include "microsecond_clock.hpp"

#include "interrupts.hpp"
#include "registers.hpp"

namespace {

using namespace spanline::board;

// Timer (RP2040 data sheet, section 4.6).
constexpr std::uintptr_t timer_alarm_0 = 0x40054010, timer_now = 0x40054028, timer_interrupts = 0x40054034,
                         timer_enable = 0x40054038;
constexpr std::uint32_t alarm_0 = 1U << 0;

/// Shorter waits are not worth an interrupt.
constexpr std::uint32_t shortest_sleep_us = 100;

volatile bool alarm_rang = false;

/// An alarm rings when the time is equal to it, so it must be set while it still lies ahead.
void sleep_us(std::uint32_t us) {
  alarm_rang = false;
  io(timer_enable) = alarm_0;
  io(nvic::set_enable) = nvic::timer_0;
  io(timer_alarm_0) = io(timer_now) + us;
  while (!alarm_rang) {
    // With interrupts masked the one that is pending ends the sleep all the same, and none slips in before it.
    asm volatile("cpsid i" ::: "memory");
    if (!alarm_rang) asm volatile("wfi");
    asm volatile("cpsie i" ::: "memory");
  }
}

}  // namespace

namespace spanline::board {

void timer_alarm() {
  io(timer_interrupts) = alarm_0;
  alarm_rang = true;
}

std::uint32_t MicrosecondClock::now_us() const { return io(timer_now); }

void MicrosecondClock::delay_us(std::uint32_t us) const {
  // The current microsecond has begun already: one more makes sure.
  const std::uint32_t start = now_us();
  if (us >= shortest_sleep_us) sleep_us(us);
  while (now_us() - start <= us) {
  }
}

}  // namespace spanline::board
