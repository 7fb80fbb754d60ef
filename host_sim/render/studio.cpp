#include "render/studio.hpp"

#include <utility>

#include "base/failure.hpp"
#include "import/model_file.hpp"
#include "render/setup.hpp"

namespace spanline::sim {

Studio::Studio(const RenderArguments& arguments) : arguments_(arguments), scene_(import_model(arguments.model)) {
  shading_ = arguments.shading != nullptr ? arguments.shading : &default_shading(scene_);
  if (shading_->textured) {
    if (scene_.texture_points.empty()) throw file_failure(arguments.model, "has no texture coordinates");
    image_ = read_texture(*arguments.texture, {.mip_map = arguments.mip_map});
    image_.shape.wrap_s = image_.shape.wrap_t = arguments.wrap;
    texture_ = image_.view();
  }
  fade(scene_, arguments.opacity);
  scene_ = prepared_for(std::move(scene_), *shading_);
  view_ = resolve_view(arguments.view, scene_, arguments.size, arguments.turntable_frames > 0);
  light_ = resolve_light(arguments.lights, arguments.ambient, view_);
  world_ = choose_world(view_, scene_, arguments.size);
  renderer_.emplace(to_core_meshes(scene_, world_));
  if (arguments.panel != nullptr) panel_.emplace(*arguments.panel);
}

Frame Studio::draw(double turns) {
  SceneLight light = light_;
  if (turns != 0)
    for (Vector3& towards : light.towards) towards = turned(view_, towards, turns);
  const View view = turns == 0 ? view_ : turned(view_, turns);
  return renderer_->draw(request(view, light));
}

PickedPixel Studio::pick(int x, int y) { return renderer_->pick(request(view_, light_), x, y); }

FrameRequest Studio::request(const View& view, const SceneLight& light) const {
  FrameRequest request = make_request(arguments_, *shading_, view, world_, light);
  if (shading_->textured) request.texture = &texture_;
  return request;
}

Picture Studio::picture(const Frame& frame) {
  return panel_ ? panel_->show(frame.pixels, arguments_.band_lines) : to_picture(frame.pixels, frame.size);
}

}  // namespace spanline::sim
