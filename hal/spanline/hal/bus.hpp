#pragma once
/// @file
/// What a panel is driven over.
///
/// ```cpp
/// // The smallest bus, over pins that a board has: it waits where it could return early.
/// template <class Pins>
/// struct SlowBus {
///   hal::DisplayStatus command(std::span<const std::uint8_t> bytes) {
///     pins.set_data_line(false);
///     pins.shift_out(bytes.first(1));
///     return pixels(bytes.subspan(1));
///   }
///   hal::DisplayStatus pixels(std::span<const std::uint8_t> bytes) {
///     pins.set_data_line(true);
///     pins.shift_out(bytes);
///     return hal::DisplayStatus::ok;
///   }
///   bool busy() { return false; }
///   void reset(bool held) { pins.set_reset_line(!held); }
///   std::uint32_t clock_hz() { return 8'000'000; }
///   Pins& pins;
/// };
/// ```
#include <concepts>
#include <cstdint>
#include <span>

#include "spanline/hal/display_status.hpp"

namespace spanline::hal {

/// A display bus: SPI with a data/command line, chip select and reset line, in the hands of a board or of a host model.
///
/// - `command(bytes)`: sends bytes[0] with D/C low and the rest, its arguments, with D/C high (MIPI DCS). A panel that
///   takes arguments as commands (SSD0323) sends each byte in a call of its own. Called only while not busy; when it
///   returns the bytes have left, so `bytes` may lie on the stack, and the bus is not busy. `bus_timeout` if the
///   hardware does not take them: the bus bounds its own polling.
/// - `pixels(bytes)`: starts a transfer with D/C high and may return before the bytes have left. From here on the
///   buffer belongs to the bus, until busy() has returned false. Called only while not busy.
/// - `busy()`: whether bytes of the last pixels() call are still to leave. Never blocks.
/// - `reset(held)`: true pulls the panel's reset line low and abandons a transfer in flight, false lets the line go. A
///   board without that line only abandons the transfer. If busy() stays true afterwards, the bus is stuck.
/// - `clock_hz()`: the serial clock that the divider really gave, in hertz, for the panel's clock rating.
template <typename B>
concept Bus = requires(B& bus, std::span<const std::uint8_t> bytes, bool held) {
  { bus.command(bytes) } -> std::same_as<DisplayStatus>;
  { bus.pixels(bytes) } -> std::same_as<DisplayStatus>;
  { bus.busy() } -> std::same_as<bool>;
  { bus.reset(held) } -> std::same_as<void>;
  { bus.clock_hz() } -> std::same_as<std::uint32_t>;
};

/// A bus whose board switches the panel's backlight.
///
/// - `backlight(lit)`: switches it. It is off from start-up on until a driver switches it on, behind the first picture.
template <typename B>
concept BacklitBus = Bus<B> && requires(B& bus, bool lit) {
  { bus.backlight(lit) } -> std::same_as<void>;
};

/// A bus with a line back from the panel.
///
/// - `read(command, answer)`: sends the command and takes in as many bytes as `answer` holds, the chip's first empty
/// one
///   included, at a clock that panels can be read at (5 MHz at most). Called only while not busy.
template <typename B>
concept ReadableBus = Bus<B> && requires(B& bus, std::uint8_t command, std::span<std::uint8_t> answer) {
  { bus.read(command, answer) } -> std::same_as<DisplayStatus>;
};

/// A bus whose pixels() calls queue: each starts by itself when those before it have left, in order.
///
/// - `takes_pixels()`: whether pixels() may be called now; it says bus_busy otherwise. The first commands after pixels
///   still want a bus that is not busy.
/// - `transfers_left()`: how many pixels() calls have bytes left in their buffers.
template <typename B>
concept QueueingBus = Bus<B> && requires(const B& bus) {
  { bus.takes_pixels() } -> std::same_as<bool>;
  { bus.transfers_left() } -> std::same_as<std::uint32_t>;
};

}  // namespace spanline::hal
