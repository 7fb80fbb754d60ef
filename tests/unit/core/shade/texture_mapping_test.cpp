// Texture coordinates against similar triangles in floating point: which texel a pixel shows.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "scenes/textured_wall.hpp"
#include "spanline/frame/ready_made_traits.hpp"
#include "spanline/geometry/instance.hpp"
#include "spanline/model/cull.hpp"
#include "spanline/raster/surface_blocks.hpp"
#include "support/effort.hpp"
#include "support/exact_triangle.hpp"
#include "support/exact_view.hpp"
#include "support/ids_picture.hpp"
#include "support/random_instance.hpp"

namespace spanline::test {
namespace {

/// A texture of 2^w × 2^h texels, each with its own number.
struct Numbered {
  std::vector<std::uint16_t> words;
  Texture texture;
  Numbered(unsigned log2_width, unsigned log2_height) : words(std::size_t{1} << (log2_width + log2_height)) {
    for (std::size_t i = 0; i < words.size(); ++i) words[i] = static_cast<std::uint16_t>(i);
    texture.log2_width = static_cast<std::uint8_t>(log2_width);
    texture.log2_height = static_cast<std::uint8_t>(log2_height);
    texture.words = words;
  }
  [[nodiscard]] Material material() const {
    Material material;
    material.texturing = {.texture = &texture, .function = TextureFunction::replace};
    return material;
  }
  /// How far a pixel's texel is from these coordinates of the whole texture: 0 for the right one.
  [[nodiscard]] double distance(std::uint16_t pixel, double s, double t) const {
    const unsigned width = 1u << texture.log2_width, height = 1u << texture.log2_height;
    return std::max(beyond(pixel % width, s * width, width), beyond(pixel / width, t * height, height));
  }

 private:
  /// From the interval [texel, texel + 1) of a circle of `size` texels.
  static double beyond(unsigned texel, double coordinate, unsigned size) {
    const double ahead = coordinate - texel - std::floor((coordinate - texel) / size) * size;  // [0, size)
    return ahead < 1 ? 0 : std::min(ahead - 1, size - ahead);
  }
};

TEST(TextureMapping, TheWallShowsTheWrongTexelAtThreeInAThousandPixelsAtMost) {
  const Numbered numbered(6, 6);
  const Capacity capacity{.band_lines = 240, .colour_bands = 1, .vertices = 4, .textures = 4, .polygons = 2};
  Studio<TextureTraits<>> studio(capacity);
  studio.begin(scenes::textured_wall::settings());
  studio.add(scenes::textured_wall::mesh, {}, numbered.material());
  const auto picture = studio.draw();
  ASSERT_TRUE(studio.status().ok());
  int wrong = 0;
  for (int y = 0; y < 240; ++y)
    for (int x = 0; x < 320; ++x) {
      // The wall goes from z = 2 to 6 while x goes from −1 to 3; s goes with z, and t from ⅓ … ⅔ to 0 … 1.
      const double ray_x = (x + 0.5 - 160) / 320, ray_y = (120 - (y + 0.5)) / 320;
      const double z = 3 / (1 - ray_x), s = (z - 2) / 4;
      const double t = 0.5 - (1.0 / 6 + s / 3) * ray_y * z / (0.375 * z);
      const double off = numbered.distance(picture.pixels[picture.at(x, y)], s, t);
      wrong += off > 0;
      ASSERT_LT(off, 0.05) << "at " << x << ", " << y;
    }
  std::printf("%d of 76800 pixels show a neighbouring texel\n", wrong);
  EXPECT_LE(wrong, 76800 * 3 / 1000);
}

/// A textured triangle before a camera, and what each of its pixels should show.
struct TexturedTriangle {
  RandomInstance random;
  FrameSettings settings;

  TexturedTriangle(Random& source, const RandomInstance::Wish& wish) : random(source, wish) {
    OwnedMesh& owned = random.owned;
    const int reach = 1 << source.between(8, 15);
    for (int i = 0; i < wish.vertices; ++i)
      owned.texture_coordinates.push_back({static_cast<std::int16_t>(source.between(-reach, reach - 1)),
                                           static_cast<std::int16_t>(source.between(-reach, reach - 1))});
    random.mesh = owned.view();
    settings.camera = random.view.camera;
    settings.cull = Cull::none;
  }

  template <class Traits>
  [[nodiscard]] Picture<Traits> draw(const Material& material, int band_lines = 0) const {
    Capacity capacity = mesh_capacity(random.view.viewport.width, random.view.viewport.height, 1,
                                      random.mesh.vertex_count(), random.mesh.triangle_count());
    if (band_lines != 0) capacity.band_lines = static_cast<std::uint16_t>(std::min<int>(band_lines, capacity.height));
    capacity.active = capacity.awake = capacity.polygons;
    Studio<Traits> studio(capacity);
    studio.begin(settings);
    studio.add(random.mesh, random.transform, material);
    auto picture = studio.draw();
    EXPECT_TRUE(studio.status().ok()) << to_string(studio.status().fault) << to_string(studio.status().pool);
    return picture;
  }
};

TEST(TextureMapping, PixelsShowTheTexelThatPerspectiveAsksFor) {
  Random source(31);
  long pixels = 0, wrong = 0;
  double worst = 0;
  for (int i = 0; i < rounds(2000); ++i) {
    RandomInstance::Wish wish{.closest = 1.1, .farthest = 8, .vertices = 3, .depth_bits = 16};
    wish.orthographic = source.chance(8);
    const TexturedTriangle t(source, wish);
    const Numbered numbered(static_cast<unsigned>(source.between(0, 8)), static_cast<unsigned>(source.between(0, 8)));
    const Mesh& mesh = t.random.mesh;
    const InstanceGeometry geometry(t.random.view, mesh, t.random.transform);
    if (geometry.placement() == Placement::outside) continue;
    ScreenVertex screen[3];
    geometry.transform_vertices(screen);
    if (((screen[0].depth_word | screen[1].depth_word | screen[2].depth_word) & outcode_clip) != 0) continue;
    const auto picture = t.draw<TextureTraits<>>(numbered.material());
    // s/z, t/z and 1/z are linear over the triangle as it was snapped to the screen.
    const ExactView exact(t.random.view, mesh, t.random.transform);
    Corners corners{};
    double nearness[3], widest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = {screen[k].x_sixteenths(), screen[k].y_sixteenths(), 0};
      nearness[k] = wish.orthographic ? 1 : static_cast<double>(1 / exact(k).view.z);
      for (const auto& [a, b, log2] :
           {std::tuple{mesh.texture_coordinates[k].s, mesh.texture_coordinates[(k + 1) % 3].s,
                       numbered.texture.log2_width},
            std::tuple{mesh.texture_coordinates[k].t, mesh.texture_coordinates[(k + 1) % 3].t,
                       numbered.texture.log2_height}})
        widest = std::max(widest, std::abs(a - b) * std::exp2(log2 - 14));
    }
    const ExactTriangle covered(corners);
    const double area = static_cast<double>(covered.area());
    // A 1/32 texel of triangles that are drawn affine, and the error of chords over 4 columns: six thousandths of the
    // texels of a block, which reaches beyond a thin triangle.
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k)
      longest =
          std::max(longest, std::hypot(corners[k].x - corners[(k + 1) % 3].x, corners[k].y - corners[(k + 1) % 3].y));
    const double thickness = std::max(1.0, area) / std::max(1.0, longest) / 16;  // pixels
    const double allowed = 0.04 + widest * 0.1 / thickness;
    covered.for_each_pixel(picture.width, picture.height, [&](int x, int y) {
      double w = 0, s = 0, tt = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const Corner &from = corners[(k + 1) % 3], &to = corners[(k + 2) % 3];
        const double weight =
            std::abs(1.0 * (to.x - from.x) * (16 * y + 8 - from.y) - 1.0 * (to.y - from.y) * (16 * x + 8 - from.x)) /
            area * nearness[k];
        w += weight;
        s += weight * mesh.texture_coordinates[k].s;
        tt += weight * mesh.texture_coordinates[k].t;
      }
      const double off = numbered.distance(picture.pixels[picture.at(x, y)], s / w * 0x1p-14, tt / w * 0x1p-14);
      ++pixels;
      wrong += off > 0;
      worst = std::max(worst, off / allowed);
      EXPECT_LE(off, allowed) << "at " << x << ", " << y << " texels across " << widest;
    });
    ASSERT_FALSE(HasFailure()) << "round " << i;
  }
  std::printf("%ld of %ld pixels show a neighbouring texel; worst %.2f of what is allowed\n", wrong, pixels, worst);
  EXPECT_LT(wrong, pixels / 50);
}

TEST(TextureMapping, BandsAndSpansDrawTheSameBytes) {
  Random source(32);
  for (int i = 0; i < rounds(120); ++i) {
    RandomInstance::Wish wish{.closest = 0.5, .farthest = 6, .range_around = false, .vertices = 30};
    wish.orthographic = source.chance(6);
    const TexturedTriangle t(source, wish);
    const Numbered numbered(5, 6);
    Material material = numbered.material();
    if (source.chance(3)) material.texturing.function = TextureFunction::modulate;
    if (source.chance(3)) material.shading = ShadingMode::gouraud;
    if (source.chance(5)) material.texturing.mapping = TextureMapping::affine;
    using ByBuffer = TextureTraits<Rgb565, Depth24<>>;
    using BySpans = TextureTraits<Rgb565, Depth24<>, Spanning>;
    const auto whole = t.draw<ByBuffer>(material);
    for (const int lines : {1, 7, 64}) EXPECT_TRUE(t.draw<ByBuffer>(material, lines) == whole) << lines;
    const auto spans = t.draw<BySpans>(material, 16);
    EXPECT_EQ(spans.pixels, whole.pixels);
    if (i % 3 != 0) continue;
    // Statistics draw piece by piece, and ask at no block whether anything has been drawn there.
    const auto at_16 = t.draw<TextureTraits<>>(material);
    EXPECT_EQ((t.draw<TextureTraits<Rgb565, Depth16<>, Counted>>(material).pixels), at_16.pixels);
    ASSERT_FALSE(HasFailure()) << "round " << i;
  }
}

TEST(TextureMapping, TheMatrixMovesTurnsAndScalesTheTexture) {
  const Numbered numbered(6, 6);
  Material plain = numbered.material(), moved = plain;
  // A quarter turn, twice as dense, a quarter further: s' = −2t + ¼, t' = 2s.
  moved.texture_matrix = {.ss = {},
                          .st = Q16_16::from_int(-2),
                          .s0 = Q16_16::from_ratio(1, 4),
                          .ts = Q16_16::from_int(2),
                          .tt = {},
                          .t0 = {}};
  OwnedMesh quad;
  quad.vertices = {{-4096, -4096, 0}, {4096, -4096, 0}, {4096, 4096, 0}, {-4096, 4096, 0}};
  quad.texture_coordinates = {{0, 16384}, {16384, 16384}, {16384, 0}, {0, 0}};
  quad.triangle(0, 1, 2);
  quad.triangle(0, 2, 3);
  quad.fit_bounds();
  FrameSettings settings;
  settings.camera.projection = Projection::orthographic;
  settings.camera.eye.z = Q16_16::from_int(4);
  settings.camera.focal = Q16_16::from_int(64);
  const auto draw = [&](const Material& material) {
    Studio<TextureTraits<>> studio(mesh_capacity(64, 64, 1, 4, 2));
    const Mesh mesh = quad.view();
    studio.begin(settings);
    studio.add(mesh, {}, material);
    return studio.draw();
  };
  const auto straight = draw(plain), turned = draw(moved);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      ASSERT_EQ(straight.pixels[straight.at(x, y)], y * 64 + x);
      // The centre of the pixel falls on the edge of two texels; either is right.
      const double s = -2 * (y + 0.5) / 64 + 0.25, t = 2 * (x + 0.5) / 64;
      ASSERT_LE(numbered.distance(turned.pixels[turned.at(x, y)], s, t), 0.001) << x << ", " << y;
    }
}

}  // namespace
}  // namespace spanline::test
