#include "render/setup.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/failure.hpp"

namespace spanline::sim {

const ShadingEntry& default_shading(const Scene& scene) {
  if (is_textured(scene)) return find_shading("texture");
  return find_shading(scene.normals_from_file ? "gouraud" : "flat");
}

bool shows_textures(const ShadingEntry& shading, const Scene& scene) {
  return shading.textured || (!shading.lit && is_textured(scene));
}

Scene prepared_for(Scene scene, const ShadingEntry& shading, bool pixel_by_pixel) {
  if (shows_textures(shading, scene)) {
    // Colours of materials are those of the parts, which textures are multiplied with.
    scene.polygon_colours.clear();
  } else if (pixel_by_pixel) {
    simplify_colours(scene);
    if (!scene.polygon_colours.empty()) scene.colour = {255, 255, 255};
    scene.vertex_colours.clear();
    scene.polygon_colours.clear();
  } else {
    scene.texture_points.clear();
  }
  if (!shading.lit)
    for (Scene::Part& part : scene.parts) part.highlights = {};
  if (shading.lit && shading.smooth)
    complete_vertex_normals(scene);
  else
    scene.vertex_normals.clear();
  if (shading.smooth) {
    if (scene.vertex_colours.empty()) simplify_colours(scene);
    polygon_colours_to_vertices(scene);
    scene.polygon_colours.clear();
  } else {
    complete_polygon_colours(scene);
    simplify_colours(scene);
    scene.vertex_colours.clear();
  }
  return welded(scene);
}

namespace {

/// Point lights where the core's world has them.
SceneLight in_world(SceneLight light, const World& world) {
  constexpr double greatest = 32000;  // of Q16.16, with room for differences
  for (ScenePointLight& point : light.points) {
    point.position = world.to_world(point.position);
    for (const double c : {point.position.x, point.position.y, point.position.z})
      if (std::abs(c) > greatest)
        throw UsageError("--point-light: too far away from the model for fixed-point numbers");
    if (point.range > 0) point.range = std::clamp(std::ldexp(point.range, world.exponent), 1.0 / 65536, greatest);
  }
  return light;
}

}  // namespace

FrameRequest make_request(const RenderArguments& arguments, const ShadingEntry& shading, const View& view,
                          const World& world, const SceneLight& light) {
  FrameRequest request;
  request.size = arguments.size;
  request.visibility = arguments.visibility;
  request.band_lines = arguments.visibility->full_frame() ? arguments.size.height
                                                          : std::min(arguments.band_lines, arguments.size.height);
  request.depth_bits = arguments.depth_bits.value_or(arguments.visibility->depth_bits);
  request.depth_sense = arguments.depth_sense;
  request.cull = arguments.cull;
  request.smooth = shading.smooth;
  request.lit = shading.lit;
  request.filter = arguments.filter;
  request.mip_map = arguments.mip_map;
  request.dither = arguments.dither;
  if (arguments.fog) request.fog = to_fog(*arguments.fog, view, world);
  request.camera = to_camera(view, world, arguments.size);
  request.light = shading.lit ? in_world(light, world) : SceneLight{};
  request.background = arguments.background;
  request.transparency = arguments.transparency;
  request.samples = arguments.samples;
  request.want_depth = arguments.depth_output.has_value();
  request.want_ids = arguments.ids_output.has_value();
  request.want_statistics = arguments.statistics_output.has_value();
  return request;
}

}  // namespace spanline::sim
