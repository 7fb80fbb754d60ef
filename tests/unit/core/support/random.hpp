#pragma once
#include <cstdint>
#include <random>

namespace spanline::test {

/// Random numbers that are the same on every machine.
class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}

  /// A whole number in [low, high].
  [[nodiscard]] int between(int low, int high) { return static_cast<int>(wide(low, high)); }
  [[nodiscard]] std::int64_t wide(std::int64_t low, std::int64_t high) {
    // Modulo 2^64, where the distance of the two has room.
    const auto from = static_cast<std::uint64_t>(low), distance = static_cast<std::uint64_t>(high) - from;
    return static_cast<std::int64_t>(from + engine_() % (distance + 1));
  }
  [[nodiscard]] bool chance(int of) { return between(1, of) == 1; }
  /// A real number in [low, high).
  [[nodiscard]] double real(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace spanline::test
