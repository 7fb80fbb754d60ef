#pragma once
#include <cstdint>

#include "spanline/math/bits.hpp"

namespace spanline {

/// A quantity over the screen as an integer-linear function modulo 2^32. At column c of its current row, counted from
/// the function's column of origin, the value is at_origin + c·dx. Any order of increments gives the same word, so all
/// algorithms and band heights give the same values. For depth, dx is the lectures' −A/C and dy their −B/C.
struct LinearFunction {
  std::uint32_t at_origin;  ///< value at the column of origin on the current row
  std::uint32_t dx;         ///< increment from column to column
  std::uint32_t dy;         ///< increment from row to row

  [[nodiscard]] std::uint32_t at(std::int32_t column) const { return at_origin + dx * word(column); }
  void next_row() { at_origin += dy; }
  void skip_rows(std::int32_t rows) { at_origin += dy * word(rows); }

  /// The function times 2^bits.
  [[nodiscard]] LinearFunction shifted_left(std::uint32_t bits) const {
    return {at_origin << bits, dx << bits, dy << bits};
  }
  /// The function whose values are the complements ~z, which reverses their order.
  [[nodiscard]] LinearFunction complemented() const { return {~at_origin, 0u - dx, 0u - dy}; }
};

}  // namespace spanline
