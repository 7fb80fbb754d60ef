#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "spanline/model/relief.hpp"

namespace spanline::sim {

/// A height map of the core that owns its table.
struct HeightImage {
  int log2_width = 0, log2_height = 0;
  std::vector<std::uint8_t> heights;

  /// Good for as long as this lives.
  [[nodiscard]] HeightMap view() const;
  /// The height at a point of the map, 1 × 1 in size and repeated, between the nearest four texels; in [0, 1].
  [[nodiscard]] double at(double s, double t) const;
};

/// Reads a PNG or JPEG file: the brighter, the higher (ITU-R BT.601). Throws Failure that names the file, also for
/// sides that are no powers of two or too large.
[[nodiscard]] HeightImage read_heights(const std::string& path);

}  // namespace spanline::sim
