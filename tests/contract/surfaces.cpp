// Bodies of whatever surface the renderer knows: textures of every kind, relief, solids, highlights, point lights, fog,
// dither and glass.
#include <algorithm>
#include <utility>

#include "generators.hpp"
#include "parts.hpp"
#include "sizes.hpp"
#include "support/polygon_bodies.hpp"
#include "support/random_instance.hpp"

namespace spanline::contract {
namespace {

Q16_16 any_number(Random& random, double low, double high) { return test::nearest<Q16_16>(random.real(low, high)); }
std::uint8_t any_byte(Random& random) { return static_cast<std::uint8_t>(random.between(0, 255)); }
template <class Enumeration>
Enumeration any_of(Random& random, Enumeration last) {
  return static_cast<Enumeration>(random.between(0, static_cast<int>(last)));
}

const Texture& any_texture(Random& random, Scene& scene) {
  const auto format = any_of(random, TexelFormat::palette256);
  const auto log2_size = [&] { return static_cast<unsigned>(random.between(0, 5)); };
  const unsigned log2_width = log2_size(), log2_height = log2_size();
  scene.textures.emplace_back(random, format, log2_width, log2_height, random.chance(2));
  Texture& texture = scene.textures.back().texture;
  texture.wrap_s = any_of(random, Wrap::clamp);
  texture.wrap_t = any_of(random, Wrap::clamp);
  return texture;
}

void lay_texture(Random& random, Scene& scene, Material& material) {
  material.texturing = {.texture = &any_texture(random, scene),
                        .function = any_of(random, TextureFunction::blend),
                        .filter = any_of(random, TextureFilter::bilinear),
                        .mapping = any_of(random, TextureMapping::affine),
                        .mip_mapping = any_of(random, MipMapping::span),
                        .alpha = any_of(random, TexelAlpha::blend),
                        .blend_colour = any_colour(random),
                        .coordinates = any_of(random, TextureCoordinates::sphere_map)};
  TextureMatrix& matrix = material.texture_matrix;
  for (Q16_16* factor : {&matrix.ss, &matrix.st, &matrix.ts, &matrix.tt}) *factor = any_number(random, -4, 4);
}

void lay_relief(Random& random, Scene& scene, Material& material) {
  SurfaceTables& tables = scene.tables.emplace_back();
  for (int i = 0; i < 16 * 8; ++i) tables.bytes.push_back(any_byte(random));
  tables.heights = {4, 3, tables.bytes};
  material.relief = {.heights = &tables.heights,
                     .kind = any_of(random, ReliefKind::emboss),
                     .depth = test::nearest<Fixed<16>>(random.real(0.5, 20))};
  if (random.chance(2)) return;
  scene.textures.emplace_back(random, TexelFormat::rgb565, 4u, 5u);
  material.texturing.texture = &scene.textures.back().texture;
}

void cut_from_solid(Random& random, Scene& scene, Material& material) {
  SurfaceTables& tables = scene.tables.emplace_back();
  for (int i = 0; i < 8 * 8 * 8; ++i) tables.bytes.push_back(any_byte(random));
  for (int i = 0; i < 256; ++i) tables.words.push_back(static_cast<std::uint16_t>(random.between(0, 65535)));
  tables.solid = {3, tables.bytes, tables.words};
  material.volume = {.source = SolidSource::table,
                     .texture = &tables.solid,
                     .scale = any_number(random, 0.5, 2),
                     .exponent = static_cast<std::int8_t>(random.between(-1, 2))};
}

void add_point_lights(Random& random, Scene& scene) {
  const int count = random.between(1, 3);
  for (int i = 0; i < count; ++i)
    scene.point_lights.push_back({{any_number(random, -4, 4), any_number(random, -4, 4), any_number(random, -4, 4)},
                                  test::nearest<Fixed<16>>(random.real(0.2, 1.2)),
                                  random.chance(2) ? Q16_16{} : any_number(random, 1, 8)});
  scene.settings.lighting.point_lights = scene.point_lights;
}

/// Coordinates that are linear over every polygon of the body.
std::vector<TextureCoordinate> linear_coordinates(Random& random, const OwnedMesh& mesh) {
  std::vector<TextureCoordinate> table;
  int factors[2][3];
  for (auto& row : factors)
    for (int& factor : row) factor = random.between(-1, 1);
  for (const Vertex16& v : mesh.vertices) {
    const auto along = [&](const int(&row)[3]) {
      return static_cast<std::int16_t>(row[0] * v.x + row[1] * v.y + row[2] * v.z);
    };
    table.push_back({along(factors[0]), along(factors[1])});
  }
  return table;
}

std::vector<TextureCoordinate> texture_coordinates(Random& random, std::size_t count) {
  std::vector<TextureCoordinate> table(count);
  for (TextureCoordinate& at : table) {
    at.s = static_cast<std::int16_t>(random.between(-32768, 32767));
    at.t = static_cast<std::int16_t>(random.between(-32768, 32767));
  }
  return table;
}

}  // namespace

Scene surfaces(Random& random) {
  constexpr int sizes[][2] = {{96, 64}, {40, 30}, {33, 77}, {120, 20}};
  const auto& size = sizes[random.between(0, 3)];
  Scene scene(size[0], size[1]);
  look_from_four(scene);
  scene.settings.cull = any_cull(random);
  scene.settings.camera.near_plane = any_number(random, 0.5, 4);
  scene.settings.background = any_colour(random);
  scene.settings.dither = random.chance(3);
  if (random.chance(3))
    scene.settings.fog = {any_of(random, FogCurve::exponential), any_number(random, 1, 4), any_number(random, 4.5, 8),
                          any_colour(random)};
  // Point lights and relief do not go together, nor do they with opacities of vertices.
  const bool local = random.chance(3);
  if (local) add_point_lights(random, scene);
  const int count = random.between(2, 4);
  for (int i = 0; i < count; ++i) {
    const bool of_polygons = random.chance(2);
    OwnedMesh mesh = of_polygons
                         ? test::prism(random.between(3, 8), random.between(2000, 8000), random.between(2000, 8000))
                         : sphere(random.between(3000, 10000), random.between(3, 6), random.between(3, 8));
    Material material{.colour = any_colour(random), .shading = any_shading(random)};
    const int kind = random.between(0, 3);
    if (kind == 0) lay_texture(random, scene, material);
    if (kind == 1 && !local) lay_relief(random, scene, material);
    if (kind == 2) cut_from_solid(random, scene, material);
    if (!random.chance(3))
      mesh.texture_coordinates = of_polygons && !random.chance(4) ? linear_coordinates(random, mesh)
                                                                  : texture_coordinates(random, mesh.vertices.size());
    const bool relief = material.relief.heights != nullptr;
    if (!relief && kind != 2 && random.chance(3))
      for (std::size_t v = 0; v < mesh.vertices.size(); ++v) mesh.vertex_colours.push_back(any_colour(random));
    if (!relief && kind != 2 && !local && random.chance(4))
      for (std::size_t v = 0; v < mesh.vertices.size(); ++v) mesh.vertex_opacities.push_back(any_byte(random));
    else if (!relief && random.chance(3))
      material.specular = any_colour(random);
    if (random.chance(2)) {
      material.opacity = any_byte(random);
      material.transparency = any_of(random, Transparency::stochastic);
    }
    if (of_polygons) test::mark_planar(mesh);
    Transform transform;
    transform.rotation = test::random_rotation(random);
    transform.translation = {any_number(random, -0.8, 0.8), any_number(random, -0.5, 0.5), any_number(random, -1, 1)};
    add_mesh(scene, std::move(mesh), transform, material);
  }
  return scene;
}

}  // namespace spanline::contract
