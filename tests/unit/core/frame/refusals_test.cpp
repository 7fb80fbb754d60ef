// Nothing is silent: what a renderer cannot draw, and calls out of their turn, have a status each that names the
// matter.
#include <gtest/gtest.h>
#include <spanline/frame/band_partner.hpp>
#include <spanline/frame/pick.hpp>
#include <spanline/frame/ready_made_traits.hpp>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <vector>

#include "scenes/textured_wall.hpp"
#include "support/owned_mesh.hpp"
#include "support/ready_made_studios.hpp"

namespace spanline::test {
namespace {

using namespace spanline::literals;
namespace wall = scenes::textured_wall;

/// Room for the wall, for each pixel of a band as a fragment, and for as many polygons awake.
constexpr Capacity capacity{.width = 64,
                            .height = 48,
                            .band_lines = 16,
                            .vertices = 20,
                            .shades = 20,
                            .textures = 20,
                            .polygons = 10,
                            .fans = 10,
                            .active = 10,
                            .awake = 10,
                            .fragments = 1024,
                            .layers = 10};

/// What a renderer of these traits says of the wall in this material. Where it refuses, nothing is drawn and the frame
/// goes on.
template <class Traits>
Status status_of(const Material& material, const FrameSettings& settings = wall::settings(),
                 const Mesh& mesh = wall::lit_mesh) {
  Studio<Traits> studio(capacity);
  studio.begin(settings);
  EXPECT_TRUE(studio.status().ok());
  studio.add(mesh, {}, material);
  const auto picture = studio.draw();
  EXPECT_TRUE(studio.drawn().ok());
  const auto background = Traits::Format::from(settings.background);
  const bool drawn = std::ranges::any_of(picture.pixels, [&](auto pixel) { return pixel != background; });
  EXPECT_EQ(drawn, studio.added().ok());
  return studio.added();
}

Material textured() {
  Material material = wall::material;
  material.colour = {255, 255, 255};
  return material;
}
Material glass(Material material = {.colour = {255, 255, 255}}) {
  material.opacity = 128;
  return material;
}
FrameSettings in_fog() {
  FrameSettings settings = wall::settings();
  settings.fog = {FogCurve::linear, 1.0_q16, 20.0_q16, {160, 176, 200}};
  return settings;
}

TEST(Refusals, ATextureWithoutAShaderForTextures) {
  EXPECT_EQ(status_of<FlatTraits<>>(textured()), Status(MissingShader::texture));
  EXPECT_EQ(status_of<GouraudTraits<>>(textured()), Status(MissingShader::texture));
  EXPECT_EQ(status_of<LocalLightTraits<>>(textured()), Status(MissingShader::texture));
  EXPECT_EQ((status_of<FlatTraits<Rgb565, Depth24<>, Spanning>>(textured())), Status(MissingShader::texture));
  EXPECT_TRUE(status_of<TextureTraits<>>(textured()).ok());
  Material smooth = textured();
  smooth.texturing.filter = TextureFilter::bilinear;
  EXPECT_EQ(status_of<TextureTraits<>>(smooth), Status(MissingShader::texture)) << "no shader for this filter";
  EXPECT_TRUE(status_of<GeneralTraits<>>(smooth).ok());
}

TEST(Refusals, ATextureThatDoesNotLieOnTheMeshIsNone) {
  Mesh bare = wall::lit_mesh;
  bare.texture_coordinates = {};
  Material material = textured();
  EXPECT_TRUE(status_of<FlatTraits<>>(material, wall::settings(), bare).ok());
}

TEST(Refusals, TexturedGlassWithoutAShaderForIt) {
  EXPECT_EQ(status_of<SeeThroughTraits<>>(glass(textured())), Status(MissingShader::translucent_texture));
  EXPECT_EQ(status_of<TextureTraits<>>(glass(textured())), Status(MissingShader::translucent_texture));
  EXPECT_EQ(status_of<GeneralTraits<>>(glass(textured())), Status(MissingShader::translucent_texture));
  EXPECT_EQ((status_of<SeeThroughTraits<Rgb565, Depth24<>, Spanning>>(glass(textured()))),
            Status(MissingShader::translucent_texture));
  EXPECT_TRUE(status_of<GeneralSeeThroughTraits<>>(glass(textured())).ok());
}

TEST(Refusals, GlassWithoutAShaderForIt) {
  EXPECT_EQ(status_of<FlatTraits<>>(glass()), Status(MissingShader::see_through));
  EXPECT_EQ(status_of<GeneralTraits<>>(glass()), Status(MissingShader::see_through));
  EXPECT_TRUE(status_of<SeeThroughTraits<>>(glass()).ok());
  Material glow{.colour = {255, 255, 255}};
  glow.transparency = Transparency::add;
  EXPECT_EQ(status_of<GouraudTraits<>>(glow), Status(MissingShader::see_through));
}

TEST(Refusals, OpacitiesOfVerticesWithoutAShaderForThem) {
  constexpr std::array<std::uint8_t, 4> opacities{255, 128, 64, 0};
  Mesh mesh = wall::lit_mesh;
  mesh.vertex_opacities = opacities;
  const Material plain{.colour = {255, 255, 255}};
  EXPECT_EQ(status_of<SeeThroughTraits<>>(plain, wall::settings(), mesh), Status(MissingShader::varying_opacity));
  EXPECT_TRUE(status_of<GeneralSeeThroughTraits<>>(plain, wall::settings(), mesh).ok());
  Material shiny = plain;
  shiny.specular = {9, 9, 9};
  EXPECT_EQ(status_of<GeneralSeeThroughTraits<>>(shiny, wall::settings(), mesh), Status(MissingShader::mixture));
}

TEST(Refusals, HolesWithoutDepthsOrLayers) {
  std::vector<std::uint16_t> texels(64, 0xffff);
  const Texture holes{.format = TexelFormat::rgb565_cutout, .log2_width = 3, .log2_height = 3, .words = texels};
  Material material = textured();
  material.texturing.texture = &holes;
  EXPECT_EQ((status_of<GeneralTraits<Rgb565, Depth24<>, Spanning>>(material)), Status(MissingShader::cut_out_texture));
  EXPECT_TRUE(status_of<GeneralTraits<>>(material).ok());
  EXPECT_TRUE((status_of<GeneralSeeThroughTraits<Rgb565, Depth24<>, Spanning>>(material).ok()));
}

TEST(Refusals, EffectsWithoutAShaderForThem) {
  const Material plain{.colour = {255, 255, 255}};
  EXPECT_EQ(status_of<FlatTraits<>>(plain, in_fog()), Status(MissingShader::fog));
  EXPECT_EQ(status_of<FoggedTextureTraits<>>(plain, in_fog()), Status(MissingShader::fog));
  EXPECT_TRUE(status_of<FoggedTextureTraits<>>(textured(), in_fog()).ok());
  FrameSettings dithered = wall::settings();
  dithered.dither = true;
  EXPECT_EQ(status_of<TextureTraits<>>(textured(), dithered), Status(MissingShader::dither));
  EXPECT_TRUE(status_of<GeneralTraits<>>(plain, dithered).ok());
}

TEST(Refusals, LightReliefAndSolidsWithoutAShaderForThem) {
  Material material{.colour = {255, 255, 255}};
  material.specular = {255, 255, 255};
  EXPECT_EQ(status_of<GouraudTraits<>>(material), Status(MissingShader::local_light));
  const std::vector<PointLight> points(1);
  FrameSettings lit = wall::settings();
  lit.lighting.point_lights = points;
  EXPECT_EQ(status_of<TextureTraits<>>({}, lit), Status(MissingShader::local_light));
  EXPECT_TRUE(status_of<LocalLightTraits<>>(material).ok());

  const std::vector<std::uint8_t> levels(64);
  const HeightMap heights{.log2_width = 3, .log2_height = 3, .heights = levels};
  material.relief.heights = &heights;
  EXPECT_EQ(status_of<GeneralTraits<>>(material), Status(MissingShader::mixture)) << "relief and highlights";
  material.specular = {0, 0, 0};
  EXPECT_EQ(status_of<TextureTraits<>>(material), Status(MissingShader::relief));
  EXPECT_TRUE(status_of<GeneralTraits<>>(material).ok());

  Material solid;
  solid.volume.source = SolidSource::table;
  EXPECT_EQ(status_of<TextureTraits<>>(solid), Status(MissingShader::volume));
}

TEST(Refusals, ShadingWithoutAShaderForIt) {
  EXPECT_EQ(status_of<FlatTraits<>>({.shading = ShadingMode::gouraud}), Status(MissingShader::gouraud));
  constexpr std::array<Rgb888, 4> colours{};
  Mesh mesh = wall::lit_mesh;
  mesh.vertex_colours = colours;
  EXPECT_EQ(status_of<FlatTraits<>>({.shading = ShadingMode::gouraud}, wall::settings(), mesh),
            Status(MissingShader::vertex_colours));
  using GouraudAlone = RendererTraits<Rgb565, ShaderList<GouraudShader<Rgb565>>>;
  EXPECT_EQ(status_of<GouraudAlone>({}), Status(MissingShader::flat));
}

TEST(Refusals, PicturesOfIdsTakeEveryMaterial) { EXPECT_TRUE(status_of<IdTraits<>>(glass(textured()), in_fog()).ok()); }

TEST(Refusals, TrianglesOnScreenAreFlatWhateverTheMaterialAsks) {
  Studio<GouraudTraits<>> studio(screen_capacity(32, 32, 1));
  const std::array<std::uint16_t, 1> colours{0xf800};
  const std::array<ScreenVertex, 3> corners{ScreenVertex::make(16, 16, 100, 16, 0),
                                            ScreenVertex::make(16, 400, 100, 16, 0),
                                            ScreenVertex::make(400, 16, 100, 16, 0)};
  FrameSettings settings = in_fog();
  settings.cull = Cull::none;
  studio.begin(settings);
  studio.add_screen(corners, colours, {.shading = ShadingMode::gouraud});
  const auto picture = studio.draw();
  EXPECT_TRUE(studio.status().ok());
  EXPECT_EQ(picture.pixels[picture.at(4, 4)], 0xf800);
  studio.begin(settings);
  EXPECT_EQ(studio.renderer().add_screen(corners, colours, glass()), Status(MissingShader::see_through));
}

TEST(Refusals, CornerCountsThatAreNotThoseOfTheVertices) {
  Capacity room = screen_capacity(32, 32, 8);
  room.fans = 8;
  Studio<FlatTraits<>> studio(room);
  Renderer<FlatTraits<>>& renderer = studio.renderer();
  // The corners of a square, so often that wrong counts, too, name vertices that exist.
  constexpr std::array<std::array<std::int32_t, 2>, 4> square{{{16, 16}, {400, 16}, {400, 400}, {16, 400}}};
  std::array<ScreenVertex, 12> vertices;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    vertices[i] = ScreenVertex::make(square[i % 4][0], square[i % 4][1], 30000, 16);
  const std::array<std::uint16_t, 4> colours{0xf800, 0x07e0, 0x001f, 0xffff};
  const auto add = [&](std::span<const std::uint8_t> corners, std::size_t count) {
    return renderer.add_screen(std::span<const ScreenVertex>(vertices).first(count), corners, colours, {});
  };
  const auto number_of_pixels = [](const auto& picture, std::uint16_t colour) {
    return std::ranges::count(picture.pixels, colour);
  };
  constexpr std::uint8_t mark = Mesh::planar;
  FrameSettings settings = wall::settings();
  settings.cull = Cull::none;

  studio.begin(settings);
  for (const std::array<std::uint8_t, 2> wrong :
       {std::array<std::uint8_t, 2>{4, 2}, {4, 9}, {0, 4}, {4, mark}, {4, mark | 2}, {mark | 9, 3}, {4, 127}}) {
    const std::size_t sum = (wrong[0] & 127u) + (wrong[1] & 127u);
    EXPECT_EQ(add(wrong, std::min(sum, vertices.size())), Status(Fault::bad_corners))
        << int{wrong[0]} << ", " << int{wrong[1]};
  }
  constexpr std::array<std::uint8_t, 2> two{4 | mark, 4};
  for (const std::size_t count : {0U, 7U, 9U, 12U})
    EXPECT_EQ(add(two, count), Status(Fault::bad_corners)) << count << " vertices";
  EXPECT_EQ(add({}, 4), Status(Fault::bad_corners)) << "no counts";
  EXPECT_TRUE(add({}, 0).ok()) << "no polygons";
  const auto empty = studio.draw();
  EXPECT_EQ(number_of_pixels(empty, Rgb565::from(settings.background)), 32 * 32) << "something was added";

  studio.begin(settings);
  EXPECT_EQ(add(two, 9), Status(Fault::bad_corners));
  EXPECT_TRUE(add(two, 8).ok()) << "the frame goes on";
  const auto picture = studio.draw();
  EXPECT_TRUE(studio.drawn().ok());
  EXPECT_EQ(number_of_pixels(picture, 0xf800), 24 * 24) << "the first square, in front of its equal";
}

TEST(Refusals, MoreThanFourLightsOfAKind) {
  std::vector<std::byte> memory(Renderer<LocalLightTraits<>>::bytes_needed(capacity));
  Renderer<LocalLightTraits<>> renderer(capacity, memory);
  const std::array<DirectionalLight, 6> lights{};
  const std::array<PointLight, 5> points{};
  FrameSettings settings = wall::settings();
  settings.lighting.lights = std::span(lights).first(4);
  settings.lighting.point_lights = std::span(points).first(4);
  EXPECT_TRUE(renderer.begin(settings).ok());
  settings.lighting.point_lights = points;
  EXPECT_EQ(renderer.begin(settings), (Status{Fault::too_many_lights, Pool::none, 5}));
  settings.lighting = {.lights = lights};
  EXPECT_EQ(renderer.begin(settings), (Status{Fault::too_many_lights, Pool::none, 6}));
  EXPECT_EQ(renderer.add(wall::lit_mesh, {}, {}).fault, Fault::too_many_lights) << "the frame was refused";
}

TEST(Refusals, NothingIsAddedOrDrawnBeforeBegin) {
  using Picture = Renderer<IdTraits<Counted>>;
  std::vector<std::byte> memory(Picture::bytes_needed(capacity));
  std::vector<std::byte> more(BandPartner<IdTraits<Counted>>::bytes_needed(capacity));
  Picture renderer(capacity, memory);
  BandPartner<IdTraits<Counted>> partner(renderer, more);
  const auto sink = [](const auto&) { return true; };
  Picked<Depth16<>> picked;
  EXPECT_EQ(renderer.add(wall::mesh, {}, {}).fault, Fault::no_frame);
  EXPECT_EQ(renderer.add_screen({}, {}).fault, Fault::no_frame);
  EXPECT_EQ(renderer.add_screen({}, std::span<const std::uint8_t>{}, {}, {}).fault, Fault::no_frame);
  EXPECT_EQ(renderer.draw(sink).fault, Fault::no_frame);
  EXPECT_EQ(renderer.draw_even(sink).fault, Fault::no_frame);
  EXPECT_EQ(partner.take_frame().fault, Fault::no_frame);
  EXPECT_EQ(partner.draw_odd(sink).fault, Fault::no_frame);
  EXPECT_EQ(pick(renderer, 1, 1, picked).fault, Fault::no_frame);
  for (const auto& [x, y] : {std::pair{64, 1}, {1, 48}, {-1, 1}, {1, -1}})
    EXPECT_EQ(pick(renderer, x, y, picked).fault, Fault::outside_picture) << x << ", " << y;
}

/// Every step of drawing, band 1 among them.
template <class Traits>
void expect_steps_to_do_nothing(Renderer<Traits>& renderer, Fault fault) {
  struct {
  } sink;
  EXPECT_EQ(renderer.start_bands().fault, fault);
  EXPECT_EQ(renderer.clear_band(1).fault, fault);
  EXPECT_TRUE(renderer.draw_band(1, sink).pixels.empty());
  EXPECT_EQ(renderer.end_bands().fault, fault);
}

template <class Traits>
class Steps : public ::testing::Test {};
using StepTraits =
    ::testing::Types<FlatTraits<>, FlatTraits<Rgb565, Depth24<>, Spanning>, FlatTraits<Rgb565, Deferred<>>,
                     FlatTraits<Rgb565, BoundedZBuffer>, GeneralSeeThroughTraits<Rgb565, Spanning>>;
TYPED_TEST_SUITE(Steps, StepTraits);

TYPED_TEST(Steps, OfARendererThatWasRefusedDoNothingAndSaySo) {
  Capacity wrong = capacity;
  wrong.band_lines = 0;
  Renderer<TypeParam> misshapen(wrong, {});
  expect_steps_to_do_nothing(misshapen, Fault::bad_configuration);
  Renderer<TypeParam> without_memory(capacity, {});
  expect_steps_to_do_nothing(without_memory, Fault::pool_full);
  EXPECT_EQ(without_memory.begin(wall::settings()).fault, Fault::pool_full);
  expect_steps_to_do_nothing(without_memory, Fault::pool_full);
}

TYPED_TEST(Steps, WithoutAFrameDoNothingAndSaySo) {
  std::vector<std::byte> memory(Renderer<TypeParam>::bytes_needed(capacity));
  Renderer<TypeParam> renderer(capacity, memory);
  expect_steps_to_do_nothing(renderer, Fault::no_frame);
  FrameSettings bad = wall::settings();
  bad.camera.focal = {};
  EXPECT_EQ(renderer.begin(bad).fault, Fault::bad_focal);
  expect_steps_to_do_nothing(renderer, Fault::bad_focal);
}

TYPED_TEST(Steps, OutOfTheirTurnDoNothingAndSaySo) {
  struct {
  } sink;
  std::vector<std::byte> memory(Renderer<TypeParam>::bytes_needed(capacity));
  Renderer<TypeParam> renderer(capacity, memory);
  ASSERT_TRUE(renderer.begin(wall::settings()).ok());
  EXPECT_TRUE(renderer.draw_band(0, sink).pixels.empty()) << "before start_bands";
  EXPECT_EQ(renderer.end_bands().fault, Fault::bad_step);
  ASSERT_TRUE(renderer.start_bands().ok());
  for (std::uint32_t band = 0; band < 3; ++band) {
    EXPECT_TRUE(renderer.clear_band(band).ok());
    EXPECT_EQ(renderer.draw_band(band, sink).pixels.size(), 64U * 16U);
  }
  EXPECT_EQ(renderer.clear_band(3).fault, Fault::bad_step) << "the picture has three bands";
  EXPECT_TRUE(renderer.draw_band(3, sink).pixels.empty());
  EXPECT_TRUE(renderer.end_bands().ok());
  EXPECT_EQ(renderer.end_bands().fault, Fault::bad_step);
}

template <class Traits>
class Again : public ::testing::Test {};
using AgainTraits = ::testing::Types<FlatTraits<>, FlatTraits<Rgb565, Depth24<>, Spanning>>;
TYPED_TEST_SUITE(Again, AgainTraits);

TYPED_TEST(Again, AFrameThatWasTakenApartIsNotDrawn) {
  using Traits = TypeParam;
  std::vector<std::byte> memory(Renderer<Traits>::bytes_needed(capacity));
  std::vector<std::byte> more(BandPartner<Traits>::bytes_needed(capacity));
  Renderer<Traits> renderer(capacity, memory);
  BandPartner<Traits> partner(renderer, more);
  constexpr bool once = BandDrawer<Traits>::Visibility::takes_table_apart;
  const auto draw = [&] {
    std::vector<std::uint16_t> picture;
    const Status drawn = renderer.draw([&](const auto& band) {
      picture.insert(picture.end(), band.pixels.begin(), band.pixels.end());
      return true;
    });
    return std::pair(drawn, picture);
  };
  for (int frame = 0; frame < 2; ++frame) {
    ASSERT_TRUE(renderer.begin(wall::settings()).ok());
    ASSERT_TRUE(renderer.add(wall::mesh, {}, {.colour = {240, 160, 60}}).ok());
    const auto first = draw();
    EXPECT_TRUE(first.first.ok());
    EXPECT_EQ(first.second.size(), 64U * 48U);
    const auto again = draw();
    EXPECT_EQ(again.first, once ? Status(Fault::no_frame) : Status());
    EXPECT_EQ(again.second, once ? std::vector<std::uint16_t>() : first.second);
    EXPECT_EQ(renderer.start_bands().ok(), !once);
    EXPECT_EQ(partner.take_frame().ok(), !once);
  }
}

/// A pool that is larger than its numbers is named with the most that it can have.
template <class Picture>
void expect_limit(Pool pool, std::uint32_t Capacity::*member) {
  Capacity large = capacity;
  large.*member = ~0u;
  const Status refused = Picture::check(large);
  EXPECT_EQ(refused.fault, Fault::bad_configuration) << to_string(pool);
  EXPECT_EQ(refused.pool, pool);
  large.*member = refused.wanted;
  EXPECT_TRUE(Picture::takes(large)) << to_string(pool);
  ++(large.*member);
  EXPECT_FALSE(Picture::takes(large)) << to_string(pool);
}

TEST(Refusals, APoolThatIsLargerThanItsNumbersIsNamedWithTheMostThatItCanHave) {
  using Spans = Renderer<GeneralSeeThroughTraits<Rgb565, Depth24<>, Spanning>>;
  expect_limit<Spans>(Pool::instances, &Capacity::instances);
  expect_limit<Spans>(Pool::polygons, &Capacity::polygons);
  expect_limit<Spans>(Pool::fans, &Capacity::fans);
  expect_limit<Spans>(Pool::awake, &Capacity::awake);
  expect_limit<Spans>(Pool::layers, &Capacity::layers);
  using Depths = Renderer<GeneralSeeThroughTraits<>>;
  expect_limit<Depths>(Pool::active, &Capacity::active);
  expect_limit<Depths>(Pool::fragments, &Capacity::fragments);
}

// The check is for constants.
static_assert(Renderer<FlatTraits<Rgb565, Depth24<>, Spanning>>::takes(capacity));
static_assert(!Renderer<FlatTraits<>>::takes({.width = 0}));
static_assert(!Renderer<FlatTraits<Rgb565, Spanning>>::takes({.awake = ~0u}));

TEST(Refusals, EveryOneHasANameOfItsOwn) {
  std::set<std::string> faults, shaders;
  for (int i = 0; i <= static_cast<int>(Fault::bad_order); ++i) faults.insert(to_string(static_cast<Fault>(i)));
  for (int i = 0; i <= static_cast<int>(MissingShader::mixture); ++i)
    shaders.insert(to_string(static_cast<MissingShader>(i)));
  EXPECT_EQ(faults.size(), static_cast<std::size_t>(Fault::bad_order) + 1);
  EXPECT_EQ(shaders.size(), static_cast<std::size_t>(MissingShader::mixture) + 1);
}

}  // namespace
}  // namespace spanline::test
