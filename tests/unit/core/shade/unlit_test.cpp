// Materials without light: the picture that full ambient light and no lamp give, whatever lights the frame has.
#include <gtest/gtest.h>
#include <spanline/frame/ready_made_traits.hpp>

#include "shade/shading_scene.hpp"
#include "shade/wall_picture.hpp"

namespace spanline::test {
namespace {

namespace scene = scenes::textured_wall;

constexpr std::array<PointLight, 1> lamps{{{.position = {}, .intensity = Fixed<16>::from_int(2), .range = {}}}};

/// Little ambient light, and lamps of both kinds.
FrameSettings lit_settings(FrameSettings settings) {
  settings.lighting = {Fixed<16>::from_ratio(1, 10), scene::lights, lamps};
  return settings;
}

FrameSettings bright_settings(FrameSettings settings) {
  settings.lighting = {Fixed<16>::from_int(1), {}, {}};
  return settings;
}

template <class Traits>
Picture<Traits> drawn(const Mesh& mesh, const Material& material, const FrameSettings& settings) {
  Capacity capacity = wall_capacity;
  if constexpr (Traits::Shaders::see_through) capacity.fragments = 2u * capacity.width * capacity.height;
  Studio<Traits> studio(capacity);
  studio.begin(settings);
  studio.add(mesh, {}, material);
  auto picture = studio.draw();
  EXPECT_TRUE(studio.status().ok()) << to_string(studio.status().fault);
  EXPECT_GT(std::count_if(picture.pixels.begin(), picture.pixels.end(), [](auto p) { return p != 0; }), 0);
  return picture;
}

template <class Traits>
void expect_without_light(const Mesh& mesh, Material material, const FrameSettings& settings) {
  const auto bright = drawn<Traits>(mesh, material, bright_settings(settings));
  material.specular = {255, 255, 255};
  material.lit = false;
  EXPECT_EQ(drawn<Traits>(mesh, material, lit_settings(settings)), bright);
}

Mesh with_normals_of_polygons() {
  static const std::array<PackedNormal, 2> normals{PackedNormal(300, 0, 400), PackedNormal(0, -511, 0)};
  Mesh mesh = scene::lit_mesh;
  mesh.polygon_normals = normals;
  return mesh;
}

TEST(Unlit, ColoursAreWhatTheyAre) {
  const Mesh mesh = with_normals_of_polygons();
  static const std::array<Rgb888, 4> by_vertex{{{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {90, 120, 30}}};
  static const std::array<Rgb888, 2> by_polygon{{{250, 130, 10}, {20, 90, 200}}};
  for (const ShadingMode shading : {ShadingMode::flat, ShadingMode::gouraud}) {
    Mesh coloured = mesh;
    if (shading == ShadingMode::flat)
      coloured.polygon_colours = by_polygon;
    else
      coloured.vertex_colours = by_vertex;
    for (const Mesh& shown : {mesh, coloured}) {
      expect_without_light<LocalLightTraits<>>(shown, {{200, 100, 50}, shading}, scene::settings());
      expect_without_light<GeneralSeeThroughTraits<>>(shown, {{200, 100, 50}, shading}, scene::fogged_settings());
    }
  }
}

TEST(Unlit, AWhiteSurfaceShowsItsTexels) {
  for (const ShadingMode shading : {ShadingMode::flat, ShadingMode::gouraud}) {
    Material replaced = scene::material, unlit = scene::lit_material;
    unlit.shading = shading;
    unlit.lit = false;
    EXPECT_EQ(drawn<TextureTraits<>>(scene::lit_mesh, unlit, lit_settings(scene::settings())).pixels,
              drawn<TextureTraits<>>(scene::lit_mesh, replaced, scene::settings()).pixels);
    for (const TextureFilter filter : {TextureFilter::nearest, TextureFilter::bilinear}) {
      unlit.texturing.filter = replaced.texturing.filter = filter;
      EXPECT_EQ(drawn<GeneralTraits<>>(scene::lit_mesh, unlit, lit_settings(scene::settings())).pixels,
                drawn<GeneralTraits<>>(scene::lit_mesh, replaced, scene::settings()).pixels);
      expect_without_light<GeneralTraits<>>(scene::lit_mesh, unlit, scene::settings());
      expect_without_light<GeneralTraits<>>(scene::lit_mesh, unlit, scene::fogged_settings());
    }
    unlit.texturing.filter = TextureFilter::nearest;
    expect_without_light<FoggedTextureTraits<>>(scene::lit_mesh, unlit, scene::fogged_settings());
  }
}

TEST(Unlit, AListOfTheShaderWithoutLightAloneServesThem) {
  using Traits =
      RendererTraits<Rgb565, ShaderList<NearestTextureShader<Rgb565, TexelFormat::rgb565, NoTexelLight>>, Counted>;
  Material unlit = scene::lit_material;
  unlit.lit = false;
  EXPECT_EQ(drawn<Traits>(scene::lit_mesh, unlit, lit_settings(scene::settings())).pixels,
            drawn<Traits>(scene::lit_mesh, scene::material, scene::settings()).pixels);
}

TEST(Unlit, ColoursTintTextures) {
  for (const Rgb888 colour : {Rgb888{255, 128, 0}, Rgb888{10, 20, 200}}) {
    Material material = scene::lit_material;
    material.colour = colour;
    expect_without_light<GeneralTraits<>>(scene::lit_mesh, material, scene::settings());
    material.opacity = 100;
    expect_without_light<GeneralSeeThroughTraits<>>(scene::lit_mesh, material, scene::settings());
  }
}

TEST(Unlit, ReliefIsLight) {
  static const std::array<std::uint8_t, 4> heights{0, 255, 60, 0};
  static const HeightMap map{.log2_width = 1, .log2_height = 1, .heights = heights};
  Material material = scene::lit_material;
  const auto smooth = drawn<GeneralTraits<>>(scene::lit_mesh, material, bright_settings(scene::settings()));
  material.relief.heights = &map;
  material.lit = false;
  EXPECT_EQ(drawn<GeneralTraits<>>(scene::lit_mesh, material, lit_settings(scene::settings())), smooth);
}

}  // namespace
}  // namespace spanline::test
