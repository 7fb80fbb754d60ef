#pragma once
#include <cstdint>

#include "spanline/math/bits.hpp"
#include "spanline/math/integer.hpp"

namespace spanline::texture_range {

/// Whether u/w and v/w are in [0, 1].
[[nodiscard]] inline bool in_range(std::uint32_t w, std::uint32_t u, std::uint32_t v) {
  return signed_word(w) > 0 && u <= w && v <= w;
}

/// Whether a parabola is accurate enough for a block at whose end w has fallen by `fall` to `w`: w changes by at most a
/// quarter.
[[nodiscard]] inline bool gentle(std::uint32_t fall, std::uint32_t w) { return magnitude(signed_word(fall)) <= w >> 2; }

}  // namespace spanline::texture_range
