// Deferred shading by an item buffer: the same bytes as shading at once, and each pixel shaded once.
#include "spanline/visibility/zbuffer/deferred.hpp"
#include "spanline/frame/ready_made_traits.hpp"
#include "spanline/model/cull.hpp"
#include "spanline/raster/link.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "scenes/screen_soups.hpp"
#include "support/effort.hpp"
#include "support/instance_picture.hpp"
#include "support/random_texture.hpp"
#include "support/triangle_kinds.hpp"

namespace spanline::test {
namespace {

TEST(Deferred, OwnersAreThoseOfTheZBuffer) {
  constexpr std::size_t count = 80;
  constexpr int width = 97, height = 61;
  for (std::size_t kind = 0; kind < all_triangle_kinds.size(); ++kind)
    for (int i = 0; i < rounds(6); ++i) {
      TriangleMaker make(static_cast<std::uint32_t>(kind) * 100 + static_cast<std::uint32_t>(i), width, height,
                         Depth24<>::nearest, Depth24<>::farthest);
      std::vector<Corners> soup;
      for (std::size_t t = 0; t < count; ++t) soup.push_back(make(all_triangle_kinds[t % 2 == 0 ? kind : t % 5]));
      Studio<IdTraits<Depth24<>>> plain(screen_capacity(width, height, count));
      const auto want = plain.draw_screen(soup);
      for (const int lines : {0, 1, 7}) {
        Studio<IdTraits<Depth24<>, Counted, Deferred<4>>> deferred(screen_capacity(width, height, count, lines));
        const auto got = deferred.draw_screen(soup);
        ASSERT_TRUE(deferred.status().ok());
        ASSERT_EQ(got.pixels, want.pixels) << "kind " << kind << ", round " << i << ", bands of " << lines;
        ASSERT_EQ(got.depth, want.depth) << "kind " << kind << ", round " << i << ", bands of " << lines;
        EXPECT_EQ(deferred.statistics().visibility.named("shaded"), std::uint64_t{width} * height);
      }
    }
}

TEST(Deferred, SurfacesOfAllKindsAndTheirHolesAreTheSameBytes) {
  Random random(81);
  for (int i = 0; i < rounds(40); ++i) {
    OwnTexture own(random, random.chance(2) ? TexelFormat::rgb565 : TexelFormat::rgb565_cutout, 3, 4);
    RandomInstance::Wish wish{.closest = 0.5, .farthest = 6, .range_around = false, .vertices = 20};
    RandomInstance instance(random, wish);
    add_texture_coordinates(random, instance.owned);
    instance.mesh = instance.owned.view();
    FrameSettings settings;
    settings.camera = instance.view.camera;
    settings.cull = Cull::none;
    settings.dither = random.chance(3);
    Material material{.colour = {200, 100, 50}};
    if (random.chance(2)) material.shading = ShadingMode::gouraud;
    if (!random.chance(3)) material.texturing.texture = &own.texture;
    if (random.chance(2)) material.texturing.filter = TextureFilter::bilinear;
    using AtOnce = GeneralTraits<Rgb565, Depth16<>>;
    using Later = GeneralTraits<Rgb565, Depth16<>, Deferred<8>>;
    const auto want = instance_pixels<AtOnce>(instance, settings, material, 4096);
    for (const int lines : {4096, 5})
      ASSERT_EQ(instance_pixels<Later>(instance, settings, material, lines), want) << "round " << i;
  }
}

TEST(Deferred, PeaksCountTheItemBuffer) {
  Studio<FlatTraits<Rgb565, Depth16<>, Deferred<>>> studio(screen_capacity(64, 32, 1, 8));
  const std::vector<Corners> triangle{{Corner{0, 0, 100}, {512, 0, 100}, {0, 512, 100}}};
  (void)studio.draw_screen(triangle);
  EXPECT_EQ(studio.renderer().peaks().depth_band, 64u * 8 * (sizeof(Link) + sizeof(Depth16<>::Word)));
}

}  // namespace
}  // namespace spanline::test
