#pragma once
#include <optional>
#include <string>

#include "render/displacement_arguments.hpp"

namespace CLI {
class App;
}

namespace spanline::sim {

/// The options of displacement as text; commands that take models share them.
struct DisplacementTexts {
  std::optional<std::string> heights, amount, subdivide;
};

void add_displacement_options(CLI::App& command, DisplacementTexts& texts, const std::string& group);

/// Reads the texts; nothing where no heights are named. Throws UsageError.
[[nodiscard]] std::optional<DisplacementArguments> parse_displacement(const DisplacementTexts& texts);

}  // namespace spanline::sim
