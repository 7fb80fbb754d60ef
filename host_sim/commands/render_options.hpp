#pragma once
#include <optional>
#include <string>
#include <vector>

#include "commands/displacement_options.hpp"
#include "commands/highlight_options.hpp"
#include "render/render_arguments.hpp"

namespace CLI {
class App;
}

namespace spanline::sim {

/// The options of `render` as text, before anything is known to be right. Absent ones are empty.
struct RenderTexts {
  using Text = std::optional<std::string>;
  std::string model, output;
  Text size, eye, target, up, field_of_view, near_plane, far_plane, ortho;
  Text visibility, depth, depth_sense, band, cull, shade;
  std::vector<std::string> lights, point_lights;
  HighlightTexts highlights;
  Text ambient, background, panel;
  Text depth_output, ids_output, statistics_output, turntable;
  // Options of the command line that later versions fill.
  Text structure, pick, texture, environment, bump, emboss, relief_depth, solid, filter, wrap, opacity, transparency,
      samples, fog;
  DisplacementTexts displacement;
  bool wireframe = false, mipmap = false, resize = false, dither = false;
};

/// Declares the options of `render`.
void add_render_options(CLI::App& command, RenderTexts& texts);

/// Reads the texts. Throws UsageError and NotAvailable.
[[nodiscard]] RenderArguments parse_render_arguments(const RenderTexts& texts);

}  // namespace spanline::sim
