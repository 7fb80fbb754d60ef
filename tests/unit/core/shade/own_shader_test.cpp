// A shader of a program's own, as docs/surfaces.md has the recipe: no file of the library names it.
#include <gtest/gtest.h>
#include <spanline/frame/ready_made_traits.hpp>

#include "support/instance_picture.hpp"
#include "support/random_instance.hpp"

namespace spanline::test {
namespace {

/// Smooth light in two tones, as in drawn cartoons.
template <class Format>
struct ToonShader {
  using Pixel = typename Format::Pixel;
  static constexpr bool interpolates = true;

  struct Source {
    static constexpr bool constant = false;
    std::uint32_t intensity, step;  // 2^32 is full light
    Pixel bright, dark;
    [[nodiscard]] Pixel get() const { return intensity >= 0x8000'0000 ? bright : dark; }
    void forward() { intensity += step; }
    void back() { intensity -= step; }
  };

  struct Surface {
    LinearFunction intensity;
    Pixel bright, dark;
    void next_row() { intensity.next_row(); }
    void skip_rows(std::int32_t rows) { intensity.skip_rows(rows); }
    [[nodiscard]] Source source(std::int32_t column) const {
      return {intensity.at(column), intensity.dx, bright, dark};
    }
  };

  template <class Needs>
  [[nodiscard]] static constexpr bool draws(const Material& material, const Needs& needs) {
    return material.shading == ShadingMode::gouraud && !needs.vertex_colours && !needs.textured && !needs.effects &&
           !needs.local_light && !needs.relief && !needs.volume;
  }

  template <class Gradients>
  static void make(Surface& surface, const ShadingGroup& group, const Gradients& gradients) {
    surface.bright = Format::lit(group.colour, 65535);
    surface.dark = Format::lit(group.colour, 32768);
    gradients.fit(
        [&](const ScreenVertex* v) { return static_cast<std::int32_t>(group.vertex_shades[gradients.index(v)]); },
        surface.intensity);
  }
};

/// Smooth light is made of vertices where the list has a shader that interpolates it, which comes behind.
using OwnShaders = ShaderList<ToonShader<Rgb565>, GouraudShader<Rgb565>, FlatShader<Rgb565>>;
using ByBuffer = RendererTraits<Rgb565, OwnShaders, Depth24<>>;
using BySpans = RendererTraits<Rgb565, OwnShaders, Depth24<>, Spanning>;

struct LitInstance {
  RandomInstance instance;
  FrameSettings settings;
  DirectionalLight light{{{}, {}, Q2_30::from_int(1)}, Fixed<16>::from_int(1)};

  explicit LitInstance(Random& random)
      : instance(random, {.closest = 0.5, .farthest = 6, .range_around = false, .vertices = 12}) {
    for (std::size_t i = 0; i < instance.mesh.vertex_count(); ++i) {
      const auto any = [&] { return random.between(-295, 295); };
      const int x = any(), y = any();
      instance.owned.vertex_normals.push_back({x, y, any()});
    }
    instance.mesh = instance.owned.view();
    settings.camera = instance.view.camera;
    settings.cull = Cull::none;
    settings.lighting = {Fixed<16>::from_ratio(1, 4), {&light, 1}, {}};
  }
};

TEST(OwnShader, DrawsWhatItSaysInBandsAndSpans) {
  const Material material{.shading = ShadingMode::gouraud};
  Random random(1);
  int bright = 0, dark = 0;
  for (int i = 0; i < 20; ++i) {
    const LitInstance lit(random);
    expect_alike_in_bands_and_spans<ByBuffer, BySpans>(lit.instance, lit.settings, material);

    // On white the ramp of smooth light is a level of green each: its upper half is bright.
    const auto smooth = instance_pixels<GouraudTraits<Rgb565, Depth24<>>>(lit.instance, lit.settings, material, 16);
    const auto toon = instance_pixels<ByBuffer>(lit.instance, lit.settings, material, 16);
    for (std::size_t at = 0; at < smooth.size(); ++at) {
      const bool is_bright = ((smooth[at] >> 5) & 63) >= 32;
      ASSERT_EQ(toon[at] == 0xffff, is_bright) << at;
      ++(is_bright ? bright : dark);
    }
  }
  EXPECT_GT(bright, 1000);
  EXPECT_GT(dark, 1000);
}

TEST(OwnShader, LeavesOtherMaterialsToTheRestOfTheList) {
  Random random(2);
  const LitInstance lit(random);
  const Material flat{.colour = {250, 200, 90}};
  EXPECT_EQ(instance_pixels<ByBuffer>(lit.instance, lit.settings, flat, 16),
            (instance_pixels<FlatTraits<Rgb565, Depth24<>>>(lit.instance, lit.settings, flat, 16)));
}

}  // namespace
}  // namespace spanline::test
