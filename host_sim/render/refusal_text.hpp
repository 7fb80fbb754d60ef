#pragma once
#include <string>

#include "spanline/frame/status.hpp"

namespace spanline::sim {

/// What a renderer refused, in words for one line of stderr: what is wrong, and with how many of what.
[[nodiscard]] std::string refusal_text(const Status& status);

}  // namespace spanline::sim
