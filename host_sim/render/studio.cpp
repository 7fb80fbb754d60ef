#include "render/studio.hpp"

#include <utility>

#include "base/failure.hpp"
#include "import/model_file.hpp"
#include "render/setup.hpp"
#include "scene/core_values.hpp"
#include "scene/planes.hpp"

namespace spanline::sim {

Studio::Studio(const RenderArguments& arguments) : arguments_(arguments), scene_(import_model(arguments.model)) {
  if (arguments.solid)
    for (Scene::Part& part : scene_.parts) part.image = Scene::Part::no_image;
  if (arguments.displacement) scene_ = displaced(scene_, arguments.model, *arguments.displacement);
  shading_ = arguments.shading != nullptr ? arguments.shading : &default_shading(scene_);
  const bool has_texture = arguments.texture || is_textured(scene_);
  if (arguments.environment || shading_->textured || (!shading_->lit && has_texture))
    read_textures();
  else if (arguments.for_textures)
    throw UsageError("--filter, --mipmap, --resize and --wrap want a texture: one of the model's, or --texture FILE");
  if (arguments.heights) {
    if (scene_.texture_points.empty()) throw file_failure(arguments.model, "has no texture coordinates");
    heights_ = read_heights(*arguments.heights);
    height_map_ = heights_.view();
  }
  if (arguments.highlights) set_highlights(scene_, *arguments.highlights);
  if (arguments.heights) set_highlights(scene_, {});  // the file's own: reliefs have none
  fade(scene_, arguments.opacity);
  if (arguments.cull == Cull::back) edges_ = count_edges(scene_);
  scene_ = prepared_for(std::move(scene_), *shading_, arguments.heights || arguments.solid);
  view_ = resolve_view(arguments.view, scene_, arguments.size, arguments.turntable_frames > 0);
  light_ = resolve_light(arguments.lights, arguments.point_lights, arguments.ambient, view_);
  world_ = choose_world(view_, scene_, arguments.size, arguments.fog);
  if (arguments.solid) solid_ = arguments.solid->view();
  renderer_.emplace(to_core_meshes(scene_, world_));
  if (arguments.panel != nullptr) panel_.emplace(*arguments.panel);
}

void Studio::read_textures() {
  if (arguments_.environment)
    use_environment(scene_, *arguments_.environment);
  else
    name_textures();
  textures_ = PartTextures(scene_, {.mip_map = arguments_.mip_map, .resize = arguments_.resize});
}

void Studio::name_textures() {
  if (scene_.texture_points.empty()) throw file_failure(arguments_.model, "has no texture coordinates");
  if (arguments_.texture) use_texture(scene_, *arguments_.texture);
  if (!is_textured(scene_)) throw UsageError("--shade texture: the model has no texture of its own (--texture FILE)");
  if (arguments_.wrap) set_wrap(scene_, *arguments_.wrap);
  if (arguments_.heights && has_mirrored_textures(scene_))
    throw NotAvailable("--bump and --emboss on textures that repeat mirrored");  // whose coordinates they share
  halve_mirrored_coordinates(scene_);
}

Frame Studio::draw(double turns) {
  SceneLight light = light_;
  if (turns != 0) {
    for (Vector3& towards : light.towards) towards = turned(view_, towards, turns);
    for (ScenePointLight& point : light.points)
      point.position = view_.target + turned(view_, point.position - view_.target, turns);
  }
  const View view = turns == 0 ? view_ : turned(view_, turns);
  const FrameRequest wanted = request(view, light);
  Frame frame = renderer_->draw(wanted);
  for (std::uint32_t& depth : frame.depths)
    if (depth != background_depth(wanted.depth_bits)) depth = stated_depth(depth, wanted);
  return frame;
}

PickedPixel Studio::pick(int x, int y) {
  const FrameRequest wanted = request(view_, light_);
  PickedPixel picked = renderer_->pick(wanted, x, y);
  if (picked.id != 0) picked.depth = stated_depth(picked.depth, wanted);
  return picked;
}

std::optional<std::string> Studio::note_on_culling() {
  if (edges_.closed() || (!arguments_.cull_stated && !culling_shows())) return std::nullopt;
  return arguments_.model + ": the mesh is not closed (" + to_string(edges_) +
         "), and faces seen from behind are not drawn; --cull none draws them";
}

bool Studio::culling_shows() {
  if (scene_.triangles.size() >= 1u << 24) return true;  // more than a picture of ids can tell apart
  const int views = arguments_.turntable_frames > 0 ? 4 : 1;
  for (int number = 0; number < views; ++number) {
    FrameRequest wanted = request(number == 0 ? view_ : turned(view_, static_cast<double>(number) / views), light_);
    wanted.want_ids = true;
    wanted.want_depth = wanted.want_statistics = false;
    wanted.samples = 1;
    const std::vector<std::uint32_t> culled = renderer_->draw(wanted).ids;
    wanted.cull = Cull::none;
    if (renderer_->draw(wanted).ids != culled) return true;
  }
  return false;
}

std::uint32_t Studio::stated_depth(std::uint32_t depth, const FrameRequest& request) const {
  const DepthScale scale(view_);
  return scale.changes() ? scale(depth, request.depth_bits, request.depth_sense) : depth;
}

FrameRequest Studio::request(const View& view, const SceneLight& light) const {
  FrameRequest request = make_request(arguments_, *shading_, view, world_, light);
  request.textures = textures_.of_part();
  request.objects = scene_.triangle_objects;
  if (arguments_.environment) request.coordinates = TextureCoordinates::sphere_map;
  if (arguments_.solid) request.volume = to_volume(solid_, scene_, world_);
  if (arguments_.heights) {
    request.relief.heights = &height_map_;
    request.relief.kind = arguments_.relief_kind;
    request.relief.depth = to_fixed<Fixed<16>>(arguments_.relief_depth);
  }
  return request;
}

Picture Studio::picture(const Frame& frame) {
  return panel_ ? panel_->show(frame.pixels, arguments_.band_lines) : to_picture(frame.pixels, frame.size);
}

}  // namespace spanline::sim
