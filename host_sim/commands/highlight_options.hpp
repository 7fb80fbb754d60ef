#pragma once
#include <optional>
#include <string>

#include "scene/scene.hpp"

namespace CLI {
class App;
}

namespace spanline::sim {

/// The options of highlights as text; commands that take models share them.
struct HighlightTexts {
  std::optional<std::string> specular, shininess;
};

void add_highlight_options(CLI::App& command, HighlightTexts& texts, const std::string& group);

/// Reads the texts: highlights in the place of the model's own, or nothing where nobody asks. Throws UsageError.
[[nodiscard]] std::optional<Highlights> parse_highlights(const HighlightTexts& texts);

}  // namespace spanline::sim
