#pragma once
#include <cstdint>

namespace spanline::sim {

/// A simulated clock that satisfies hal::Clock. Time passes only when someone waits, sends bytes or reads the clock:
/// each reading costs a microsecond, so that loops which poll until a deadline come to an end.
class SimClock {
 public:
  /// Microseconds modulo 2^32, as hal::Clock has it.
  std::uint32_t now_us() {
    advance_ns(1000);
    return static_cast<std::uint32_t>(now_ns_ / 1000);
  }
  void delay_us(std::uint32_t us) { advance_ns(std::uint64_t{us} * 1000); }

  /// Nanoseconds since the start; reading them costs nothing.
  [[nodiscard]] std::uint64_t now_ns() const { return now_ns_; }
  void advance_ns(std::uint64_t ns) { now_ns_ += ns; }

 private:
  std::uint64_t now_ns_ = 0;
};

}  // namespace spanline::sim
