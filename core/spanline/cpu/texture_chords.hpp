#pragma once
#include <cstdint>

#include "spanline/math/bits.hpp"

namespace spanline {

/// Sets the chords of a block's parabola. The parabola goes through both ends of the block, and its middle lies behind
/// the straight line by `bow`/2^16 of the distance between them. From one piece to the next, the step grows by an
/// eighth of that deviation. The chords are shifted by 3/64 of it, which more than halves the mean error of the
/// columns. Coordinates are words modulo 2^32; a distance below 2^30 is the one that is meant.
[[gnu::always_inline]] inline void set_chords(std::uint32_t from, std::uint32_t to, std::int32_t bow, std::uint32_t& at,
                                              std::uint32_t& step, std::uint32_t& gain) {
  const std::int32_t distance = signed_word(to - from);
  const std::int32_t back = signed_word(word(distance >> 12) * word(bow)) >> 4;
  at = from - word(back >> 5);
  step = word(signed_word(word(distance) - 3 * word(back)) >> 4);
  gain = word(back >> 3);
}

}  // namespace spanline
