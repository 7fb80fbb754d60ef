#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "spanline/model/volume.hpp"

namespace spanline::sim {

/// A solid of the core that owns its table.
struct SolidImage {
  int log2_size = 0;
  std::vector<std::uint8_t> cells;
  std::vector<std::uint16_t> palette;

  /// Good for as long as this lives.
  [[nodiscard]] VolumeTexture view() const;
};

/// A solid that is worked out: "wood" (rings about the y axis), "marble" (bent layers) or "checks" (cubes of an
/// eighth). Throws UsageError for other names.
[[nodiscard]] SolidImage make_solid(const std::string& name);

}  // namespace spanline::sim
