#pragma once
#include <cstdint>

#include "spanline/math/bits.hpp"

namespace spanline {

/// Sets the chords of a block's parabola. The parabola goes through both ends of the block, and its middle lies behind
/// the straight line by `bow`/2^16 of the distance between them. From one piece to the next, the step grows by an
/// eighth of that deviation. The chords are shifted by 3/64 of it, which more than halves the mean error of the
/// columns.
[[gnu::always_inline]] inline void set_chords(std::uint32_t from, std::uint32_t to, std::int32_t bow, std::uint32_t& at,
                                              std::uint32_t& step, std::uint32_t& gain) {
  const std::int32_t distance = signed_word(to - from);
  const std::int32_t back = signed_word(word(distance >> 12) * word(bow)) >> 4;
  const std::int32_t three = back + 2 * back;
  at = from - word(back >> 5);
  step = word((distance - three) >> 4);
  gain = word(back >> 3);
}

}  // namespace spanline
