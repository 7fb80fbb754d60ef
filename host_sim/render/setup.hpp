#pragma once
#include "render/frame.hpp"
#include "render/render_arguments.hpp"
#include "scene/scene.hpp"

namespace spanline::sim {

/// How a model is shaded when nobody says: smoothly if its file has normals for its vertices, else flat.
[[nodiscard]] const ShadingEntry& default_shading(const Scene& scene);

/// Whether a scene is drawn with its textures: a shading without light keeps those that there are.
[[nodiscard]] bool shows_textures(const ShadingEntry& shading, const Scene& scene);

/// The scene with just the tables that a shading uses, so that vertices join where they can. Where surfaces are
/// worked out pixel by pixel (relief, solids) they have texture coordinates and one colour.
[[nodiscard]] Scene prepared_for(Scene scene, const ShadingEntry& shading, bool pixel_by_pixel = false);

/// The frame that a view and the rest of the options ask for.
[[nodiscard]] FrameRequest make_request(const RenderArguments& arguments, const ShadingEntry& shading, const View& view,
                                        const World& world, const SceneLight& light);

}  // namespace spanline::sim
