#include "commands/render_options.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "base/failure.hpp"
#include "base/output_file.hpp"
#include "spanline/model/cull.hpp"
#include "spanline/model/light.hpp"

namespace spanline::sim {
namespace {

constexpr int greatest_turntable = 3600;

void refuse_later_options(const RenderTexts& texts) {
  const std::array<std::pair<const char*, bool>, 2> later{
      {{"--structure", texts.structure.has_value()}, {"--wireframe", texts.wireframe}}};
  for (const auto& [name, given] : later)
    if (given) throw NotAvailable(name);
}

/// One of a few words, each with its value.
template <class Value, std::size_t Count>
Value parse_choice(const std::string& option, const std::string& text,
                   const std::array<std::pair<const char*, Value>, Count>& choices) {
  std::string names;
  for (const auto& [name, value] : choices) {
    if (text == name) return value;
    names += (names.empty() ? "" : ", ") + std::string(name);
  }
  throw UsageError(option + ": '" + text + "' is none of " + names);
}

std::optional<double> optional_number(const std::string& option, const RenderTexts::Text& text) {
  return text ? std::optional(parse_number(option, *text)) : std::nullopt;
}

std::optional<Vector3> optional_vector(const std::string& option, const RenderTexts::Text& text) {
  return text ? std::optional(parse_vector(option, *text)) : std::nullopt;
}

FogRequest parse_fog(const std::string& text) {
  const std::size_t first = text.find(','), second = first == std::string::npos ? first : text.find(',', first + 1);
  if (second == std::string::npos) throw UsageError("--fog: '" + text + "' is not NEAR,FAR,RRGGBB");
  const FogRequest fog{parse_number("--fog", text.substr(0, first)),
                       parse_number("--fog", text.substr(first + 1, second - first - 1)),
                       parse_colour("--fog", text.substr(second + 1))};
  if (fog.start < 0 || fog.end <= fog.start) throw UsageError("--fog: NEAR must not be below 0, and FAR beyond it");
  return fog;
}

ViewRequest parse_view(const RenderTexts& texts) {
  ViewRequest request;
  request.eye = optional_vector("--eye", texts.eye);
  request.target = optional_vector("--target", texts.target);
  request.up = optional_vector("--up", texts.up);
  request.field_of_view = optional_number("--fov", texts.field_of_view);
  request.ortho_height = optional_number("--ortho", texts.ortho);
  request.near_plane = optional_number("--near", texts.near_plane);
  request.far_plane = optional_number("--far", texts.far_plane);
  check_request(request);
  return request;
}

void parse_texturing(const RenderTexts& texts, RenderArguments& arguments) {
  if (texts.filter)
    arguments.filter = parse_choice(
        "--filter", *texts.filter,
        std::array{std::pair{"nearest", TextureFilter::nearest}, std::pair{"bilinear", TextureFilter::bilinear}});
  arguments.for_textures = texts.filter || texts.mipmap || texts.resize || texts.wrap;
  arguments.mip_map = texts.mipmap;
  arguments.resize = texts.resize;
  if (texts.wrap)
    arguments.wrap = parse_choice("--wrap", *texts.wrap,
                                  std::array{std::pair{"repeat", Wrap::repeat}, std::pair{"clamp", Wrap::clamp}});
  arguments.dither = texts.dither;
  if (texts.fog) arguments.fog = parse_fog(*texts.fog);
}

/// What surfaces that are worked out pixel by pixel do not go with.
void refuse_texturing(const RenderTexts& texts, const std::string& options) {
  if (texts.environment || texts.filter || texts.mipmap || texts.resize || texts.wrap)
    throw NotAvailable("--environment, --filter, --mipmap, --resize and --wrap with " + options);
}

void parse_solid(const RenderTexts& texts, RenderArguments& arguments) {
  if (!texts.solid) return;
  arguments.solid = make_solid(*texts.solid);
  if (texts.texture || texts.bump || texts.emboss)
    throw UsageError("--solid: goes without --texture, --bump and --emboss");
  refuse_texturing(texts, "--solid");
}

void parse_relief(const RenderTexts& texts, RenderArguments& arguments) {
  if (texts.bump && texts.emboss) throw UsageError("--bump and --emboss: one at a time");
  if (texts.relief_depth && !texts.bump) throw UsageError("--bump-depth wants heights (--bump FILE)");
  arguments.heights = texts.bump ? texts.bump : texts.emboss;
  if (texts.emboss) arguments.relief_kind = ReliefKind::emboss;
  arguments.relief_depth = optional_number("--bump-depth", texts.relief_depth).value_or(4);
  if (arguments.relief_depth <= 0 || arguments.relief_depth > 64)
    throw UsageError("--bump-depth: must lie above 0 and at most at 64");
  if (!arguments.heights) return;
  refuse_texturing(texts, "--bump or --emboss");
  if (texts.highlights.specular || !texts.point_lights.empty())
    throw NotAvailable("--specular and --point-light with --bump or --emboss");
}

void parse_drawing(const RenderTexts& texts, RenderArguments& arguments) {
  using Sense = DepthSense;
  if (texts.size) arguments.size = parse_size("--size", *texts.size);
  arguments.visibility = &find_visibility(texts.visibility.value_or("scanline-z"));
  if (texts.shade) arguments.shading = &find_shading(*texts.shade);
  if (texts.texture && texts.environment) throw UsageError("--texture and --environment: one at a time");
  arguments.texture = texts.texture;
  arguments.environment = texts.environment;
  if (texts.environment && arguments.shading != nullptr && !arguments.shading->textured)
    throw UsageError("--environment goes with --shade texture");
  if (texts.texture && arguments.shading != nullptr && !arguments.shading->textured && arguments.shading->lit)
    throw UsageError("--texture goes with --shade texture or unlit");
  if (arguments.shading == nullptr && (arguments.texture || arguments.environment))
    arguments.shading = &find_shading("texture");
  parse_texturing(texts, arguments);
  parse_relief(texts, arguments);
  parse_solid(texts, arguments);
  if (texts.depth)
    arguments.depth_bits = parse_choice("--depth", *texts.depth, std::array{std::pair{"16", 16}, std::pair{"24", 24}});
  if (texts.depth_sense)
    arguments.depth_sense = parse_choice(
        "--depth-sense", *texts.depth_sense,
        std::array{std::pair{"smaller", Sense::smaller_is_nearer}, std::pair{"larger", Sense::larger_is_nearer}});
  if (texts.band) arguments.band_lines = parse_integer("--band", *texts.band, 1, greatest_size);
  arguments.cull_stated = texts.cull.has_value();
  if (texts.cull)
    arguments.cull = parse_choice(
        "--cull", *texts.cull,
        std::array{std::pair{"back", Cull::back}, std::pair{"front", Cull::front}, std::pair{"none", Cull::none}});
}

/// X,Y,Z or X,Y,Z,RANGE.
ScenePointLight parse_point_light(const std::string& text) {
  const std::string option = "--point-light";
  const bool ranged = std::count(text.begin(), text.end(), ',') == 3;
  const std::size_t last = ranged ? text.rfind(',') : text.size();
  ScenePointLight light{parse_vector(option, text.substr(0, last))};
  if (!ranged) return light;
  light.range = parse_number(option, text.substr(last + 1));
  if (light.range <= 0) throw UsageError(option + ": the range of '" + text + "' must be above 0");
  return light;
}

void parse_surface_light(const RenderTexts& texts, RenderArguments& arguments) {
  if (texts.point_lights.size() > Lighting::max_lights)
    throw UsageError("--point-light: at most " + std::to_string(Lighting::max_lights) + " lights");
  for (const std::string& light : texts.point_lights) arguments.point_lights.push_back(parse_point_light(light));
  arguments.highlights = parse_highlights(texts.highlights);
}

void parse_light(const RenderTexts& texts, RenderArguments& arguments) {
  parse_surface_light(texts, arguments);
  if (texts.lights.size() > Lighting::max_lights)
    throw UsageError("--light: at most " + std::to_string(Lighting::max_lights) + " lights");
  for (const std::string& light : texts.lights) {
    arguments.lights.push_back(parse_vector("--light", light));
    if (arguments.lights.back() == Vector3{}) throw UsageError("--light: '" + light + "' has no direction");
  }
  arguments.ambient = optional_number("--ambient", texts.ambient);
  if (arguments.ambient && (*arguments.ambient < 0 || *arguments.ambient > 1))
    throw UsageError("--ambient: must lie between 0 and 1");
  if (texts.background) arguments.background = parse_colour("--background", *texts.background);
}

/// After the size is known.
void parse_transparency(const RenderTexts& texts, RenderArguments& arguments) {
  arguments.opacity = optional_number("--opacity", texts.opacity).value_or(1);
  if (arguments.opacity < 0 || arguments.opacity > 1) throw UsageError("--opacity: must lie between 0 and 1");
  if (texts.transparency)
    arguments.transparency = parse_choice(
        "--transparency", *texts.transparency,
        std::array{std::pair{"blend", Transparency::blend}, std::pair{"screen-door", Transparency::screen_door},
                   std::pair{"stochastic", Transparency::stochastic}});
  const bool stochastic = arguments.transparency == Transparency::stochastic;
  if (texts.samples && !stochastic) throw UsageError("--samples goes with --transparency stochastic");
  if (!stochastic) return;
  arguments.samples = parse_choice("--samples", texts.samples.value_or("4"),
                                   std::array{std::pair{"4", 4}, std::pair{"8", 8}, std::pair{"16", 16}});
  const int most = greatest_size / (arguments.samples == 16 ? 4 : 2);
  if (arguments.size.width > most || arguments.size.height > most)
    throw UsageError("--samples: with " + std::to_string(arguments.samples) + " a pixel a picture has at most " +
                     std::to_string(most) + "x" + std::to_string(most) + " pixels");
}

void parse_panel(const RenderTexts& texts, RenderArguments& arguments) {
  if (!texts.panel) return;
  arguments.panel = find_panel(*texts.panel);
  if (arguments.panel == nullptr) {
    std::string names;
    for (const PanelInfo& info : panels()) names += (names.empty() ? "" : ", ") + std::string(info.name);
    throw UsageError("--panel: '" + *texts.panel + "' is unknown; there is " + names);
  }
  const Size size{arguments.panel->width, arguments.panel->height};
  if (texts.size && arguments.size != size)
    throw UsageError("--size: the panel has " + std::to_string(size.width) + "x" + std::to_string(size.height));
  arguments.size = size;
}

void parse_pick(const RenderTexts& texts, RenderArguments& arguments) {
  if (!texts.pick) return;
  const std::size_t comma = texts.pick->find(',');
  if (comma == std::string::npos) throw UsageError("--pick: '" + *texts.pick + "' is not X,Y");
  arguments.pick = {parse_integer("--pick", texts.pick->substr(0, comma), 0, arguments.size.width - 1),
                    parse_integer("--pick", texts.pick->substr(comma + 1), 0, arguments.size.height - 1)};
  if (texts.turntable) throw UsageError("--pick goes with a still picture, not with --turntable");
}

void check_ending(const RenderArguments& arguments) {
  const std::string& name = arguments.output;
  const bool png = name.ends_with(".png") || name.ends_with(".apng");
  if (arguments.turntable_frames > 0) {
    if (!png && !name.ends_with(".gif")) throw UsageError("-o: a turntable goes to a .gif, .png or .apng file");
    return;
  }
  for (const char* other : {".gif", ".jpg", ".jpeg", ".bmp", ".ppm", ".webp"})
    if (name.ends_with(other)) throw UsageError("-o: pictures are PNG, and '" + name + "' ends in " + other);
}

void parse_outputs(const RenderTexts& texts, RenderArguments& arguments) {
  arguments.output = texts.output;
  arguments.depth_output = texts.depth_output;
  arguments.ids_output = texts.ids_output;
  arguments.statistics_output = texts.statistics_output;
  if (texts.turntable)
    arguments.turntable_frames = parse_integer("--turntable", *texts.turntable, 1, greatest_turntable);
  check_ending(arguments);
  std::vector<std::pair<const char*, std::string>> outputs{{"-o", texts.output}};
  if (texts.depth_output) outputs.emplace_back("--depth-out", *texts.depth_output);
  if (texts.ids_output) outputs.emplace_back("--ids-out", *texts.ids_output);
  if (texts.statistics_output) outputs.emplace_back("--stats", *texts.statistics_output);
  if (arguments.turntable_frames > 0 && outputs.size() > 1)
    throw UsageError(std::string(outputs[1].first) + " goes with a still picture, not with --turntable");
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (outputs[i].second.empty()) throw UsageError(std::string(outputs[i].first) + ": the name is empty");
    if (same_file(outputs[i].second, texts.model))
      throw UsageError(std::string(outputs[i].first) + " names the model itself");
    for (std::size_t k = 0; k < i; ++k)
      if (same_file(outputs[i].second, outputs[k].second) && !outputs[i].second.starts_with("/dev/"))
        throw UsageError(std::string(outputs[k].first) + " and " + outputs[i].first + " name the same file");
  }
}

}  // namespace

RenderArguments parse_render_arguments(const RenderTexts& texts) {
  refuse_later_options(texts);
  RenderArguments arguments;
  arguments.model = texts.model;
  parse_drawing(texts, arguments);
  arguments.view = parse_view(texts);
  parse_light(texts, arguments);
  arguments.displacement = parse_displacement(texts.displacement);
  parse_panel(texts, arguments);
  parse_transparency(texts, arguments);
  parse_pick(texts, arguments);
  parse_outputs(texts, arguments);
  return arguments;
}

}  // namespace spanline::sim
