// Premultiplied alpha against exact rationals: every coverage, every pair of channel values.
#include "spanline/pixel/premultiplied.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "spanline/pixel/pixel_format.hpp"
#include "support/random.hpp"

namespace spanline::test {
namespace {

constexpr std::uint32_t rgb565(std::uint32_t red, std::uint32_t green, std::uint32_t blue) {
  return red << 11 | green << 5 | blue;
}

/// The rational numerator/denominator rounded to nearest, halves up.
constexpr std::uint32_t nearest(std::uint32_t numerator, std::uint32_t denominator) {
  return (2 * numerator + denominator) / (2 * denominator);
}

constexpr std::uint32_t blended(std::uint32_t above, std::uint32_t below, std::uint32_t alpha) {
  return nearest(alpha * above + (32 - alpha) * below, 32);
}

/// Calls f(A, B, α) for all coverages and green values; red and blue take all their pairs on the way.
template <class F>
void for_all(F f) {
  for (std::uint32_t alpha = 0; alpha <= 32; ++alpha)
    for (std::uint32_t a = 0; a < 64; ++a)
      for (std::uint32_t b = 0; b < 64; ++b) f(rgb565(a & 31, a, 31 - (b & 31)), rgb565(b & 31, b, a >> 1), alpha);
}

TEST(Premultiplied, OverAnOpaquePixelIsTheExactRationalRounded) {
  for_all([](std::uint32_t above, std::uint32_t below, std::uint32_t alpha) {
    const std::uint32_t want =
        rgb565(blended(above >> 11, below >> 11, alpha), blended((above >> 5) & 63, (below >> 5) & 63, alpha),
               blended(above & 31, below & 31, alpha));
    ASSERT_EQ(Premultiplied565::from(above, alpha).over(below), want)
        << std::hex << above << " over " << below << ", alpha " << alpha;
  });
}

TEST(Premultiplied, StraightColoursAreKeptExactly) {
  for_all([](std::uint32_t above, std::uint32_t, std::uint32_t alpha) {
    const Premultiplied565 pixel = Premultiplied565::from(above, alpha);
    ASSERT_EQ(pixel.red(), (above >> 11) * alpha);
    ASSERT_EQ(pixel.green(), ((above >> 5) & 63) * alpha);
    ASSERT_EQ(pixel.blue(), (above & 31) * alpha);
    ASSERT_EQ(pixel.alpha(), alpha);
  });
}

TEST(Premultiplied, OneEquationServesColourAndCoverage) {
  Random random(5);
  const auto composed = [](std::uint32_t above, std::uint32_t below, std::uint32_t alpha) {
    return above + nearest((32 - alpha) * below, 32);  // in 32nds
  };
  for (std::uint32_t alpha = 0; alpha <= 32; ++alpha)
    for (std::uint32_t beta = 0; beta <= 32; ++beta)
      for (int i = 0; i < 40; ++i) {
        const auto a = Premultiplied565::from(static_cast<std::uint32_t>(random.between(0, 65535)), alpha);
        const auto b = Premultiplied565::from(static_cast<std::uint32_t>(random.between(0, 65535)), beta);
        const Premultiplied565 both = a.over(b);
        ASSERT_EQ(both.alpha(), composed(alpha, beta, alpha));
        ASSERT_EQ(both.red(), composed(a.red(), b.red(), alpha));
        ASSERT_EQ(both.green(), composed(a.green(), b.green(), alpha));
        ASSERT_EQ(both.blue(), composed(a.blue(), b.blue(), alpha));
        ASSERT_LE(both.alpha(), 32U);
      }
}

TEST(Premultiplied, OverAnOpaqueLayerIsOverAnOpaquePixel) {
  for_all([](std::uint32_t above, std::uint32_t below, std::uint32_t alpha) {
    const Premultiplied565 layer = Premultiplied565::from(above, alpha);
    const Premultiplied565 both = layer.over(Premultiplied565::from(below, 32));
    ASSERT_EQ(both.alpha(), 32U);
    ASSERT_EQ(rgb565(nearest(both.red(), 32), nearest(both.green(), 32), nearest(both.blue(), 32)), layer.over(below));
  });
}

TEST(Premultiplied, NothingChangesNoPixelAndFullCoverageReplacesIt) {
  for (std::uint32_t below = 0; below < 65536; below += 7) {
    ASSERT_EQ(Premultiplied565().over(below), below);
    ASSERT_EQ(Premultiplied565::from(below, 32).over(below ^ 0xffff), below);
  }
}

TEST(Premultiplied, OpacitiesOfEightBitsAreRoundedToTheNearestCoverage) {
  for (std::uint32_t opacity = 0; opacity <= 255; ++opacity) EXPECT_EQ(alpha_32(opacity), nearest(opacity * 32, 255));
}

TEST(Premultiplied, GlowsAddAndStopAtFull) {
  const auto sum = [](std::uint32_t a, std::uint32_t b, std::uint32_t most) { return a + b < most ? a + b : most; };
  for_all([&](std::uint32_t glow, std::uint32_t below, std::uint32_t) {
    ASSERT_EQ(added_565(below, glow),
              rgb565(sum(glow >> 11, below >> 11, 31), sum((glow >> 5) & 63, (below >> 5) & 63, 63),
                     sum(glow & 31, below & 31, 31)));
  });
}

template <class Format>
void check_runs() {
  for (std::uint32_t count = 1; count <= 37; ++count)
    for (std::size_t first = 0; first < 4; ++first) {
      std::vector<std::uint16_t> line(48);
      for (std::size_t i = 0; i < line.size(); ++i) line[i] = static_cast<std::uint16_t>(i * 40503 + count);
      const std::vector<std::uint16_t> before = line;
      const auto layer = Premultiplied565::from(0xa9b3, count % 33);
      blend_constant<Format>(layer, count, line.data() + first);
      for (std::size_t i = 0; i < line.size(); ++i) {
        const bool inside = i >= first && i < first + count;
        const auto want = static_cast<std::uint16_t>(layer.over(Format::from_rgb565(before[i])));
        ASSERT_EQ(line[i], inside ? Format::from_rgb565(want) : before[i]) << count << " pixels at " << first;
      }
    }
}

TEST(Premultiplied, RunsBlendEachPixelAndNoneBeside) {
  check_runs<Rgb565>();
  check_runs<Rgb565Swapped>();
}

}  // namespace
}  // namespace spanline::test
