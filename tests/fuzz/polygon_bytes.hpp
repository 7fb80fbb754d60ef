#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "drawing.hpp"

namespace spanline::fuzz {

/// A polygon table and how to draw it, as a fuzzer's bytes say. Any bytes mean something.
///
///     width − 1, height − 1, band lines − 1, active polygons (0: room for all), flags (bit 0: larger is
///     nearer; bit 1: layers, contract/layers.hpp)
///     then triangle after triangle, an opcode and what it takes (16-bit numbers: low byte first):
///     0  three corners: x, y (16 bits, sixteenths, signed), z (24 bits)
///     1  three corners: x, y (whole pixels from −64 on), z (the top byte); bits 2 and 3 of the opcode put x and y on
///        pixel centres
///     2  an earlier triangle again: its number, then for one corner its number and what to add to x, y (8 bits) and z
///        (16 bits), signed
///     3  an edge of an earlier triangle: its number and that of the corner to replace, then a corner as in 0
///
/// Numbers wrap to their ranges, and missing bytes are 0.
struct Case {
  contract::Scene scene;
  contract::Manner manner;
  std::uint8_t active = 0;
};

inline constexpr int most_columns = 96, most_rows = 64;
inline constexpr std::size_t most_triangles = 300;

[[nodiscard]] Case decode(std::span<const std::uint8_t> bytes);

/// Bytes that decode to the scene's triangles, on a picture as large as it can be.
[[nodiscard]] std::vector<std::uint8_t> encode(const contract::Scene& scene, int band_lines, std::uint8_t active,
                                               bool layers = false);

/// Draws the case by all exact algorithms at once. What is wrong, or nothing.
[[nodiscard]] std::string fault_in(const Case& drawn);

}  // namespace spanline::fuzz
