#pragma once
/// @file
/// How much memory a frame used.
#include <cstddef>

namespace spanline {

/// The most bytes in use at any time, for each pool.
struct PoolPeaks {
  std::size_t instances = 0;     ///< bytes of `Capacity::instances`
  std::size_t vertices = 0;      ///< bytes of `Capacity::vertices`
  std::size_t shades = 0;        ///< bytes of `Capacity::shades`
  std::size_t textures = 0;      ///< bytes of `Capacity::textures`
  std::size_t polygons = 0;      ///< bytes of `Capacity::polygons`
  std::size_t fans = 0;          ///< bytes of `Capacity::fans`
  std::size_t active = 0;        ///< bytes of `Capacity::active`
  std::size_t awake = 0;         ///< bytes of `Capacity::awake`
  std::size_t fragments = 0;     ///< bytes of `Capacity::fragments`
  std::size_t layers = 0;        ///< bytes of `Capacity::layers`
  std::size_t members = 0;       ///< bytes of `Capacity::members`, and of what sorting algorithms keep besides
  std::size_t buckets = 0;       ///< bytes of the table in which polygons are sorted by their first row
  std::size_t colour_bands = 0;  ///< bytes of all bands of pixels
  std::size_t depth_band = 0;    ///< bytes of all bands of depths, and of other data that an algorithm keeps for a band
  /// The sum over all pools, in bytes.
  [[nodiscard]] constexpr std::size_t total() const {
    return instances + vertices + shades + textures + polygons + fans + active + awake + fragments + layers + members +
           buckets + colour_bands + depth_band;
  }
};

}  // namespace spanline
