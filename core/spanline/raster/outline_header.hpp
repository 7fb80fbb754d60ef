#pragma once
#include <cstdint>

#include "spanline/raster/half_plane.hpp"
#include "spanline/raster/link.hpp"
#include "spanline/raster/outline.hpp"

namespace spanline {

/// The part of an outline's layout that the polygon table keeps in one number of 16 bits, with the count of corners.
class OutlineHeader {
 public:
  OutlineHeader(unsigned corners, const OutlineLayout& layout)
      : bits_((corners - 1) | layout.top << 3 | (layout.reference - 1) << 6 | static_cast<unsigned>(layout.size) << 9 |
              (layout.clockwise ? clockwise_bit : 0u) | ((layout.slack + 1) / 2) << 12) {}
  explicit OutlineHeader(Link bits) : bits_(bits) {}

  [[nodiscard]] Link bits() const { return static_cast<Link>(bits_); }
  [[nodiscard]] unsigned corners() const { return (bits_ & 7u) + 1; }
  [[nodiscard]] unsigned top() const { return bits_ >> 3 & 7u; }
  [[nodiscard]] unsigned reference() const { return (bits_ >> 6 & 7u) + 1; }
  [[nodiscard]] ActiveTriangle::Size size() const { return static_cast<ActiveTriangle::Size>(bits_ >> 9 & 3u); }
  [[nodiscard]] bool clockwise() const { return (bits_ & clockwise_bit) != 0; }
  /// How far the plane word may lie from the corners' own depths, in units of the depth word: a power of 4.
  [[nodiscard]] std::uint32_t depth_slack() const { return std::uint32_t{1} << 2 * (bits_ >> 12 & 15u); }

 private:
  static constexpr unsigned clockwise_bit = 1u << 11;
  std::uint32_t bits_;
};

/// An outline as it stands in the polygon table.
struct PlacedOutline {
  Outline corners;
  OutlineHeader header;
  std::int32_t origin, end_row;  ///< as in OutlineLayout
  unsigned lines = 0;            ///< lines that divide it after its numbers (FanRecords); 0: its diagonals do

  /// One of these lines.
  [[nodiscard]] HalfPlane line(unsigned i) const {
    const Link* from = corners.numbers() + corners.count();
    const auto value = [&](unsigned k) {
      if constexpr (sizeof(Link) == 2)
        return signed_word(std::uint32_t{from[6 * i + 2 * k]} | std::uint32_t{from[6 * i + 2 * k + 1]} << 16);
      else
        return signed_word(static_cast<std::uint32_t>(from[3 * i + k]));
    };
    return {value(0), value(1), value(2)};
  }

  /// Whether a corner lies outside the viewport.
  [[nodiscard]] bool leaves_viewport() const {
    std::uint32_t codes = 0;
    for (unsigned i = 0; i < corners.count(); ++i) codes |= corners[i].depth_word;
    return (codes & (outcode_left | outcode_right | outcode_top | outcode_bottom)) != 0;
  }
};

}  // namespace spanline
