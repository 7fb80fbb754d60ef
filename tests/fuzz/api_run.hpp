#pragma once
#include <string>
#include <vector>

#include "api_frame.hpp"
#include "spanline/frame/status.hpp"

namespace spanline::fuzz {

/// How the calls of one frame went, in order.
using Statuses = std::vector<Status>;

/// Draws the frame by renderers of several kinds and both band heights, twice each and once by steps, in memory that
/// held anything. What is wrong, or nothing: pictures that differ although nothing was left out, another picture or
/// other statuses the second time, writing outside the memory. `told` gets the statuses of all calls.
[[nodiscard]] std::string fault_in(const ApiFrame& frame, Statuses& told);

}  // namespace spanline::fuzz
