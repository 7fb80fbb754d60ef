// Opacity that varies over a polygon, by its vertices and by its texels, against formulas in floating point.
#include "spanline/shade/layer/translucent.hpp"
#include "spanline/frame/ready_made_traits.hpp"
#include "spanline/model/cull.hpp"

#include <cmath>

#include "shade/shading_scene.hpp"
#include "shade/wall_picture.hpp"
#include "spanline/model/texel_reader.hpp"
#include "support/effort.hpp"

namespace spanline::test {
namespace {

template <class Visibility>
using Translucents =
    RendererTraits<Rgb565,
                   ShaderList<FlatShader<Rgb565>, SeeThroughShader<Rgb565, FlatShader<Rgb565>>, GeneralShader<Rgb565>,
                              SeeThroughShader<Rgb565, TranslucentShader<Rgb565>>>,
                   Depth24<>, Visibility>;

/// What is drawn by both kinds of algorithm, with a band height each; the same bytes.
template <class Submit>
Picture<Translucents<ZBuffer>> drawn(Capacity capacity, Submit submit) {
  capacity.fragments = 2u * capacity.width * capacity.height;
  capacity.active = capacity.awake = capacity.polygons;
  const auto draw = [&]<class Traits>(int lines, Traits*) {
    capacity.band_lines = static_cast<std::uint16_t>(std::min<int>(lines, capacity.height));
    if constexpr (std::is_same_v<typename Traits::Visibility, Spanning>) capacity.layers = capacity.polygons;
    Studio<Traits> studio(capacity);
    submit(studio);
    auto picture = studio.draw();
    EXPECT_TRUE(studio.status().ok()) << to_string(studio.status().fault) << to_string(studio.status().pool);
    return picture;
  };
  auto picture = draw(4096, static_cast<Translucents<ZBuffer>*>(nullptr));
  EXPECT_EQ(draw(7, static_cast<Translucents<ZBuffer>*>(nullptr)).pixels, picture.pixels);
  EXPECT_EQ(draw(16, static_cast<Translucents<Spanning>*>(nullptr)).pixels, picture.pixels);
  return picture;
}

/// A function that is linear over the screen, by its values at a triangle's corners.
double interpolated(const Corners& t, const std::array<std::uint8_t, 3>& values, double x, double y) {
  const double x1 = t[1].x - t[0].x, y1 = t[1].y - t[0].y, x2 = t[2].x - t[0].x, y2 = t[2].y - t[0].y;
  const double area = x1 * y2 - x2 * y1, px = x - t[0].x, py = y - t[0].y;
  const double b = (px * y2 - x2 * py) / area, c = (x1 * py - px * y1) / area;
  return values[0] + b * (values[1] - values[0]) + c * (values[2] - values[0]);
}

TEST(Translucent, OpacityRunsLinearlyBetweenTheVertices) {
  Random random(71);
  for (int i = 0; i < rounds(60); ++i) {
    ShadedTriangle triangle(random);
    std::array<std::uint8_t, 3> opacities{};
    for (std::uint8_t& o : opacities) o = static_cast<std::uint8_t>(random.between(0, 255));
    triangle.owned.vertex_opacities.assign(opacities.begin(), opacities.end());
    triangle.settings.background = random_colour(random);
    const Material material{.colour = random_colour(random),
                            .opacity = static_cast<std::uint8_t>(random.between(1, 255))};
    const Mesh mesh = triangle.owned.view();
    const auto picture = drawn(mesh_capacity(64, 64, 1, 3, 1), [&](auto& studio) {
      studio.begin(triangle.settings);
      studio.add(mesh, triangle.transform, material);
    });
    const ExactTriangle exact(triangle.corners);
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) {
        double alpha = 0;
        if (exact.covers(x, y))
          alpha = interpolated(triangle.corners, opacities, 16 * x + 8, 16 * y + 8) / 255 * material.opacity / 255;
        const double wanted =
            (material.colour.green * alpha + triangle.settings.background.green * (1 - alpha)) / 255 * 63;
        // The material's α is rounded to 32nds and so is the product; the layer, the pixel below it, and the sum.
        const double contrast = std::abs(material.colour.green - triangle.settings.background.green) / 255.0 * 63;
        ASSERT_NEAR(Channels(picture.pixels[picture.at(x, y)]).green, wanted, contrast / 31 + 1.2) << x << ", " << y;
      }
  }
}

TEST(Translucent, OpacityThatIsTheSameAtAllVerticesIsThatOfTheMaterial) {
  Random random(72);
  for (int i = 0; i < rounds(60); ++i) {
    ShadedTriangle triangle(random);
    const auto opacity = static_cast<std::uint8_t>(random.between(0, 254));
    triangle.settings.background = random_colour(random);
    const auto transparency = static_cast<Transparency>(random.between(0, 3));
    const auto picture_of = [&](std::uint8_t of_vertices, std::uint8_t of_material) {
      triangle.owned.vertex_opacities.clear();
      if (of_vertices != 255) triangle.owned.vertex_opacities.assign(3, of_vertices);
      const Mesh mesh = triangle.owned.view();
      return drawn(mesh_capacity(64, 64, 1, 3, 1), [&](auto& studio) {
        studio.begin(triangle.settings);
        studio.add(mesh, triangle.transform,
                   {.colour = {255, 255, 255}, .opacity = of_material, .transparency = transparency});
      });
    };
    ASSERT_EQ(picture_of(opacity, 255).pixels, picture_of(255, opacity).pixels)
        << int{opacity} << " by method " << static_cast<int>(transparency);
  }
}

TEST(Translucent, TexelsBlendByTheirAlpha) {
  Random random(73);
  OwnTexture own(random, TexelFormat::argb4444, 4, 3);
  FrameSettings settings = scenes::textured_wall::settings();
  settings.background = {40, 200, 90};
  const int below = 49;  // 200 of 255 in 63rds
  for (const std::uint8_t opacity : {std::uint8_t{255}, std::uint8_t{130}}) {
    const Material material{
        .texturing = {.texture = &own.texture, .function = TextureFunction::replace, .alpha = TexelAlpha::blend},
        .opacity = opacity};
    const auto picture = drawn(wall_capacity, [&](auto& studio) {
      studio.begin(settings);
      studio.add(scenes::textured_wall::mesh, {}, material);
    });
    int wrong = 0;
    for (int y = 0; y < 240; ++y)
      for (int x = 0; x < 320; ++x) {
        const auto [s, t] = wall_point(x, y);
        const int column = static_cast<int>(std::floor(s * 16)) & 15, row = static_cast<int>(std::floor(t * 8)) & 7;
        const Texel texel =
            read_texel(own.texture, static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row));
        const long alpha = std::lround(std::round(opacity * 32 / 255.0) * texel.alpha / 15);
        const long wanted = (Channels(texel.rgb565).green * alpha + below * (32 - alpha) + 16) / 32;
        wrong += Channels(picture.pixels[picture.at(x, y)]).green != wanted;
      }
    EXPECT_LE(wrong, 76800 * 3 / 1000);
  }
}

TEST(Translucent, BilinearTexelsBlendWithoutTheColourOfTexelsThatAreNotThere) {
  // Opaque white beside black that is not there: whatever lies between is white.
  OwnTexture own;
  own.texture = {.format = TexelFormat::argb4444, .log2_width = 1, .log2_height = 0};
  own.words = {0xffff, 0x0000};
  own.texture.words = own.words;
  FrameSettings settings = scenes::textured_wall::settings();
  settings.background = {255, 255, 255};
  const Material material{.texturing = {.texture = &own.texture,
                                        .function = TextureFunction::replace,
                                        .filter = TextureFilter::bilinear,
                                        .alpha = TexelAlpha::blend}};
  const auto submit = [&](auto& studio) {
    studio.begin(settings);
    studio.add(scenes::textured_wall::mesh, {}, material);
  };
  for (const std::uint16_t pixel : drawn(wall_capacity, submit).pixels) ASSERT_EQ(pixel, 0xffff);
  settings.background = {0, 0, 0};
  const auto over_black = drawn(wall_capacity, submit);
  for (int x = 0; x < 320; ++x) {
    const double s = wall_point(x, 120)[0] * 2 - 0.5, part = s - std::floor(s);
    const double alpha = (static_cast<int>(std::floor(s)) & 1) == 0 ? 1 - part : part;
    ASSERT_NEAR(Channels(over_black.pixels[over_black.at(x, 120)]).green / 63.0, alpha, 0.03) << x;
  }
}

TEST(Translucent, PatternsOfOpacityThatVariesHoldTheShareOfEachPlace) {
  // A strip whose opacity goes from 0 on the left to full on the right, 256 pixels away.
  OwnedMesh owned;
  owned.step_exponent = 0;
  owned.vertices = {{0, 0, 0}, {256, 0, 0}, {256, -128, 0}, {0, -128, 0}};
  owned.triangle(0, 2, 1);
  owned.triangle(0, 3, 2);
  owned.fit_bounds();
  owned.vertex_opacities = {0, 255, 255, 0};
  FrameSettings settings;
  settings.camera.projection = Projection::orthographic;
  settings.camera.focal = Q16_16::from_int(1);
  settings.camera.near_plane = Q16_16::from_int(1);
  settings.camera.far_plane = Q16_16::from_int(1000);
  settings.cull = Cull::none;
  Transform transform;
  transform.translation = {Q16_16::from_int(-128), Q16_16::from_int(64), Q16_16::from_int(-100)};
  const Mesh mesh = owned.view();
  for (const Transparency transparency : {Transparency::screen_door, Transparency::stochastic}) {
    const auto picture = drawn(mesh_capacity(256, 128, 1, 4, 2), [&](auto& studio) {
      studio.begin(settings);
      studio.add(mesh, transform, {.colour = {255, 255, 255}, .transparency = transparency});
    });
    for (int x = 0; x < 256; x += 8) {
      int there = 0;
      for (int y = 0; y < 128; ++y)
        for (int i = 0; i < 8; ++i) there += picture.pixels[picture.at(x + i, y)] != 0;
      // Ordered patterns hold their share but for the slope inside 8 columns; random ones by the law of large numbers.
      const double allowed = transparency == Transparency::screen_door ? 0.02 : 0.07;
      EXPECT_NEAR(there / 1024.0, (x + 4) / 256.0, allowed) << x;
    }
  }
}

TEST(Translucent, ClippedPolygonsAndCutOutsAreDrawnAlikeByAllAlgorithms) {
  Random random(74);
  for (int i = 0; i < rounds(30); ++i) {
    OwnTexture own(random, random.chance(2) ? TexelFormat::argb4444 : TexelFormat::rgb565_cutout, 3, 3);
    RandomInstance::Wish wish{.closest = 0.5, .farthest = 6, .range_around = false, .vertices = 12};
    RandomInstance instance(random, wish);
    add_texture_coordinates(random, instance.owned);
    for (int v = 0; v < wish.vertices; ++v)
      instance.owned.vertex_opacities.push_back(static_cast<std::uint8_t>(random.between(0, 255)));
    if (random.chance(3)) instance.owned.vertex_opacities.clear();
    instance.mesh = instance.owned.view();
    Material material{.colour = random_colour(random)};
    material.transparency = static_cast<Transparency>(random.between(0, 3));
    if (random.chance(2)) material.shading = ShadingMode::gouraud;
    if (random.chance(2)) material.texturing.filter = TextureFilter::bilinear;
    if (random.chance(2)) material.texturing.alpha = TexelAlpha::blend;
    material.texturing.texture = &own.texture;
    FrameSettings settings;
    settings.camera = instance.view.camera;
    settings.cull = Cull::none;
    settings.dither = random.chance(2);
    Capacity capacity = mesh_capacity(instance.view.viewport.width, instance.view.viewport.height, 1,
                                      instance.mesh.vertex_count(), instance.mesh.triangle_count());
    const auto picture = drawn(capacity, [&](auto& studio) {
      studio.begin(settings);
      studio.add(instance.mesh, instance.transform, material);
    });
    ASSERT_FALSE(HasFailure()) << "round " << i;
  }
}

TEST(Translucent, OtherListsRefuseOpacityThatVaries) {
  Random random(75);
  ShadedTriangle triangle(random);
  triangle.owned.vertex_opacities.assign(3, 128);
  const Mesh mesh = triangle.owned.view();
  Studio<SeeThroughTraits<>> studio(mesh_capacity(64, 64, 1, 3, 1));
  studio.begin(triangle.settings);
  studio.add(mesh, triangle.transform, {});
  EXPECT_EQ(studio.status().fault, Fault::shader_missing);
}

}  // namespace
}  // namespace spanline::test
