#pragma once
#include <cstdint>

#include "spanline/frame/status.hpp"

namespace spanline::scenes {

/// What became of a run.
struct SelftestResult {
  Status status;            ///< of the first call that failed
  std::uint32_t crc = 0;    ///< of the picture, line by line
  std::uint32_t depth = 0;  ///< the CRC of its depths
  std::uint32_t drawn = 0;  ///< triangles that were neither outside nor culled
};

}  // namespace spanline::scenes
