#pragma once

#include <cstdint>
#include <span>

#include "registers.hpp"
#include "spanline/hal/bus.hpp"

namespace spanline::board {

/// The board's OLED (SSD0323, 128×64) on SSI0, a PL022: the HAL's bus concept. D/C is PC7. Chip select is the
/// peripheral's own frame signal; PD0 deselects the SD card on the same wires (in QEMU: high selects the OLED).
/// The chip has no DMA for SSI0, so an interrupt feeds the transmit FIFO while the program goes on.
class OledBus {
 public:
  /// Sets up pins, peripheral and interrupt. At most one object at a time.
  OledBus();

  hal::DisplayStatus command(std::span<const std::uint8_t> bytes);
  hal::DisplayStatus pixels(std::span<const std::uint8_t> bytes);
  bool busy() const;

  /// The board has no reset line to the panel: `held` abandons the transfer in flight.
  void reset(bool held);

  static constexpr std::uint32_t clock_hz() { return system_clock_hz / clock_divisor; }

 private:
  /// Even, 2 to 254 (LM3S6965 data sheet, SSI clock prescale): 3.57 MHz, where the SSD0323 is rated for 4.
  static constexpr std::uint32_t clock_divisor = 14;
};

}  // namespace spanline::board
