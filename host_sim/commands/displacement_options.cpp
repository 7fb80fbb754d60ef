#include "commands/displacement_options.hpp"

#include <CLI/CLI.hpp>

#include "base/failure.hpp"
#include "base/parse.hpp"

namespace spanline::sim {

void add_displacement_options(CLI::App& command, DisplacementTexts& texts, const std::string& group) {
  command.add_option("--displace", texts.heights, "PNG or JPEG of heights that move the model's points along normals")
      ->type_name("FILE")
      ->group(group);
  command.add_option("--amount", texts.amount, "how far white moves a point, in units of the model")
      ->type_name("A")
      ->group(group);
  command.add_option("--subdivide", texts.subdivide, "times that each triangle becomes four before (3)")
      ->type_name("0..8")
      ->group(group);
}

std::optional<DisplacementArguments> parse_displacement(const DisplacementTexts& texts) {
  if (!texts.heights) {
    if (texts.amount || texts.subdivide) throw UsageError("--amount and --subdivide want heights (--displace FILE)");
    return std::nullopt;
  }
  if (!texts.amount) throw UsageError("--displace wants to know how far (--amount A)");
  constexpr int usual_levels = 3;
  DisplacementArguments arguments{*texts.heights, {parse_number("--amount", *texts.amount), usual_levels}};
  if (texts.subdivide)
    arguments.request.levels = parse_integer("--subdivide", *texts.subdivide, 0, DisplacementRequest::max_levels);
  return arguments;
}

}  // namespace spanline::sim
