// Textures stay where they are: as the camera moves, under affine mapping, and with holes by every algorithm.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "shade/wall_picture.hpp"
#include "spanline/frame/ready_made_traits.hpp"
#include "spanline/geometry/instance.hpp"
#include "spanline/model/cull.hpp"
#include "support/effort.hpp"

namespace spanline::test {
namespace {

namespace scene = scenes::textured_wall;

/// 64 × 64 texels, each with its own number.
struct NumberedSquare {
  std::vector<std::uint16_t> words;
  Texture texture{.log2_width = 6, .log2_height = 6};
  NumberedSquare() : words(64 * 64) {
    for (std::size_t i = 0; i < words.size(); ++i) words[i] = static_cast<std::uint16_t>(i);
    texture.words = words;
  }
  [[nodiscard]] Material material() const {
    return {.texturing = {.texture = &texture, .function = TextureFunction::replace}};
  }
};

/// A camera beside the origin that looks along −z at the wall, which goes through (x, y, −x − 3).
struct Eye {
  double x, y, z;

  /// Texture coordinates of the wall at a point of the screen.
  [[nodiscard]] std::array<double, 2> at(double column, double row) const {
    const double right = (column - 160) / 320, up = (120 - row) / 320, along = (3 + x + z) / (1 - right);
    return {(x + along * right + 1) / 4, 0.5 - (y + along * up) * 2 / 9};
  }
  /// And back.
  [[nodiscard]] std::array<double, 2> on_screen(double s, double t) const {
    const double wall_x = 4 * s - 1, distance = wall_x + 3 + z;
    return {160 + 320 * (wall_x - x) / distance, 120 - 320 * ((0.5 - t) * 4.5 - y) / distance};
  }
};

/// The wall as its corners were snapped to the screen's sixteenths: what a pixel of it should show.
struct SnappedWall {
  double x[4], y[4], nearness[4];

  SnappedWall(const Eye& eye, const FrameSettings& settings) {
    const FrameView view{settings.camera, {320, 240}, 16, Depth16<>::nearest, Depth16<>::farthest};
    ScreenVertex vertices[4];
    InstanceGeometry(view, scene::mesh, {}).transform_vertices(vertices);
    for (std::size_t i = 0; i < 4; ++i) {
      x[i] = vertices[i].x_sixteenths() / 16.0;
      y[i] = vertices[i].y_sixteenths() / 16.0;
      nearness[i] = 1 / (eye.z - scene::vertices[i].z / 4.0);
    }
  }
  /// Texture coordinates at a point inside.
  [[nodiscard]] std::array<double, 2> at(double px, double py) const {
    std::array<double, 2> best{};
    double deepest = -1e9;
    for (const auto& corners : {std::array{0u, 2u, 1u}, std::array{0u, 3u, 2u}}) {
      const auto cross = [&](unsigned i, unsigned j) {
        return (x[j] - x[i]) * (py - y[i]) - (y[j] - y[i]) * (px - x[i]);
      };
      const auto [a, b, c] = corners;
      const double at_a = cross(b, c), at_b = cross(c, a), at_c = cross(a, b), area = at_a + at_b + at_c;
      const double inside = std::min({at_a / area, at_b / area, at_c / area});
      if (inside <= deepest) continue;
      deepest = inside;
      double w = 0, s = 0, t = 0;
      for (const auto& [corner, weight] : {std::pair{a, at_a}, std::pair{b, at_b}, std::pair{c, at_c}}) {
        w += weight * nearness[corner];
        s += weight * nearness[corner] * scene::coordinates[corner].s / 16384;
        t += weight * nearness[corner] * scene::coordinates[corner].t / 16384;
      }
      best = {s / w, t / w};
    }
    return best;
  }
};

TEST(TexturesStay, PointsOfASurfaceKeepTheirTexelsAsTheCameraMoves) {
  const NumberedSquare numbered;
  long points = 0, lost = 0, wrong = 0, seen = 0;
  double farthest = 0;
  for (int step = 0; step < 24; ++step) {
    const std::int64_t x = step * 11 - 128, y = 64 - step * 5, z = step * 7 - 96;  // 512ths
    const Eye eye{static_cast<double>(x) / 512, static_cast<double>(y) / 512, static_cast<double>(z) / 512};
    FrameSettings settings = scene::settings();
    settings.camera.eye = {Q16_16::from_ratio(x, 512), Q16_16::from_ratio(y, 512), Q16_16::from_ratio(z, 512)};
    const auto picture = wall<TextureTraits<>>(numbered.material(), settings);
    const auto shown = [&](int column, int row) { return picture.pixels[picture.at(column, row)]; };
    const SnappedWall snapped(eye, settings);
    for (int row = 0; row < 240; ++row)
      for (int column = 0; column < 320; ++column) {
        if (!picture.drawn(column, row)) continue;
        ++seen;
        const auto [s, t] = snapped.at(column + 0.5, row + 0.5);
        const int texel = shown(column, row);
        const auto off = [](double coordinate, int of) {
          return std::max({0.0, of - coordinate, coordinate - (of + 1)});
        };
        const double distance = std::max(off(s * 64, texel % 64), off(t * 64, texel / 64));
        wrong += distance > 0;
        farthest = std::max(farthest, distance);
      }
    // Centres of texels, at the pixels that they fall on where those belong to the texel.
    for (int row = 0; row < 64; ++row)
      for (int column = 0; column < 64; ++column) {
        const double s = (column + 0.5) / 64, t = (row + 0.5) / 64;
        if (std::abs(t - 0.5) > (1.0 / 6 + s / 3) * 0.95) continue;  // beside the wall
        const auto [at_x, at_y] = eye.on_screen(s, t);
        if (at_x < 0 || at_y < 0 || at_x >= 320 || at_y >= 240) continue;
        const int pixel_x = static_cast<int>(at_x), pixel_y = static_cast<int>(at_y);
        const auto pixel = eye.at(pixel_x + 0.5, pixel_y + 0.5);
        // A third of a texel from its centre: corners are a sixteenth of a pixel off.
        if (std::max(std::abs(pixel[0] - s), std::abs(pixel[1] - t)) * 64 > 0.33) continue;
        ++points;
        lost += shown(pixel_x, pixel_y) != row * 64 + column;
      }
  }
  std::printf("%ld of %ld pixels show a neighbouring texel, %.4f texels off at most; %ld of %ld points lost theirs\n",
              wrong, seen, farthest, lost, points);
  EXPECT_GT(seen, 24 * 40000);
  // A column of this wall has one s, so that all of it may be wrong at once: the bound is for the frames together.
  EXPECT_LE(wrong, seen * 3 / 1000);
  EXPECT_LE(farthest, 0.01);
  EXPECT_GT(points, 20000);
  EXPECT_EQ(lost, 0);
}

TEST(TexturesStay, AffineMappingIsTheLinearFunctionOfTheScreen) {
  const NumberedSquare numbered;
  Material material = numbered.material();
  material.texturing.mapping = TextureMapping::affine;
  const auto picture = wall<TextureTraits<>>(material, scene::settings());
  const auto counting = wall<TextureTraits<Rgb565, Depth16<>, Counted>>(material, scene::settings());
  EXPECT_EQ(picture.pixels, counting.pixels);  // piece by piece
  int wrong = 0;
  double worst = 0;
  for (int y = 0; y < 240; ++y)
    for (int x = 0; x < 320; ++x) {
      const double right = (x + 0.5) / 320, down = (y + 0.5) / 240;
      // Corners: (0, ⅓), (1, 0), (1, 1), (0, ⅔); the triangles meet from top left to bottom right.
      const double s = right, t = down < right ? 1.0 / 3 - right / 3 + down : 1.0 / 3 + down / 3 + right / 3;
      const std::uint16_t shown = picture.pixels[picture.at(x, y)];
      const auto off = [](double coordinate, int texel) {
        const double beyond = std::max(texel - coordinate, coordinate - (texel + 1));
        return std::max(beyond, 0.0);
      };
      const double distance = std::max(off(s * 64, shown % 64), off(t * 64, shown / 64));
      wrong += distance > 0;
      worst = std::max(worst, distance);
    }
  std::printf("affine: %d pixels show a neighbouring texel, %.5f texels off at most\n", wrong, worst);
  // Texture coordinates of the corners have 14 bits: a 64th of a 256th of these texels.
  EXPECT_LE(worst, 1.0 / 256);
  EXPECT_LE(wrong, 76800 / 500);
}

/// Cut-out textures beside flat surfaces; with something see-through, so that `span` has layers for them.
template <class Depth, class Visibility>
using CutOuts = RendererTraits<
    Rgb565,
    ShaderList<FlatShader<Rgb565>, NearestTextureShader<Rgb565, TexelFormat::rgb565_cutout, NoTexelLight>,
               SeeThroughShader<Rgb565, FlatShader<Rgb565>>>,
    Depth, Visibility>;

/// Three walls that cross one another, under a texture with holes, before one without.
template <class Traits>
Picture<Traits> crossing_walls(const Texture& holes, int turn, int band_lines) {
  Capacity capacity = wall_capacity;
  capacity.instances = 4;
  capacity.band_lines = static_cast<std::uint16_t>(band_lines);
  capacity.vertices = capacity.textures = 16;
  capacity.polygons = capacity.active = capacity.awake = capacity.fragments = capacity.layers = 8;
  if (Traits::Visibility::template Algorithm<typename Traits::Depth, std::uint16_t, typename Traits::Shaders,
                                             false>::tests_depth)
    capacity.fragments = capacity.layers = 0;
  Studio<Traits> studio(capacity);
  FrameSettings settings = scene::settings();
  settings.cull = Cull::none;
  studio.begin(settings);
  const Material cut_out{.texturing = {.texture = &holes, .function = TextureFunction::replace}};
  const auto placed = [&](int degrees, Vec3<Q16_16> at) {
    Transform transform{rotation_y(Angle::from_degrees(degrees))};
    transform.translation = at;
    return transform;
  };
  studio.add(scene::mesh, placed(turn, {}), cut_out);
  Mesh plain = scene::mesh;
  plain.texture_coordinates = {};
  studio.add(plain, placed(0, {{}, {}, Q16_16::from_int(-2)}), {.colour = {200, 90, 30}});
  studio.add(scene::mesh, placed(turn + 25, {Q16_16::from_int(-1), {}, Q16_16::from_int(-1)}), cut_out);
  studio.add(scene::mesh, placed(-30, {Q16_16::from_int(1), {}, Q16_16::from_int(-1)}), cut_out);
  auto picture = studio.draw();
  EXPECT_TRUE(studio.status().ok()) << to_string(studio.status().fault) << " " << to_string(studio.status().pool);
  return picture;
}

TEST(TexturesStay, CutOutsAreTheSameWithDepthBoundsAndBySpans) {
  Random random(63);
  const OwnTexture own(random, TexelFormat::rgb565_cutout, 4, 4);
  for (const int turn : {-20, 0, 7, 15}) {
    const auto at_16 = crossing_walls<CutOuts<Depth16<>, ZBuffer>>(own.texture, turn, 240);
    ASSERT_GT(at_16.drawn_count(), 20000u);
    for (const int lines : {240, 16, 7}) {
      const auto bounded = crossing_walls<CutOuts<Depth16<>, BoundedZBuffer>>(own.texture, turn, lines);
      EXPECT_EQ(bounded.pixels, at_16.pixels) << turn << ", bands of " << lines;
      EXPECT_EQ(bounded.depth, at_16.depth) << turn << ", bands of " << lines;
    }
    const auto at_24 = crossing_walls<CutOuts<Depth24<>, ZBuffer>>(own.texture, turn, 240).pixels;
    for (const int lines : {16, 7})
      EXPECT_EQ((crossing_walls<CutOuts<Depth24<>, Spanning>>(own.texture, turn, lines).pixels), at_24) << turn;
    EXPECT_EQ((crossing_walls<CutOuts<Depth24<>, BoundedZBuffer>>(own.texture, turn, 16).pixels), at_24) << turn;
  }
}

}  // namespace
}  // namespace spanline::test
