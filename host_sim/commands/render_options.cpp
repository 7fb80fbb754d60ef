#include "commands/render_options.hpp"

#include <CLI/CLI.hpp>
#include <string>

#include "registry/registry.hpp"

namespace spanline::sim {
namespace {

void add_camera_options(CLI::App& command, RenderTexts& texts) {
  const std::string group = "Camera (none given: the whole model is framed)";
  command.add_option("--eye", texts.eye, "where the camera stands")->type_name("X,Y,Z")->group(group);
  command.add_option("--target", texts.target, "what it looks at")->type_name("X,Y,Z")->group(group);
  command.add_option("--up", texts.up, "upwards direction (0,1,0)")->type_name("X,Y,Z")->group(group);
  command.add_option("--fov", texts.field_of_view, "vertical field of view (45)")->type_name("DEGREES")->group(group);
  command.add_option("--near", texts.near_plane, "near plane")->type_name("N")->group(group);
  command.add_option("--far", texts.far_plane, "far plane")->type_name("F")->group(group);
  command.add_option("--ortho", texts.ortho, "orthographic, height of the view in world units")
      ->type_name("HEIGHT")
      ->group(group);
}

void add_output_options(CLI::App& command, RenderTexts& texts) {
  const std::string group = "Output";
  command.add_option("-o,--output", texts.output, "the picture")->type_name("OUT.png")->required()->group(group);
  command.add_option("--depth-out", texts.depth_output, "depths as 8-bit RGB, R<<16|G<<8|B")
      ->type_name("F.png")
      ->group(group);
  command.add_option("--ids-out", texts.ids_output, "1 + index of the triangle, as 8-bit RGB")
      ->type_name("F.png")
      ->group(group);
  command.add_option("--stats", texts.statistics_output, "statistics")->type_name("F.json")->group(group);
  command.add_option("--turntable", texts.turntable, "N frames to an animation, GIF or APNG by the ending of -o")
      ->type_name("N")
      ->group(group);
}

/// 16, and the algorithms that take another depth by default.
std::string default_depths() {
  constexpr int usual = 16;
  std::string text = std::to_string(usual);
  for (const AlgorithmEntry& entry : visibility_algorithms())
    if (entry.depth_bits != usual) text += "; " + std::string(entry.name) + " " + std::to_string(entry.depth_bits);
  return text;
}

void add_drawing_options(CLI::App& command, RenderTexts& texts) {
  const std::string group = "Drawing";
  command.add_option("--size", texts.size, "picture size (320x240)")->type_name("WxH")->group(group);
  command.add_option("--visibility", texts.visibility, "algorithm (scanline-z)")->type_name("NAME")->group(group);
  command.add_option("--depth", texts.depth, "bits of depth (" + default_depths() + ")")
      ->type_name("16|24")
      ->group(group);
  command.add_option("--depth-sense", texts.depth_sense, "nearer depths are (smaller)")
      ->type_name("smaller|larger")
      ->group(group);
  command.add_option("--band", texts.band, "lines a band (16)")->type_name("LINES")->group(group);
  command.add_option("--cull", texts.cull, "faces that are not drawn (back)")
      ->type_name("back|front|none")
      ->group(group);
  command.add_option("--shade", texts.shade, "shading (by what the model has)")
      ->type_name("flat|gouraud|texture|unlit")
      ->group(group);
  command.add_option("--light", texts.lights, "direction towards the light; up to 4 of them")
      ->type_name("X,Y,Z")
      ->expected(1)
      ->take_all()
      ->group(group);
  command
      .add_option("--point-light", texts.point_lights,
                  "a light at a point, faded to nothing at RANGE where that is given; up to 4 of them")
      ->type_name("X,Y,Z[,RANGE]")
      ->expected(1)
      ->take_all()
      ->group(group);
  add_highlight_options(command, texts.highlights, group);
  command.add_option("--ambient", texts.ambient, "ambient light")->type_name("0..1")->group(group);
  command.add_option("--background", texts.background, "colour (000000)")->type_name("RRGGBB")->group(group);
  command.add_option("--pick", texts.pick, "prints the triangle at a pixel, numbered from 1, and its depth")
      ->type_name("X,Y")
      ->group(group);
  command.add_option("--texture", texts.texture, "PNG or JPEG for what has no texture of its own")
      ->type_name("FILE")
      ->group(group);
  command
      .add_option("--environment", texts.environment, "PNG or JPEG of the surroundings as a mirror sphere shows them")
      ->type_name("FILE")
      ->group(group);
  command.add_option("--bump", texts.bump, "PNG or JPEG of heights that the light sees")
      ->type_name("FILE")
      ->group(group);
  command.add_option("--bump-depth", texts.relief_depth, "what white stands for, in texels (4)")
      ->type_name("0..64")
      ->group(group);
  command.add_option("--emboss", texts.emboss, "PNG or JPEG whose edges catch the light")
      ->type_name("FILE")
      ->group(group);
  command.add_option("--solid", texts.solid, "the model is cut from this")
      ->type_name("wood|marble|checks")
      ->group(group);
  command.add_option("--filter", texts.filter, "of the texture (nearest)")->type_name("nearest|bilinear")->group(group);
  command.add_flag("--mipmap", texts.mipmap, "textures have smaller levels for what is far")->group(group);
  command.add_flag("--resize", texts.resize, "makes sides of textures powers of two that they may have")->group(group);
  command.add_option("--wrap", texts.wrap, "beyond the texture's edge (by the model, or repeat)")
      ->type_name("repeat|clamp")
      ->group(group);
  command.add_option("--fog", texts.fog, "from clear at NEAR to the colour alone at FAR, in world units")
      ->type_name("NEAR,FAR,RRGGBB")
      ->group(group);
  command.add_flag("--dither", texts.dither, "ordered dither to RGB565")->group(group);
  command.add_option("--panel", texts.panel, "through that panel's driver and model, at its size")
      ->type_name("NAME")
      ->group(group);
}

void add_transparency_options(CLI::App& command, RenderTexts& texts) {
  const std::string group = "Transparency";
  command.add_option("--opacity", texts.opacity, "of the model, times what its materials say (1)")
      ->type_name("0..1")
      ->group(group);
  command.add_option("--transparency", texts.transparency, "how what lies behind shows (blend)")
      ->type_name("blend|screen-door|stochastic")
      ->group(group);
  command.add_option("--samples", texts.samples, "a pixel, for stochastic (4)")->type_name("4|8|16")->group(group);
}

void add_later_options(CLI::App& command, RenderTexts& texts) {
  const std::string group = "Not available yet";
  command.add_option("--structure", texts.structure, "for ray")->type_name("grid|octree|kd|bsp")->group(group);
  command.add_flag("--wireframe", texts.wireframe)->group(group);
}

}  // namespace

void add_render_options(CLI::App& command, RenderTexts& texts) {
  command.add_option("MODEL", texts.model, "OBJ, glTF/GLB, PLY or STL")->required();
  add_output_options(command, texts);
  add_camera_options(command, texts);
  add_drawing_options(command, texts);
  add_displacement_options(command, texts.displacement, "Displacement");
  add_transparency_options(command, texts);
  add_later_options(command, texts);
}

}  // namespace spanline::sim
