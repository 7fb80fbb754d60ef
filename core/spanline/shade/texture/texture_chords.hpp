#pragma once
#include <cstdint>

#include "spanline/math/bits.hpp"
#include "spanline/math/integer.hpp"

namespace spanline::texture_chords {

/// Whether u/w and v/w are in [0, 1].
[[nodiscard]] inline bool in_range(std::uint32_t w, std::uint32_t u, std::uint32_t v) {
  return signed_word(w) > 0 && u <= w && v <= w;
}

/// Whether a parabola follows the hyperbola over a block in which w falls by `fall` to `w` at its end.
[[nodiscard]] inline bool gentle(std::uint32_t fall, std::uint32_t w) { return magnitude(signed_word(fall)) <= w >> 2; }

/// Chords of the parabola through both ends whose middle lies `bow`/2^16 of their distance back from the straight line:
/// their steps grow by an eighth of that from one to the next. The chords are moved by 3/64 of it, which more than
/// halves the mean error of the columns.
[[gnu::always_inline]] inline void set_chords(std::uint32_t from, std::uint32_t to, std::int32_t bow, std::uint32_t& at,
                                              std::uint32_t& step, std::uint32_t& bend) {
  const std::int32_t distance = signed_word(to - from);
  const std::int32_t back = signed_word(word(distance >> 12) * word(bow)) >> 4;
  const std::int32_t three = back + 2 * back;
  at = from - word(back >> 5);
  step = word((distance - three) >> 4);
  bend = word(back >> 3);
}

}  // namespace spanline::texture_chords
