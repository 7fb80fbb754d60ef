// Materials at the ends of what is valid, by every shader: refuses arithmetic that overflows (under sanitizers), and
// words that bands and spans read differently.
#include <gtest/gtest.h>

#include <vector>

#include "shade/shading_scene.hpp"
#include "support/effort.hpp"
#include "support/random_texture.hpp"

namespace spanline::test {
namespace {

using ByBuffer = GeneralSeeThroughTraits<Rgb565, Depth24<>>;
using BySpans = GeneralSeeThroughTraits<Rgb565, Depth24<>, Spanning>;

/// A number of 16.16 whose whole part is below 2,048: an end of the range, or any size of number.
Q16_16 extreme(Random& random) {
  constexpr std::int64_t most = (std::int64_t{2048} << 16) - 1;
  if (random.chance(3)) return Q16_16::from_raw(static_cast<std::int32_t>(random.chance(2) ? most : -most));
  const auto reach = static_cast<std::int64_t>(std::exp2(random.real(0, 27)));
  return Q16_16::from_raw(static_cast<std::int32_t>(random.wide(-reach, reach)));
}

/// What a random material refers to.
struct ExtremeMaterial {
  OwnTexture texture;
  std::vector<std::uint8_t> heights, cells;
  std::vector<std::uint16_t> palette;
  HeightMap map;
  VolumeTexture solid;
  Material material;

  ExtremeMaterial(Random& random, TexelFormat format, unsigned log2_width, unsigned log2_height)
      : texture(random, format, log2_width, log2_height, random.chance(2)) {
    texture.texture.wrap_s = random.chance(2) ? Wrap::repeat : Wrap::clamp;
    texture.texture.wrap_t = random.chance(2) ? Wrap::repeat : Wrap::clamp;
    material.colour = random_colour(random);
    material.shading = random.chance(2) ? ShadingMode::flat : ShadingMode::gouraud;
    material.texture_matrix = {.ss = extreme(random),
                               .st = extreme(random),
                               .s0 = extreme(random),
                               .ts = extreme(random),
                               .tt = extreme(random),
                               .t0 = extreme(random)};
    Texturing& texturing = material.texturing;
    texturing.texture = &texture.texture;
    texturing.function = static_cast<TextureFunction>(random.between(0, 3));
    texturing.filter = static_cast<TextureFilter>(random.between(0, 1));
    texturing.mapping = static_cast<TextureMapping>(random.between(0, 1));
    texturing.mip_mapping = static_cast<MipMapping>(random.between(0, 2));
    texturing.alpha = static_cast<TexelAlpha>(random.between(0, 1));
    texturing.coordinates = static_cast<TextureCoordinates>(random.between(0, 1));
    material.lit = !random.chance(6);
    if (random.chance(3)) material.opacity = static_cast<std::uint8_t>(random.between(1, 254));
    material.transparency = static_cast<Transparency>(random.between(0, 3));
    if (random.chance(3)) {
      material.specular = random_colour(random);
      material.shininess = static_cast<std::uint8_t>(random.between(1, 128));
    }
  }
  void lay_relief(Random& random) {
    map.log2_width = static_cast<std::uint8_t>(random.between(0, 11));
    map.log2_height = static_cast<std::uint8_t>(random.between(0, 11 - map.log2_width));
    for (unsigned i = 0; i < 1u << (map.log2_width + map.log2_height); ++i)
      heights.push_back(random.chance(2) ? 255 : 0);
    map.heights = heights;
    material.relief = {.heights = &map,
                       .kind = static_cast<ReliefKind>(random.between(0, 1)),
                       .depth = Fixed<16>::from_raw(random.chance(2) ? 64 << 16 : random.between(1, 64 << 16)),
                       .turn = Angle::from_degrees(random.between(1, 89))};
    material.texturing = {.texture = random.chance(2) ? &texture.texture : nullptr};
    texture.texture.wrap_s = texture.texture.wrap_t = Wrap::repeat;
  }
  void cut_from_solid(Random& random) {
    solid.log2_size = static_cast<std::uint8_t>(random.between(0, 5));
    for (unsigned i = 0; i < 1u << (3 * solid.log2_size); ++i)
      cells.push_back(static_cast<std::uint8_t>(random.between(0, 255)));
    for (int i = 0; i < 256; ++i) palette.push_back(static_cast<std::uint16_t>(random.between(0, 65535)));
    solid.cells = cells;
    solid.palette = palette;
    material.texturing = {};
    material.volume = {.source = SolidSource::table,
                       .texture = &solid,
                       .scale = extreme(random),
                       .exponent = static_cast<std::int8_t>(random.between(-30, 30)),
                       .origin = {extreme(random), extreme(random), extreme(random)}};
  }
};

/// An instance's pixels in bands of so many lines; none where the list has no shader for the material.
template <class Traits>
std::vector<std::uint16_t> pixels(const ShadedInstance& scene, const Material& material, int lines) {
  const RandomInstance& instance = scene.instance;
  Capacity capacity = mesh_capacity(instance.view.viewport.width, instance.view.viewport.height, 1,
                                    instance.mesh.vertex_count(), instance.mesh.triangle_count());
  capacity.band_lines = static_cast<std::uint16_t>(std::min<int>(lines, capacity.height));
  capacity.active = capacity.awake = capacity.layers = capacity.polygons;
  capacity.fragments = static_cast<std::uint32_t>(capacity.width * capacity.band_lines) * 8;
  Studio<Traits> studio(capacity);
  studio.begin(scene.settings);
  studio.add(instance.mesh, instance.transform, material);
  if (studio.status().fault == Fault::shader_missing) return {};
  auto picture = studio.draw();
  EXPECT_TRUE(studio.status().ok()) << to_string(studio.status().fault) << to_string(studio.status().pool);
  return picture.pixels;
}

/// Draws instances with materials that `change` may turn into others, in bands of all heights and by spans.
template <class Change>
void draw_extremes(std::uint32_t seed, int count, Change change) {
  Random random(seed);
  int drawn = 0;
  for (int i = 0; i < rounds(count); ++i) {
    ShadedInstance scene(random);
    scene.instance.owned.texture_exponent = static_cast<std::int8_t>(random.between(-20, -5));
    scene.instance.mesh = scene.instance.owned.view();
    add_effects(random, scene.settings);
    const int log2_width = random.between(0, 11), log2_height = random.between(0, std::min(11, 12 - log2_width));
    ExtremeMaterial extremes(random, static_cast<TexelFormat>(random.between(0, 4)), static_cast<unsigned>(log2_width),
                             static_cast<unsigned>(log2_height));
    change(random, extremes);
    const auto whole = pixels<ByBuffer>(scene, extremes.material, 4096);
    drawn += !whole.empty();
    EXPECT_EQ(pixels<ByBuffer>(scene, extremes.material, 13), whole);
    EXPECT_EQ(pixels<BySpans>(scene, extremes.material, 16), whole);
    ASSERT_FALSE(::testing::Test::HasFailure()) << "round " << i;
  }
  EXPECT_GT(drawn, rounds(count) / 2);
}

TEST(Extremes, TexturesOfAnySizeAndMatrixDrawTheSameBytes) {
  draw_extremes(95, 600, [](Random&, ExtremeMaterial&) {});
}
TEST(Extremes, ReliefsOfAnyDepthDrawTheSameBytes) {
  draw_extremes(96, 300, [](Random& random, ExtremeMaterial& extremes) { extremes.lay_relief(random); });
}
TEST(Extremes, SolidsOfAnyScaleDrawTheSameBytes) {
  draw_extremes(97, 300, [](Random& random, ExtremeMaterial& extremes) { extremes.cut_from_solid(random); });
}

}  // namespace
}  // namespace spanline::test
