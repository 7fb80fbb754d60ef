#pragma once

#include <cstdint>
#include <span>

#include "spanline/hal/bus.hpp"

namespace spanline::board {

/// Pins of the display's connector.
namespace display_pins {
inline constexpr unsigned miso = 16, chip_select = 17, clock = 18, mosi = 19, data_command = 20, reset = 21,
                          backlight = 22;
}  // namespace display_pins

/// A display on SPI0: the HAL's bus concept. DMA channel 0 feeds the transmit FIFO, and the interrupt at the end of a
/// band starts the next one, which the FIFO's eight bytes leave 128 cycles of the core for: bands that wait in the
/// queue leave without a gap. Chip select is high for a moment before each command and low otherwise: the display is
/// alone on these wires.
///
/// SPI mode 3: displays take it as well as mode 0, in which this peripheral pauses between bytes (RP2040 data
/// sheet, 4.4.3, "Motorola SPI Format with SPO=0, SPH=0").
class SpiBus {
 public:
  /// Sets up pins, peripheral, DMA and interrupt; the clock is the highest one of the divider that is not above
  /// `asked_hz`. At most one object at a time.
  explicit SpiBus(std::uint32_t asked_hz);

  hal::DisplayStatus command(std::span<const std::uint8_t> bytes);
  hal::DisplayStatus pixels(std::span<const std::uint8_t> bytes);
  bool busy() const;
  void reset(bool held);
  void backlight(bool lit);
  std::uint32_t clock_hz() const { return clock_hz_; }

  /// More than busy(): bands may queue. See hal::QueueingBus.
  bool takes_pixels() const;
  std::uint32_t transfers_left() const;

  /// bus_clock_too_low if the divider gave less than was asked for.
  hal::DisplayStatus clock_status() const {
    return clock_hz_ < asked_hz_ ? hal::DisplayStatus::bus_clock_too_low : hal::DisplayStatus::ok;
  }

 protected:
  hal::DisplayStatus read_bytes(std::uint8_t command, std::span<std::uint8_t> answer);

 private:
  void set_up() const;

  std::uint32_t asked_hz_, clock_hz_;
};

/// The same with a line back from the display.
class ReadableSpiBus : public SpiBus {
 public:
  explicit ReadableSpiBus(std::uint32_t asked_hz);
  hal::DisplayStatus read(std::uint8_t command, std::span<std::uint8_t> answer) { return read_bytes(command, answer); }
};

}  // namespace spanline::board
