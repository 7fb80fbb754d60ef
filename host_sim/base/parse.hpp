#pragma once
#include <string>

#include "base/vector.hpp"
#include "spanline/model/colour.hpp"

namespace spanline::sim {

/// Readers of option values. Each throws UsageError that names the option and what is wrong with its value.

struct Size {
  int width = 320, height = 240;
  friend bool operator==(const Size&, const Size&) = default;
};

/// The greatest width, height and band height, the renderer's guard band.
inline constexpr int greatest_size = 2047;

/// A finite decimal number.
[[nodiscard]] double parse_number(const std::string& option, const std::string& text);
/// A whole number in [lowest, highest].
[[nodiscard]] int parse_integer(const std::string& option, const std::string& text, int lowest, int highest);
/// "WIDTHxHEIGHT", each 1 … greatest_size.
[[nodiscard]] Size parse_size(const std::string& option, const std::string& text);
/// "X,Y,Z".
[[nodiscard]] Vector3 parse_vector(const std::string& option, const std::string& text);
/// "RRGGBB" in hexadecimal, with or without a leading '#'.
[[nodiscard]] Rgb888 parse_colour(const std::string& option, const std::string& text);

}  // namespace spanline::sim
