#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/parse.hpp"
#include "panels/panel_registry.hpp"
#include "registry/registry.hpp"
#include "scene/view.hpp"
#include "spanline/frame/renderer.hpp"

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
  std::vector<std::string> lights;
  Text ambient, background, panel;
  Text depth_output, ids_output, statistics_output, turntable;
  // Options of the command line that later versions fill.
  Text structure, pick, texture, filter, wrap, opacity, transparency, samples, fog;
  bool wireframe = false, mipmap = false, dither = false;
};

/// Declares the options of `render`.
void add_render_options(CLI::App& command, RenderTexts& texts);

/// The options of `render`, checked as far as that goes without the model.
struct RenderArguments {
  std::string model, output;
  Size size;
  ViewRequest view;
  const VisibilityEntry* visibility = nullptr;
  const ShadingEntry* shading = nullptr;  ///< nullptr: by what the model has
  int depth_bits = 16;
  DepthSense depth_sense = DepthSense::smaller_is_nearer;
  int band_lines = 16;
  Cull cull = Cull::back;
  std::vector<Vector3> lights;
  std::optional<double> ambient;
  Rgb888 background{0, 0, 0};
  const PanelInfo* panel = nullptr;
  std::optional<std::string> depth_output, ids_output, statistics_output;
  int turntable_frames = 0;  ///< 0: a still picture
};

/// Throws UsageError and NotAvailable.
[[nodiscard]] RenderArguments parse_render_arguments(const RenderTexts& texts);

}  // namespace spanline::sim
