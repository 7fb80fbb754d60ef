#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <spanline/model/cull.hpp>

#include "scenes/model_view.hpp"
#include "scenes/prisms_mesh.hpp"
#include "scenes/random_soups.hpp"
#include "scenes/room_mesh.hpp"
#include "scenes/surface_meshes.hpp"
#include "scenes/terrain_mesh.hpp"
#include "scenes/textured_wall.hpp"
#include "scenes/torus_mesh.hpp"

namespace spanline::scenes {

/// The converted models, which the program that draws them links.
struct SelftestModels {
  const Mesh& bunny;
  const Mesh& teapot;
};

/// What a scene puts before a renderer.
struct SelftestContent {
  struct Instance {
    const Mesh* mesh = nullptr;
    Transform transform;
    Material material;
  };
  FrameSettings settings;
  std::span<Instance> instances;  ///< room for as many as the scene has
  std::uint32_t instance_count = 0;
  ScreenSoup soup;  ///< tables of the scene's size, which the scene fills

  void add(const Mesh& mesh, const Transform& transform, const Material& material) {
    instances[instance_count++] = {&mesh, transform, material};
  }
};

/// What a scene may want to know.
struct SelftestRequest {
  const SelftestModels& models;
  int width, height;  ///< pixels
  int depth_bits;
};

namespace selftest_detail {

inline constexpr std::array<DirectionalLight, 1> one_light{
    {{{0.4243_q30, 0.5657_q30, 0.7071_q30}, Fixed<16>::from_ratio(8, 10)}}};

/// From the left, the right, above and behind; where two of them meet the sum is more than white.
inline constexpr std::array<DirectionalLight, 4> four_lights{
    {{{-0.8_q30, {}, 0.6_q30}, Fixed<16>::from_ratio(35, 100)},
     {{0.8_q30, {}, 0.6_q30}, Fixed<16>::from_ratio(45, 100)},
     {{{}, 1.0_q30, {}}, Fixed<16>::from_ratio(8, 10)},
     {{{}, -0.6_q30, -0.8_q30}, Fixed<16>::from_ratio(5, 10)}}};

inline constexpr Rgb888 background{24, 28, 48};

template <SoupShape Shape>
void build_soup(const SelftestRequest& request, SelftestContent& content) {
  content.settings.cull = Cull::none;
  make_random_triangles(Shape, request.width, request.height, request.depth_bits, content.soup);
}

/// A mesh about the origin, 2 to 3 units across, seen from 4 units away with one light.
inline void look(const SelftestRequest& request, SelftestContent& content) {
  content.settings.background = background;
  content.settings.camera.eye = {{}, {}, 4.0_q16};
  content.settings.camera.focal = Q16_16::from_ratio(std::int64_t{5} * request.height, 4);
  content.settings.camera.near_plane = 0.5_q16;
  content.settings.camera.far_plane = 16.0_q16;
  content.settings.lighting = {Fixed<16>::from_ratio(2, 10), one_light};
}

inline Transform tilted(int degrees) {
  return {rotation_x(Angle::from_degrees(degrees)) * rotation_y(Angle::from_degrees(17))};
}

template <const Mesh& Shown, ShadingMode Mode>
void build_mesh(const SelftestRequest& request, SelftestContent& content) {
  look(request, content);
  content.add(Shown, tilted(40), {{255, 190, 90}, Mode});
}

/// The turntable's view of a model.
template <ShadingMode Mode>
void build_model(const Mesh& mesh, const SelftestRequest& request, SelftestContent& content) {
  const ModelView view = model_view(mesh, Angle::from_degrees(30), request.height, Mode);
  content.settings = view.settings;
  content.settings.background = background;
  content.add(mesh, view.transform, view.material);
}
template <ShadingMode Mode>
void build_bunny(const SelftestRequest& request, SelftestContent& content) {
  build_model<Mode>(request.models.bunny, request, content);
}
template <ShadingMode Mode>
void build_teapot(const SelftestRequest& request, SelftestContent& content) {
  build_model<Mode>(request.models.teapot, request, content);
}

/// The eye inside the tube of a torus: polygons on all sides cross the near plane, and the nearest leave the guard
/// band.
inline void build_tube(const SelftestRequest& request, SelftestContent& content) {
  look(request, content);
  content.settings.camera.look_at({{}, 0.05_q16, 1.03125_q16}, {-1.0_q16, {}, 0.4_q16}, {{}, 1.0_q30, {}});
  content.settings.camera.focal = Q16_16::from_ratio(request.height, 3);
  content.settings.camera.near_plane = Q16_16::from_ratio(1, 100);
  content.settings.cull = Cull::front;
  content.add(coloured_torus, {}, {{}, ShadingMode::gouraud});
}

/// So near that the near plane opens the teapot, and its inside shows.
inline void build_cut_teapot(const SelftestRequest& request, SelftestContent& content) {
  build_teapot<ShadingMode::gouraud>(request, content);
  content.settings.camera.near_plane = 3.5_q16;
  content.settings.cull = Cull::none;
}

inline void build_ortho_teapot(const SelftestRequest& request, SelftestContent& content) {
  build_teapot<ShadingMode::flat>(request, content);
  content.settings.camera.projection = Projection::orthographic;
  content.settings.camera.focal = Q16_16::from_ratio(std::int64_t{3} * request.height, 10);
  content.settings.camera.near_plane = 0.5_q16;
}

inline void build_ortho_torus(const SelftestRequest& request, SelftestContent& content) {
  build_mesh<coloured_torus, ShadingMode::gouraud>(request, content);
  content.settings.camera.projection = Projection::orthographic;
  content.settings.camera.focal = Q16_16::from_ratio(request.height, 3);
}

/// Over the hills, some of which lie behind the eye and some beyond the far plane.
inline void build_terrain(const SelftestRequest& request, SelftestContent& content) {
  look(request, content);
  content.settings.background = {150, 190, 230};
  content.settings.camera.look_at({{}, 300.0_q16, 900.0_q16}, {{}, {}, -200.0_q16}, {{}, 1.0_q30, {}});
  content.settings.camera.focal = Q16_16::from_ratio(std::int64_t{4} * request.height, 5);
  content.settings.camera.near_plane = 8.0_q16;
  content.settings.camera.far_plane = 1900.0_q16;
  Transform transform;
  transform.translation = {-4096.0_q16, {}, {}};
  content.add(terrain, transform, {});
}

inline void build_prisms(const SelftestRequest& request, SelftestContent& content) {
  look(request, content);
  content.add(prisms, tilted(50), {});
}

/// Polygons that are one entry each, the eye so near that planes clip them.
template <ShadingMode Mode>
void build_planar_prisms(const SelftestRequest& request, SelftestContent& content) {
  look(request, content);
  content.settings.camera.look_at({0.75_q16, 0.25_q16, 1.25_q16}, {-0.5_q16, -0.25_q16, -0.75_q16}, {{}, 1.0_q30, {}});
  content.settings.camera.focal = Q16_16::from_ratio(request.height, 2);
  content.settings.camera.near_plane = Q16_16::from_ratio(1, 16);
  content.add(planar_prisms, tilted(10), {});
  Transform behind = tilted(70);
  behind.translation.z = -1.0_q16;
  content.add(planar_prisms, behind, {{}, Mode});
}

/// A textured room of quads that are one entry each, seen from within.
inline void build_room(const SelftestRequest& request, SelftestContent& content) {
  content.settings = room_settings(Angle::from_degrees(70), request.height);
  content.add(room, {}, room_material);
}

template <ShadingMode Mode>
void build_lights(const SelftestRequest& request, SelftestContent& content) {
  look(request, content);
  content.settings.lighting = {Fixed<16>::from_ratio(1, 10), four_lights};
  content.add(torus, tilted(35), {{230, 230, 230}, Mode});
}

/// Two links of a chain, one flat and one smooth, of two sizes.
inline void build_chain(const SelftestRequest& request, SelftestContent& content) {
  look(request, content);
  Transform left = tilted(30), right{rotation_x(Angle::from_degrees(100))};
  left.translation.x = -0.5_q16;
  right.translation.x = 0.5_q16;
  right.scale = 0.8_q24;
  content.add(torus, left, {{240, 80, 70}, ShadingMode::flat});
  content.add(torus, right, {{90, 160, 250}, ShadingMode::gouraud});
}

/// All three shaders in one frame, and meshes that cut through one another.
inline void build_mixture(const SelftestRequest& request, SelftestContent& content) {
  build_chain(request, content);
  Transform front = tilted(75);
  front.translation = {{}, -0.25_q16, 0.25_q16};
  front.scale = 0.7_q24;
  content.add(coloured_torus, front, {{}, ShadingMode::gouraud});
  Transform behind = tilted(20);
  behind.translation.z = -0.5_q16;
  content.add(prisms, behind, {});
}

/// The mixture, of glass but for one of its four meshes.
inline void build_glass(const SelftestRequest& request, SelftestContent& content) {
  build_mixture(request, content);
  content.settings.cull = Cull::none;
  const auto glaze = [&](std::size_t instance, std::uint8_t opacity, Transparency transparency) {
    content.instances[instance].material.opacity = opacity;
    content.instances[instance].material.transparency = transparency;
  };
  glaze(0, 110, Transparency::blend);
  glaze(2, 150, Transparency::add);
  glaze(3, 180, Transparency::screen_door);
}

/// Everything that the general shader does: a wall under bilinear texels in fog, before it a ring that is cut out and
/// two squares that cut through one another, whose opacity varies by their corners and their texels.
inline void build_surfaces(const SelftestRequest& request, SelftestContent& content) {
  look(request, content);
  content.settings.cull = Cull::none;
  content.settings.fog = {FogCurve::exponential, 3.0_q16, 9.0_q16, {120, 130, 150}};
  content.settings.dither = true;
  Transform wall;
  wall.translation = {-0.5_q16, {}, 2.0_q16};
  content.add(textured_wall::mesh, wall,
              {{255, 220, 180},
               ShadingMode::flat,
               {&textured_wall::grained, TextureFunction::modulate, TextureFilter::bilinear}});
  Transform ring = tilted(20), veil = tilted(-30), screen = tilted(60);
  ring.translation = {-0.6_q16, 0.3_q16, 0.5_q16};
  veil.translation = {0.4_q16, {}, {}};
  screen.translation = {0.3_q16, -0.2_q16, {}};
  content.add(surface_square::plain, ring,
              {{255, 255, 255}, ShadingMode::flat, {&surface_textures::ring, TextureFunction::replace}});
  Material fading{{255, 255, 255}, ShadingMode::gouraud, {&surface_textures::disc}};
  fading.texturing.alpha = TexelAlpha::blend;
  content.add(surface_square::fading, veil, fading);
  fading.texturing.filter = TextureFilter::bilinear;
  fading.transparency = Transparency::screen_door;
  fading.opacity = 220;
  content.add(surface_square::fading, screen, fading);
}

/// Walls under a texture: one that fills the view, lit, and two as they are, which cut through it and one another.
template <bool Foggy>
void build_walls(const SelftestRequest& request, SelftestContent& content) {
  namespace scene = textured_wall;
  content.settings = Foggy ? scene::fogged_settings() : scene::settings();
  content.settings.lighting = {Fixed<16>::from_ratio(1, 10), scene::lights};
  content.settings.background = {160, 176, 200};
  content.settings.camera.focal = Q16_16::from_ratio(std::int64_t{4} * request.height, 3);
  content.settings.cull = Cull::none;
  // Not by copies of the benchmark's, whose texture small boards would then link.
  const Material lit{{255, 255, 255}, ShadingMode::gouraud, {&scene::grained, TextureFunction::modulate}},
      plain{{255, 255, 255}, ShadingMode::flat, {&scene::grained, TextureFunction::replace}};
  content.add(scene::lit_mesh, {}, lit);
  Transform across{rotation_y(Angle::from_degrees(-80))};
  across.translation = {-1.5_q16, {}, -6.0_q16};
  content.add(scene::mesh, across, plain);
  Transform behind{rotation_z(Angle::from_degrees(20))};
  behind.translation = {0.25_q16, 0.5_q16, -0.5_q16};
  content.add(scene::mesh, behind, plain);
}

/// What culling normally leaves out.
inline void build_inside_out(const SelftestRequest& request, SelftestContent& content) {
  build_mesh<torus, ShadingMode::flat>(request, content);
  content.settings.cull = Cull::front;
}

}  // namespace selftest_detail

}  // namespace spanline::scenes
