// Texture coordinates at their limits: every size of texture and every span of coordinates that there may be, against
// lines and hyperbolas in floating point. Refuses words that lose upper bits, and overflow under sanitizers.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "spanline/cpu/texture_chords.hpp"
#include "spanline/raster/plane_equation.hpp"
#include "spanline/shade/texture/certain_blocks.hpp"
#include "spanline/shade/texture/nearest_texels.hpp"
#include "spanline/shade/texture/texture_blocks.hpp"
#include "support/effort.hpp"
#include "support/exact_triangle.hpp"
#include "support/random.hpp"

namespace spanline::test {
namespace {

constexpr Viewport viewport{320, 240};
constexpr double unit = 0x1p-20;  // of TextureVertex

/// A triangle on the screen with texture coordinates, and what they are at a pixel.
struct Mapped {
  std::array<ScreenVertex, 3> screen{};
  std::array<TextureVertex, 3> texture{};
  Corners corners{};
  double area = 0;

  Mapped(Random& random, std::uint32_t least_nearness, std::int64_t span) {
    // Wide enough that a block's ends lie near it, and reaching into the picture.
    do {
      for (Corner& corner : corners) corner = {random.between(-8000, 13000), random.between(-8000, 12000), 0};
      area = static_cast<double>(ExactTriangle(corners).area());
    } while (area < 3000.0 * 3000.0);
    const auto coordinate = [&, low = random.wide(-(std::int64_t{1} << 31), (std::int64_t{1} << 31) - 1 - span)] {
      return static_cast<std::int32_t>(random.chance(3) ? low + (random.chance(2) ? span : 0)
                                                        : random.wide(low, low + span));
    };
    const auto vertices = vertices_of({&corners, 1}, 16, viewport.width, viewport.height);
    for (unsigned i = 0; i < 3; ++i) {
      screen[i] = vertices[i];
      texture[i].nearness = static_cast<std::uint32_t>(random.wide(least_nearness, std::int64_t{1} << 31));
    }
    for (TextureVertex& vertex : texture) vertex.s = coordinate();
    for (TextureVertex& vertex : texture) vertex.t = coordinate();
  }
  [[nodiscard]] PlaneEquation plane() const { return {&screen[0], &screen[1], &screen[2], screen.data(), viewport}; }

  struct Point {
    double s, t;
  };
  /// Textures at a pixel's centre.
  [[nodiscard]] Point at(double x, double y, bool perspective) const {
    double w = 0, s = 0, t = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Corner &from = corners[(k + 1) % 3], &to = corners[(k + 2) % 3];
      double weight = (to.x - from.x) * (16 * y + 8 - from.y) - (to.y - from.y) * (16 * x + 8 - from.x);
      if (perspective) weight *= texture[k].nearness;
      w += weight;
      s += weight * texture[k].s;
      t += weight * texture[k].t;
    }
    return {s / w * unit, t / w * unit};
  }
  /// The furthest that either coordinate goes within so many pixels of a place, in textures.
  [[nodiscard]] Point reach(int x, int y, double pixels, bool perspective) const {
    const Point here = at(x, y, perspective);
    Point most{0, 0};
    for (const auto& [dx, dy] : {std::pair{-pixels, 0.0}, {pixels, 0.0}, {0.0, -pixels}, {0.0, pixels}}) {
      const Point there = at(x + dx, y + dy, perspective);
      most = {std::max(most.s, std::abs(there.s - here.s)), std::max(most.t, std::abs(there.t - here.t))};
    }
    return most;
  }
};

/// How far two coordinates on a circle of so many texels are apart.
double apart(double a, double b, double size) { return std::abs(std::remainder(a - b, size)); }

/// A word of so many fraction bits in texels.
double texels(std::uint32_t word, int fraction) { return std::ldexp(word, -fraction); }

/// Spans from a hundredth of a texel to all that coordinates have.
std::int64_t any_span(Random& random) {
  const auto most = static_cast<std::int64_t>(std::numeric_limits<std::uint32_t>::max());
  return random.chance(8) ? most : static_cast<std::int64_t>(std::exp2(random.real(2, 32)));
}

/// Draws triangles with every size of texture in the format of `Texels`. Each coordinate is right to a share of a
/// texel, and to a share of what a pixel is in texels where it is many.
template <class Texels>
void expect_right_texels(TextureMapping mapping, double of_texel, double of_pixel) {
  Random random(mapping == TextureMapping::affine ? 91 : 92);
  const bool perspective = mapping == TextureMapping::perspective;
  double worst = 0;
  for (int round = 0; round < rounds(2000); ++round)
    for (unsigned width = 0; width <= Texture::max_log2_size; ++width)
      for (unsigned height = 0; height <= Texture::max_log2_size && width + height <= Texture::max_log2_texels;
           ++height) {
        const Mapped triangle(random, perspective ? 1u << 28 : 1, any_span(random));
        const TexelScale scale{static_cast<int>(width), static_cast<int>(height), Texels::fraction_u,
                               Texels::fraction_v(width)};
        const PlaneEquation gradients = triangle.plane();
        const auto corners = gradients.corners();
        const auto vertex = [&](unsigned i) { return triangle.texture[gradients.index(corners[i])]; };
        const TexturePlaneValues values = texture_plane_values({vertex(0), vertex(1), vertex(2)}, mapping, scale);
        TexturePlane plane;
        fit_texture_plane(gradients, values, plane);
        const bool exact_perspective = values.way != TexturePlane::Way::affine;
        const ExactTriangle covered(triangle.corners);
        for (int tries = 0, found = 0; tries < 64 && found < 4; ++tries) {
          const int x = random.between(0, viewport.width - 1), y = random.between(0, viewport.height - 1);
          if (!covered.covers(x, y)) continue;
          ++found;
          TexturePlane row = plane;
          row.skip_rows(y);
          const TextureSteps at = TextureBlocks(row, x).coordinates();
          const auto exact = triangle.at(x, y, perspective);
          const auto pixel = triangle.reach(x, y, 1, perspective);
          const double sizes[] = {std::exp2(width), std::exp2(height)};
          const double off_s = apart(texels(at.u, scale.fraction_u), exact.s * sizes[0], sizes[0]),
                       off_t = apart(texels(at.v, scale.fraction_v), exact.t * sizes[1], sizes[1]);
          const double allowed_s = of_texel + of_pixel * pixel.s * sizes[0],
                       allowed_t = of_texel + of_pixel * pixel.t * sizes[1];
          worst = std::max({worst, off_s / allowed_s, off_t / allowed_t});
          ASSERT_LE(off_s, allowed_s) << x << ", " << y << " of 2^" << width << " x 2^" << height << " texels, way "
                                      << static_cast<int>(plane.way) << " shifts " << int{plane.shift_u} << ' '
                                      << round;
          ASSERT_LE(off_t, allowed_t) << x << ", " << y << " of 2^" << width << " x 2^" << height << " texels, way "
                                      << static_cast<int>(plane.way) << " shifts " << int{plane.shift_v} << ' '
                                      << round;
          // What is served in whole blocks is the same.
          const CertainBlocks blocks(row, x, 1);
          if (!blocks.certain() || exact_perspective) continue;
          TextureSteps steps;
          steps.restart(*blocks.blocks());
          steps.skip(blocks.into_block(), *blocks.blocks());
          ASSERT_EQ(steps.u, at.u);
          ASSERT_EQ(steps.v, at.v);
        }
      }
  std::printf("worst %.2f of what is allowed\n", worst);
}

/// u and v as the mip maps' shaders and the general one have them.
struct SixteenBits {
  static constexpr int fraction_u = 16;
  static constexpr int fraction_v(unsigned) { return 16; }
};

TEST(TextureLimits, AffinePlanesKeepEveryRowOfEverySizeAndSpan) {
  expect_right_texels<NearestTexels<TexelFormat::rgb565>>(TextureMapping::affine, 0.04, 0.004);
}
TEST(TextureLimits, AffinePlanesKeepThemInSixteenBits) {
  expect_right_texels<SixteenBits>(TextureMapping::affine, 0.01, 0.004);
}
TEST(TextureLimits, PerspectivePlanesKeepEveryRowOfEverySizeAndSpan) {
  expect_right_texels<NearestTexels<TexelFormat::rgb565>>(TextureMapping::perspective, 0.08, 0.2);
}
TEST(TextureLimits, PerspectivePlanesKeepThemInSixteenBits) {
  expect_right_texels<SixteenBits>(TextureMapping::perspective, 0.05, 0.2);
}

TEST(TextureLimits, ClippedEdgesMayBeLongerThanHalfOfAllCoordinates) {
  constexpr std::int32_t low = std::numeric_limits<std::int32_t>::min(),
                         high = std::numeric_limits<std::int32_t>::max();
  EXPECT_EQ(TextureVertex::mix(low, high, 0), low);
  EXPECT_EQ(TextureVertex::mix(low, high, 1u << 31), high);
  EXPECT_EQ(TextureVertex::mix(high, low, 1u << 31), low);
  Random random(93);
  for (int i = 0; i < rounds(100000); ++i) {
    const auto from = static_cast<std::int32_t>(random.wide(low, high)),
               to = static_cast<std::int32_t>(random.wide(low, high));
    const auto share = static_cast<std::uint32_t>(random.wide(0, std::int64_t{1} << 31));
    const __int128 exact = from + ((static_cast<__int128>(to) - from) * share >> 31);
    ASSERT_EQ(TextureVertex::mix(from, to, share), static_cast<std::int32_t>(exact));
  }
}

TEST(TextureLimits, ChordsOfAnyTwoWordsStayModulo32Bits) {
  Random random(94);
  for (int i = 0; i < rounds(100000); ++i) {
    const auto from = static_cast<std::uint32_t>(random.wide(0, 0xffffffff)),
               to = random.chance(4) ? from + 0x80000000u : static_cast<std::uint32_t>(random.wide(0, 0xffffffff));
    std::uint32_t at, step, gain;
    set_chords(from, to, random.between(-4096, 6144), at, step, gain);
    // Four pieces of four columns lead there, within what steps lose.
    const auto off = static_cast<std::int32_t>(at + 16 * step + 24 * gain - to);
    const double distance = std::abs(static_cast<double>(static_cast<std::int32_t>(to - from)));
    if (distance < 0x1p30) {
      ASSERT_LT(std::abs(off), 0x1p27) << from << ' ' << to;
    }
  }
}

}  // namespace
}  // namespace spanline::test
