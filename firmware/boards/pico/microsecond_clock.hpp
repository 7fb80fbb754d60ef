#pragma once

#include <cstdint>

namespace spanline::board {

/// The HAL's clock concept over the RP2040's timer, which counts microseconds since reset. Long delays sleep.
class MicrosecondClock {
 public:
  /// Microseconds since start-up, modulo 2^32.
  std::uint32_t now_us() const;

  /// Returns no sooner than `us` microseconds from now.
  void delay_us(std::uint32_t us) const;
};

}  // namespace spanline::board
