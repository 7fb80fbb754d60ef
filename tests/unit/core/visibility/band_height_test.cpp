// zbuffer (one band) and scanline-z (any other height) draw the same bytes: colours, depths and ids (promise 3).
#include <gtest/gtest.h>
#include <spanline/frame/ready_made_traits.hpp>
#include <spanline/model/cull.hpp>

#include <bunny.hpp>
#include <teapot.hpp>
#include <vector>

#include "scenes/model_view.hpp"
#include "support/effort.hpp"
#include "support/ready_made_studios.hpp"
#include "support/triangle_kinds.hpp"

namespace spanline::test {
namespace {

constexpr int band_heights[] = {1, 2, 7, 16, 100, 239};
constexpr int width = 320, height = 240;

template <class Traits>
class BandHeights : public ::testing::Test {};

using Depths = ::testing::Types<Depth16<>, Depth16<DepthSense::larger_is_nearer>, Depth24<>,
                                Depth24<DepthSense::larger_is_nearer>>;
TYPED_TEST_SUITE(BandHeights, Depths);

/// Draws by `fill` with the full frame and every band height, in colours and in ids.
template <class Depth, class Fill>
void expect_same_bytes(Capacity capacity, Fill fill) {
  const auto compare = [&]<class Traits>(const char* what) {
    capacity.band_lines = capacity.height;
    Studio<Traits> full(capacity);
    fill(full);
    const auto want = full.draw();
    ASSERT_TRUE(full.status().ok()) << to_string(full.status().pool);
    ASSERT_GT(want.drawn_count(), 0U);
    for (const int lines : band_heights) {
      capacity.band_lines = static_cast<std::uint16_t>(lines);
      Studio<Traits> banded(capacity);
      fill(banded);
      const auto got = banded.draw();
      ASSERT_TRUE(banded.status().ok()) << to_string(banded.status().pool);
      EXPECT_TRUE(got.pixels == want.pixels) << what << " in bands of " << lines;
      EXPECT_TRUE(got.depth == want.depth) << "depths in bands of " << lines;
    }
  };
  compare.template operator()<GouraudTraits<Rgb565, Depth>>("colours");
  compare.template operator()<IdTraits<Depth>>("ids");
}

template <class Depth>
void check_soup(TriangleKind kind, std::uint32_t seed, std::size_t count, bool tied) {
  TriangleMaker make(seed, width, height, Depth::nearest, Depth::farthest);
  std::vector<Corners> soup;
  for (std::size_t i = 0; i < count; ++i) soup.push_back(make(kind));
  if (tied)
    for (Corners& t : soup)
      for (Corner& c : t) c.z = 1000;
  const auto vertices = vertices_of(soup, Depth::bits, width, height);
  std::vector<std::uint16_t> colours(count);
  for (std::size_t i = 0; i < count; ++i) colours[i] = static_cast<std::uint16_t>(i + 1);
  Capacity capacity = screen_capacity(width, height, count);
  capacity.active = capacity.awake = static_cast<std::uint32_t>(count);
  FrameSettings settings;
  settings.cull = Cull::none;
  expect_same_bytes<Depth>(capacity, [&](auto& studio) {
    studio.begin(settings);
    studio.add_screen(vertices, colours);
  });
}

TYPED_TEST(BandHeights, DrawTheSameBytesOfEveryKindOfSoup) {
  std::uint32_t seed = 50;
  for (const TriangleKind kind : all_triangle_kinds)
    for (int i = 0; i < rounds(2); ++i) {
      SCOPED_TRACE(name_of(kind));
      check_soup<TypeParam>(kind, ++seed, kind <= TriangleKind::medium ? 400 : 60, false);
    }
}

TYPED_TEST(BandHeights, DrawTheSameBytesWhereAllDepthsAreEqual) {
  for (const TriangleKind kind : {TriangleKind::tiny, TriangleKind::screen, TriangleKind::giant})
    check_soup<TypeParam>(kind, 90, 120, true);
}

TYPED_TEST(BandHeights, DrawTheSameBytesOfRealModels) {
  for (const Mesh* mesh : {&spanline_models::bunny, &spanline_models::teapot})
    for (const ShadingMode shading : {ShadingMode::flat, ShadingMode::gouraud}) {
      const auto view = scenes::model_view(*mesh, Angle::from_degrees(33), height, shading);
      Capacity capacity;
      capacity.colour_bands = 1;
      capacity.vertices = capacity.shades = static_cast<std::uint32_t>(mesh->vertex_count());
      capacity.polygons = capacity.fans = capacity.active = capacity.awake =
          static_cast<std::uint32_t>(mesh->triangle_count());
      expect_same_bytes<TypeParam>(capacity, [&](auto& studio) {
        studio.begin(view.settings);
        studio.add(*mesh, view.transform, view.material);
      });
    }
}

}  // namespace
}  // namespace spanline::test
