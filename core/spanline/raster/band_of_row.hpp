#pragma once
#include <cstdint>

#include "spanline/math/bits.hpp"
#include "spanline/math/integer.hpp"

namespace spanline {

/// Computes the band of a row, row / lines, without a divide instruction. The inverse 2^shift / lines is rounded up, by
/// less than 1. Over 2,047 rows the quotient is thus too large by less than 2^11 / 2^shift < 1 / lines, so its integer
/// part is exact.
class BandOfRow {
 public:
  BandOfRow() = default;
  /// lines in [1, 2047].
  explicit BandOfRow(std::uint32_t lines) : shift_(52 - leading_zeros_32(lines)) {
    inverse_ = ((1u << shift_) + lines - 1) / lines;  // at most 2^21
  }
  /// row in [0, 2047].
  [[nodiscard]] std::int32_t operator()(std::int32_t row) const {
    return signed_word((word(row) * inverse_) >> shift_);
  }

 private:
  std::uint32_t inverse_ = 1u << 21;  ///< 2^shift_ / lines, rounded up; at most 2^21
  int shift_ = 21;
};

}  // namespace spanline
