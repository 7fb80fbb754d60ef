// Gouraud shading against exact interpolation over the screen: within one level of a channel.
#include <gtest/gtest.h>
#include <spanline/raster/surface_blocks.hpp>

#include "shade/shading_scene.hpp"
#include "support/effort.hpp"

namespace spanline::test {
namespace {

/// A value at the corners, interpolated exactly over the screen; in 2^-24 at the corners.
class Interpolated {
 public:
  Interpolated(Corners corners, const std::array<double, 3>& values) : exact_(with(corners, values)) {}
  [[nodiscard]] double at(int x, int y) const { return exact_.depth(x, y) * 0x1p-24; }

 private:
  static Corners with(Corners corners, const std::array<double, 3>& values) {
    for (std::size_t i = 0; i < 3; ++i) corners[i].z = static_cast<std::int32_t>(std::lround(values[i] * 0x1p24));
    return corners;
  }
  ExactTriangle exact_;
};

int levels(int got, double exact) { return std::abs(got - static_cast<int>(std::lround(exact))); }

TEST(Gouraud, IntensityIsWithinALevelOfExactInterpolation) {
  Random random(1);
  long pixels = 0, off = 0;
  for (int i = 0; i < rounds(3000); ++i) {
    ShadedTriangle t(random);
    const RandomLights lights(random, random.between(1, 4));
    t.settings.lighting = lights.lighting();
    std::array<double, 3> light{};
    for (double& value : light) {
      const RealNormal n = random_normal(random);
      t.owned.vertex_normals.push_back(n.packed);
      value = lights.on(n, t.transform.rotation);
    }
    const Rgb888 colour = random_colour(random);
    const auto picture = t.draw<Rgb565>({colour, ShadingMode::gouraud});
    const Interpolated exact(t.corners, light);
    ExactTriangle(t.corners).for_each_pixel(64, 64, [&](int x, int y) {
      const Channels got(picture.pixels[picture.at(x, y)]);
      const double value = exact.at(x, y);
      const int worst =
          std::max({levels(got.red, colour.red * value * 31 / 255), levels(got.green, colour.green * value * 63 / 255),
                    levels(got.blue, colour.blue * value * 31 / 255)});
      ++pixels;
      off += worst;
      EXPECT_LE(worst, 1) << t.corners << "at " << x << ", " << y;
    });
    ASSERT_FALSE(HasFailure()) << "round " << i;
  }
  std::printf("%ld of %ld pixels are a level off\n", off, pixels);
}

TEST(Gouraud, VertexColoursAreWithinALevelOfExactInterpolation) {
  Random random(2);
  long pixels = 0, off = 0;
  for (int i = 0; i < rounds(3000); ++i) {
    ShadedTriangle t(random);
    const RandomLights lights(random, random.between(0, 3));
    t.settings.lighting = lights.lighting();
    const bool lit = random.chance(2);
    std::array<double, 3> red{}, green{}, blue{};
    for (std::size_t k = 0; k < 3; ++k) {
      const RealNormal n = random_normal(random);
      const Rgb888 colour = random_colour(random);
      if (lit) t.owned.vertex_normals.push_back(n.packed);
      t.owned.vertex_colours.push_back(colour);
      const double light = lit ? lights.on(n, t.transform.rotation) : 1;
      red[k] = colour.red * light / 255;
      green[k] = colour.green * light / 255;
      blue[k] = colour.blue * light / 255;
    }
    const auto picture = t.draw<Rgb565>({{1, 2, 3}, ShadingMode::gouraud});
    const Interpolated r(t.corners, red), g(t.corners, green), b(t.corners, blue);
    ExactTriangle(t.corners).for_each_pixel(64, 64, [&](int x, int y) {
      const Channels got(picture.pixels[picture.at(x, y)]);
      const int worst = std::max(
          {levels(got.red, r.at(x, y) * 31), levels(got.green, g.at(x, y) * 63), levels(got.blue, b.at(x, y) * 31)});
      ++pixels;
      off += worst;
      EXPECT_LE(worst, 1) << t.corners << "at " << x << ", " << y;
    });
    ASSERT_FALSE(HasFailure()) << "round " << i;
  }
  std::printf("%ld of %ld pixels are a level off\n", off, pixels);
}

TEST(Gouraud, FullLightAndNoneReachTheEndsOfTheRange) {
  Random random(3);
  ShadedTriangle t(random);
  t.owned.vertices = {{-512, -512, 0}, {512, -512, 0}, {0, 512, 0}};
  t.owned.fit_bounds();
  t.owned.vertex_normals.assign(3, PackedNormal(0, 0, 511));
  for (const bool lit : {true, false}) {
    t.settings.lighting = {lit ? Fixed<16>::from_int(1) : Fixed<16>{}, {}};
    const auto picture = t.draw<Rgb565>({{255, 255, 255}, ShadingMode::gouraud});
    EXPECT_EQ(picture.pixels[picture.at(32, 32)], lit ? 0xffff : 0);
  }
  t.owned.vertex_colours.assign(3, Rgb888{255, 0, 255});
  t.settings.lighting = {Fixed<16>::from_int(1), {}};
  const auto picture = t.draw<Rgb565>({{}, ShadingMode::gouraud});
  EXPECT_EQ(picture.pixels[picture.at(32, 32)], 0xf81f);
}

// A cut changes nothing on what is left: in an orthographic view shades are linear on both sides of the projection.
TEST(Gouraud, ClippedTrianglesKeepTheShadesOfTheWhole) {
  Random random(4);
  long pixels = 0;
  for (int i = 0; i < rounds(3000); ++i) {
    ShadedTriangle t(random);
    t.settings.lighting = {Fixed<16>::from_int(1), {}};
    for (int k = 0; k < 3; ++k) t.owned.vertex_colours.push_back(random_colour(random));
    const auto whole = t.draw<Rgb565>({{}, ShadingMode::gouraud});
    // Depths are 100 ± 12.5 units: cut somewhere between.
    if (random.chance(2))
      t.settings.camera.near_plane = nearest<Q16_16>(random.real(90, 110));
    else
      t.settings.camera.far_plane = nearest<Q16_16>(random.real(90, 110));
    const auto cut = t.draw<Rgb565>({{}, ShadingMode::gouraud});
    // Thin remains amplify the snapping of the new corners to sixteenths: judged are triangles of some width.
    if (ExactTriangle(t.corners).area() < 64 * 256) continue;
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) {
        const std::size_t p = cut.at(x, y);
        if (!cut.drawn(x, y) || !whole.drawn(x, y)) continue;
        const Channels a(whole.pixels[p]), b(cut.pixels[p]);
        ++pixels;
        const int worst = std::max({std::abs(a.red - b.red), std::abs(a.green - b.green), std::abs(a.blue - b.blue)});
        ASSERT_LE(worst, 3) << t.corners << "at " << x << ", " << y;
      }
  }
  EXPECT_GT(pixels, 26 * rounds(3000));
}

// In perspective too a cut never leaves the range of the corners.
TEST(Gouraud, ClippingNeverLeavesTheRangeOfTheCorners) {
  Random random(5);
  for (int i = 0; i < rounds(2000); ++i) {
    ShadedTriangle t(random);
    t.settings.camera.projection = Projection::perspective;
    t.settings.camera.focal = Q16_16::from_int(100);
    t.settings.camera.near_plane = nearest<Q16_16>(random.real(88, 112));
    t.settings.lighting = {Fixed<16>::from_int(1), {}};
    const std::uint8_t low = 64, high = 192;
    for (int k = 0; k < 3; ++k) {
      const auto c = [&] { return static_cast<std::uint8_t>(random.between(low, high)); };
      t.owned.vertex_colours.push_back({c(), c(), c()});
    }
    const auto picture = t.draw<Rgb565>({{}, ShadingMode::gouraud});
    for (std::size_t p = 0; p < picture.pixels.size(); ++p) {
      if (picture.depth[p] == 0xffff) continue;
      const Channels c(picture.pixels[p]);
      ASSERT_TRUE(c.red >= 7 && c.red <= 24 && c.green >= 15 && c.green <= 48 && c.blue >= 7 && c.blue <= 24)
          << "round " << i;
    }
  }
}

}  // namespace
}  // namespace spanline::test
