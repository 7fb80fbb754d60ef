#pragma once
#include <optional>

#include "image/height_image.hpp"
#include "render/frame.hpp"
#include "render/panel_picture.hpp"
#include "render/part_textures.hpp"
#include "render/render_arguments.hpp"
#include "scene/surface_edges.hpp"

namespace spanline::sim {

/// A model made ready to be drawn from one camera, or from one that turns about it.
class Studio {
 public:
  /// Reads the model and its textures. `arguments` outlives the studio.
  explicit Studio(const RenderArguments& arguments);

  /// The frame after the model has turned by `turns` of a full circle; 0 is the view as it was asked for.
  [[nodiscard]] Frame draw(double turns);

  /// What is seen at a pixel of the view as it was asked for.
  [[nodiscard]] PickedPixel pick(int x, int y);

  /// What to tell a user whose model is no closed surface, so that the backs that are not drawn may be missed: where
  /// --cull back was asked for, and otherwise where a picture lacks some of them.
  [[nodiscard]] std::optional<std::string> note_on_culling();

  /// The picture as it is seen, on the panel if there is one.
  [[nodiscard]] Picture picture(const Frame& frame);

 private:
  /// Gives the scene's parts the textures that the arguments name, and checks that there are any.
  void name_textures();
  void read_textures();
  [[nodiscard]] FrameRequest request(const View& view, const SceneLight& light) const;
  /// Whether a picture from one of four sides of a turntable, or the still one, shows less for its culling.
  [[nodiscard]] bool culling_shows();
  /// A depth of the picture by the planes that were asked for.
  [[nodiscard]] std::uint32_t stated_depth(std::uint32_t depth, const FrameRequest& request) const;

  const RenderArguments& arguments_;
  Scene scene_;
  const ShadingEntry* shading_ = nullptr;
  View view_;
  SceneLight light_;
  World world_;
  SurfaceEdges edges_;
  std::optional<FrameRenderer> renderer_;
  std::optional<DeskPanel> panel_;
  PartTextures textures_;
  HeightImage heights_;
  HeightMap height_map_;
  VolumeTexture solid_;
};

}  // namespace spanline::sim
