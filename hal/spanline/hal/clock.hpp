#pragma once
/// @file
/// What drivers and the present loop tell the time by.
///
/// ```cpp
/// // Over a timer that counts microseconds.
/// struct TimerClock {
///   std::uint32_t now_us() { return *timer; }
///   void delay_us(std::uint32_t us) {
///     for (const std::uint32_t start = *timer; *timer - start <= us;) {}
///   }
///   const volatile std::uint32_t* timer;
/// };
/// static_assert(hal::Clock<TimerClock>);
/// ```
#include <concepts>
#include <cstdint>

namespace spanline::hal {

/// A clock of a board or of a simulation.
///
/// - `now_us()`: microseconds since some start, wrapping at 2^32 (after 71.6 minutes). Only differences mean anything;
///   taken modulo 2^32 they are right for spans below that.
/// - `delay_us(us)`: returns no sooner than `us` microseconds from now.
template <typename C>
concept Clock = requires(C& clock, std::uint32_t us) {
  { clock.now_us() } -> std::same_as<std::uint32_t>;
  { clock.delay_us(us) } -> std::same_as<void>;
};

/// A free-running counter of processor cycles or instructions, wrapping at 2^32; benchmarks take differences.
template <typename C>
concept CycleCounter = requires(C& counter) {
  { counter.cycles() } -> std::same_as<std::uint32_t>;
};

/// Waits for `ms` milliseconds, at most 4,294,967.
template <Clock C>
void delay_ms(C& clock, std::uint32_t ms) {
  clock.delay_us(ms * 1000U);
}

}  // namespace spanline::hal
