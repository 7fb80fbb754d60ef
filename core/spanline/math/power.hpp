#pragma once
#include <cstdint>

namespace spanline {

/// base^exponent = 2^(exponent·log2(base)) for highlights, by interpolation in a table of logarithms and a table of
/// powers of 2. base is Q30 in (0, 1], exponent an integer in [1, 128]. The result is Q16 in [0, 1], within 1/2048 of
/// the exact power (tested).
[[nodiscard]] std::uint32_t power(std::uint32_t base, std::uint32_t exponent);

}  // namespace spanline
