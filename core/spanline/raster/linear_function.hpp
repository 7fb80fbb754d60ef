#pragma once
#include <cstdint>

#include "spanline/math/bits.hpp"

namespace spanline {

/// A quantity over the screen as an integer-linear function modulo 2^32: at column c (counted from the function's own
/// column of origin) of its current row it is at_origin + c·dx. Any order of increments gives the same word, which is
/// why all algorithms and all band heights agree. For depth, dx is the lectures' −A/C and dy their −B/C.
struct LinearFunction {
  std::uint32_t at_origin;
  std::uint32_t dx;
  std::uint32_t dy;

  [[nodiscard]] std::uint32_t at(std::int32_t column) const { return at_origin + dx * word(column); }
  void next_row() { at_origin += dy; }
  void skip_rows(std::int32_t rows) { at_origin += dy * word(rows); }

  /// The same function with every word complemented: smaller becomes larger.
  [[nodiscard]] LinearFunction complemented() const { return {~at_origin, 0u - dx, 0u - dy}; }
};

}  // namespace spanline
