#pragma once
#include <cstdint>

namespace spanline::scenes {

/// Marsaglia's xorshift32 with shifts 13, 17, 5: the same numbers on every machine.
class Random {
 public:
  explicit constexpr Random(std::uint32_t seed = 0x12345678) : state_(seed) {}
  constexpr std::uint32_t operator()() {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 17;
    state_ ^= state_ << 5;
    return state_;
  }
  /// A number in [0, bound).
  constexpr std::uint32_t below(std::uint32_t bound) { return (*this)() % bound; }

 private:
  std::uint32_t state_;
};

}  // namespace spanline::scenes
