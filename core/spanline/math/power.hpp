#pragma once
#include <cstdint>

namespace spanline {

/// base^exponent by two tables of a logarithm and its inverse, for highlights: base in Q30 of (0, 1], exponent in
/// [1, 128]; the result in 65536ths, [0, 65536], within 1/2048 of the exact power (tested).
[[nodiscard]] std::uint32_t power(std::uint32_t base, std::uint32_t exponent);

}  // namespace spanline
