#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/parse.hpp"
#include "image/solid_image.hpp"
#include "panels/panel_registry.hpp"
#include "registry/registry.hpp"
#include "render/displacement_arguments.hpp"
#include "scene/lighting.hpp"
#include "scene/scene.hpp"
#include "scene/view.hpp"
#include "scene/world.hpp"
#include "spanline/frame/renderer.hpp"
#include "spanline/model/cull.hpp"

namespace spanline::sim {

/// The options of `render`, checked as far as that goes without the model.
struct RenderArguments {
  std::string model, output;
  Size size;
  ViewRequest view;
  const AlgorithmEntry* visibility = nullptr;
  const ShadingEntry* shading = nullptr;  ///< nullptr: by what the model has
  std::optional<std::string> texture;     ///< a file, for what has no texture of its own
  TextureFilter filter = TextureFilter::nearest;
  bool for_textures = false;  ///< any of the options that go with textures is given
  bool mip_map = false, resize = false, dither = false;
  std::optional<Wrap> wrap;                ///< by what the model says where it is not given
  std::optional<std::string> environment;  ///< a file, in the place of all textures
  std::optional<std::string> heights;      ///< a file of relief
  ReliefKind relief_kind = ReliefKind::bump;
  double relief_depth = 4;  ///< texels
  std::optional<SolidImage> solid;
  std::optional<DisplacementArguments> displacement;
  std::optional<FogRequest> fog;
  std::optional<int> depth_bits;  ///< by the algorithm where it is not given
  DepthSense depth_sense = DepthSense::smaller_is_nearer;
  int band_lines = 16;
  Cull cull = Cull::back;
  bool cull_stated = false;  ///< by the user
  std::vector<Vector3> lights;
  std::vector<ScenePointLight> point_lights;
  std::optional<double> ambient;
  std::optional<Highlights> highlights;  ///< by what the model says where they are not given
  Rgb888 background{0, 0, 0};
  double opacity = 1;  ///< multiplies the model's own
  Transparency transparency = Transparency::blend;
  int samples = 1;
  const PanelInfo* panel = nullptr;
  std::optional<std::string> depth_output, ids_output, statistics_output;
  struct Pixel {
    int x, y;
  };
  std::optional<Pixel> pick;
  int turntable_frames = 0;  ///< 0: a still picture
};

}  // namespace spanline::sim
