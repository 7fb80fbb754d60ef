#pragma once
#include <string>

#include "render/frame.hpp"

namespace spanline::sim {

/// The statistics as the command line gives them (--stats); null for what is not known.
[[nodiscard]] std::string to_json(const FrameStatistics& statistics);

}  // namespace spanline::sim
