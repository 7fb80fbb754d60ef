#include "commands/highlight_options.hpp"

#include <CLI/CLI.hpp>
#include <cmath>

#include "base/failure.hpp"
#include "base/parse.hpp"

namespace spanline::sim {

void add_highlight_options(CLI::App& command, HighlightTexts& texts, const std::string& group) {
  command.add_option("--specular", texts.specular, "white highlights, 0 for none (the model's own)")
      ->type_name("0..1")
      ->group(group);
  command.add_option("--shininess", texts.shininess, "how small they are (32)")->type_name("1..128")->group(group);
}

std::optional<Highlights> parse_highlights(const HighlightTexts& texts) {
  if (!texts.specular) {
    if (texts.shininess) throw UsageError("--shininess wants highlights (--specular 0..1)");
    return std::nullopt;
  }
  const double specular = parse_number("--specular", *texts.specular);
  if (specular < 0 || specular > 1) throw UsageError("--specular: must lie between 0 and 1");
  const auto white = static_cast<std::uint8_t>(std::lround(specular * 255));
  Highlights highlights{{white, white, white}};
  if (texts.shininess)
    highlights.shininess = static_cast<std::uint8_t>(parse_integer("--shininess", *texts.shininess, 1, 128));
  return highlights;
}

}  // namespace spanline::sim
