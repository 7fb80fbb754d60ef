#include "spanline/math/power.hpp"

#include <array>

#include "spanline/math/bits.hpp"
#include "spanline/math/integer.hpp"

namespace spanline {
namespace {

constexpr unsigned log_bits = 7, exponential_bits = 6;

/// log2(value / 2^62) in Q16 for a value in [2^62, 2^63). Squaring the mantissa doubles its logarithm, whose integer
/// part, 0 or 1, is the next binary digit (Knuth, The Art of Computer Programming, volume 1, section 1.2.2).
constexpr std::uint32_t fraction_of_log2(std::uint64_t value) {
  std::uint64_t mantissa = value >> 31;  // Q31
  std::uint32_t digits = 0;
  constexpr int count = 20;
  for (int i = 0; i < count; ++i) {
    mantissa = mantissa * mantissa >> 31;
    const auto digit = static_cast<std::uint32_t>(mantissa >> 32);
    digits = digits << 1 | digit;
    mantissa >>= digit;
  }
  return (digits + (1u << (count - 17))) >> (count - 16);
}

/// log2(1 + i / 128) in Q16. The last entry, 65536, is stored as 0, since differences of neighbours are taken modulo
/// 2^16.
constexpr std::array<std::uint16_t, (1u << log_bits) + 1> logarithms = [] {
  std::array<std::uint16_t, (1u << log_bits) + 1> table{};
  for (std::size_t i = 0; i < 1u << log_bits; ++i)
    table[i] = static_cast<std::uint16_t>(fraction_of_log2((std::uint64_t{1u << log_bits} + i) << (62 - log_bits)));
  return table;
}();

/// 2^(−i / 64) in units of 1/65535.
constexpr std::array<std::uint16_t, (1u << exponential_bits) + 1> exponentials = [] {
  std::array<std::uint16_t, (1u << exponential_bits) + 1> table{};
  std::uint64_t root = std::uint64_t{1} << 31;  // 1/2 in Q32, then its repeated square roots
  std::array<std::uint64_t, exponential_bits + 1> roots{};
  for (std::uint64_t& r : roots) {
    r = root;
    root = square_root(root << 32);
  }
  for (unsigned i = 0; i < table.size(); ++i) {
    std::uint64_t value = std::uint64_t{1} << 32;
    for (unsigned bit = 0; bit <= exponential_bits; ++bit)
      if ((i >> bit & 1) != 0) value = value * roots[exponential_bits - bit] >> 32;
    table[i] = static_cast<std::uint16_t>((value * 65535 + (std::uint64_t{1} << 31)) >> 32);
  }
  return table;
}();

}  // namespace

std::uint32_t power(std::uint32_t base, std::uint32_t exponent) {
  const int zeros = leading_zeros_32(base);
  // The mantissa without its leading 1: the index of a table entry, and the position between it and the next in Q16.
  const std::uint32_t fraction = base << zeros << 1;
  const std::uint32_t entry = fraction >> (32 - log_bits), way = (fraction >> (16 - log_bits)) & 65535;
  const std::uint32_t step = (std::uint32_t{logarithms[entry + 1]} - logarithms[entry]) & 65535;
  // −log2(base) in Q20: base is mantissa · 2^(1 − zeros).
  const std::uint32_t logarithm = ((std::uint32_t{logarithms[entry]} << 16) + step * way) >> 12;
  const std::uint32_t fall = (word(zeros - 1) << 20) - logarithm;
  const std::uint32_t whole = fall * exponent;  // below 2^32, since fall is at most 30 · 2^20
  const std::uint32_t halvings = whole >> 20;
  if (halvings > 16) return 0;
  const std::uint32_t part = (whole >> (20 - exponential_bits)) & ((1u << exponential_bits) - 1),
                      rest = whole & ((1u << (20 - exponential_bits)) - 1);
  const std::uint32_t from = exponentials[part], drop = from - exponentials[part + 1];
  const std::uint32_t value = from - (drop * rest >> (20 - exponential_bits));
  return (value + (value >> 15)) >> halvings;
}

}  // namespace spanline
