// Two dimensions on top: the same picture at every band height, nothing outside it, lines where they belong, and text.
#include "spanline/finish/canvas.hpp"
#include "spanline/finish/utf8_reader.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <sans_14.hpp>
#include <vector>

#include "support/random.hpp"

namespace spanline::test {
namespace {

constexpr int width = 120, height = 90;
constexpr std::uint16_t paper = 0x39e7;
using Pixels = std::vector<std::uint16_t>;
using Draw = std::function<void(Canvas<Rgb565>&)>;

/// A picture drawn in bands, each in a buffer of exactly its size.
Pixels drawn(int lines, const Draw& draw) {
  Pixels picture;
  for (int y0 = 0; y0 < height; y0 += lines) {
    const int y1 = std::min(y0 + lines, height);
    Pixels band(static_cast<std::size_t>(width) * static_cast<std::size_t>(y1 - y0), paper);
    Canvas<Rgb565> canvas(band, width, y0, y1);
    draw(canvas);
    picture.insert(picture.end(), band.begin(), band.end());
  }
  return picture;
}

std::size_t inked(const Pixels& picture) {
  return static_cast<std::size_t>(std::count_if(picture.begin(), picture.end(), [](auto p) { return p != paper; }));
}
std::uint16_t at(const Pixels& picture, int x, int y) {
  return picture[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)];
}

void expect_same_at_every_band_height(const Draw& draw) {
  const Pixels whole = drawn(height, draw);
  for (const int lines : {1, 7, 16, 64}) EXPECT_EQ(drawn(lines, draw), whole) << "bands of " << lines;
}

TEST(Canvas, RectanglesCoverTheirPixelsAndNoOthers) {
  const Pixels picture = drawn(16, [](auto& c) { c.fill(10, 20, 30, 40, {255, 0, 0}); });
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      ASSERT_EQ(at(picture, x, y), x >= 10 && x < 40 && y >= 20 && y < 60 ? 0xf800 : paper) << x << ", " << y;
  EXPECT_EQ(inked(drawn(16, [](auto& c) { c.frame(10, 20, 30, 40, {}); })), 2U * 30 + 2 * 38);
  EXPECT_EQ(inked(drawn(16, [](auto& c) { c.fill(-50, -50, 1000, 1000, {}); })), std::size_t{width} * height);
  EXPECT_EQ(inked(drawn(16,
                        [](auto& c) {
                          c.fill(5, 5, 0, 9, {});
                          c.fill(5, 5, -3, 9, {});
                          c.fill(200, 5, 9, 9, {});
                          c.fill(5, -20, 9, 9, {});
                        })),
            0U);
}

TEST(Canvas, LinesTakeTheNearestPixelOfEveryStep) {
  Random random(1);
  for (int i = 0; i < 3000; ++i) {
    const int reach = random.chance(3) ? 16000 : 150;
    const auto c = [&](int size) { return random.between(-reach, size + reach); };
    const int x0 = c(width), y0 = c(height), x1 = random.chance(10) ? x0 : c(width),
              y1 = random.chance(10) ? y0 : c(height);
    const Draw draw = [&](auto& canvas) { canvas.line(x0, y0, x1, y1, {0, 255, 0}); };
    Pixels expected(std::size_t{width} * height, paper);
    const bool steep = std::abs(y1 - y0) > std::abs(x1 - x0);
    const long steps = std::max(std::abs(x1 - x0), std::abs(y1 - y0));
    for (long k = 0; k <= steps; ++k) {
      const auto along = [&](int from, int to) {
        if (steps == 0) return static_cast<double>(from);
        return std::floor(from + (2.0 * static_cast<double>(k) * (to - from) + static_cast<double>(steps)) /
                                     (2.0 * static_cast<double>(steps)));
      };
      // On the longer axis a whole step each; the shorter rounds halves upwards.
      const double x = steep ? along(x0, x1) : x0 + static_cast<double>(x1 < x0 ? -k : k);
      const double y = steep ? y0 + static_cast<double>(y1 < y0 ? -k : k) : along(y0, y1);
      if (x >= 0 && x < width && y >= 0 && y < height)
        expected[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)] = 0x07e0;
    }
    ASSERT_EQ(drawn(height, draw), expected) << x0 << "," << y0 << " " << x1 << "," << y1;
    ASSERT_EQ(drawn(random.between(1, 40), draw), expected) << x0 << "," << y0 << " " << x1 << "," << y1;
  }
}

TEST(Canvas, TextIsTheSameAtEveryBandHeightAndCutAtTheEdges) {
  const Font& font = spanline_fonts::sans_14;
  expect_same_at_every_band_height([&](auto& canvas) {
    canvas.text(-5, 12, "Grüße & 23.5 °C", font, {255, 255, 255});
    canvas.text(60, 50, "wider than the picture is", font, {250, 200, 10});
    canvas.text(3, height + 3, "gjpqy below", font, {10, 200, 250});
    canvas.text(3, 2, "above", font, {10, 200, 250});
    canvas.text(3, -100, "nowhere", font, {});
  });
}

TEST(Canvas, TextIsProportionalAndEndsWhereItsWidthSays) {
  const Font& font = spanline_fonts::sans_14;
  EXPECT_LT(text_width(font, "iiii"), text_width(font, "WWWW") / 2);
  EXPECT_EQ(text_width(font, "°C"), font.glyph(0xb0).advance + font.glyph('C').advance);
  EXPECT_EQ(text_width(font, "\xff"), font.glyph('?').advance) << "no UTF-8";
  EXPECT_EQ(text_width(font, "\xe2\x82\xac"), font.glyph('?').advance) << "a character that the font has not";
  EXPECT_EQ(text_width(font, "\xe2\x82"), 2 * font.glyph('?').advance) << "cut short";
  std::int32_t end = 0;
  const Pixels picture = drawn(16, [&](auto& c) { end = c.text(10, 40, "Text", font, {255, 255, 255}); });
  EXPECT_EQ(end, 10 + text_width(font, "Text"));
  EXPECT_GT(inked(picture), 40U);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (x < 9 || x > end || y < 40 - font.ascent || y > 40 + font.descent) {
        ASSERT_EQ(at(picture, x, y), paper) << x << ", " << y;
      }
}

TEST(Canvas, SpritesCoverAsMuchAsTheirAlphaSays) {
  std::vector<std::uint16_t> words(16 * 16);
  for (std::size_t i = 0; i < words.size(); ++i) words[i] = static_cast<std::uint16_t>(i / 16 << 12 | (i * 73 & 0xfff));
  const Texture texture{.format = TexelFormat::argb4444, .log2_width = 4, .log2_height = 4, .words = words};
  const Pixels picture = drawn(7, [&](auto& c) { c.sprite(20, 30, texture); });
  const auto channel = [](unsigned pixel, int k) {
    return (pixel >> (k == 0 ? 11 : k == 1 ? 5 : 0)) & (k == 1 ? 63 : 31);
  };
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) {
      const Texel texel = read_texel(texture, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
      ASSERT_EQ(texel.alpha, y);
      for (int k = 0; k < 3; ++k) {
        const double want = channel(paper, k) + (1.0 * channel(texel.rgb565, k) - channel(paper, k)) * y / 15.0;
        ASSERT_NEAR(channel(at(picture, 20 + x, 30 + y), k), want, 1.7) << x << ", " << y;
      }
    }
  EXPECT_LE(inked(picture), 15U * 16) << "the first row is not there";
  expect_same_at_every_band_height([&](auto& canvas) {
    canvas.sprite(-7, -9, texture);
    canvas.sprite(width - 5, height - 6, texture);
    canvas.sprite(300, 10, texture);
  });
}

TEST(Canvas, EveryTexelFormatIsRead) {
  const std::vector<std::uint8_t> nibbles{0x10, 0x32}, whole{3, 2, 1, 0};
  std::vector<std::uint16_t> palette(256);
  for (std::size_t i = 0; i < 256; ++i) palette[i] = static_cast<std::uint16_t>(100 + i);
  Texture texture{.format = TexelFormat::palette16, .log2_width = 1, .log2_height = 1, .bytes = nibbles};
  texture.palette = std::span<const std::uint16_t>(palette).first(16);
  EXPECT_EQ(read_texel(texture, 0, 0).rgb565, 100);
  EXPECT_EQ(read_texel(texture, 1, 0).rgb565, 101);
  EXPECT_EQ(read_texel(texture, 1, 1).rgb565, 103);
  texture.format = TexelFormat::palette256;
  texture.bytes = whole;
  texture.palette = palette;
  EXPECT_EQ(read_texel(texture, 1, 0).rgb565, 102);
  const std::vector<std::uint16_t> words{0xffdf, 0x0020};
  const Texture cutout{.format = TexelFormat::rgb565_cutout, .log2_width = 1, .words = words};
  EXPECT_EQ(read_texel(cutout, 0, 0).alpha, 0);
  EXPECT_EQ(read_texel(cutout, 1, 0).alpha, 15);
  EXPECT_EQ(rgb565_from_rgb444(0xfff), 0xffff);
  EXPECT_EQ(rgb565_from_rgb444(0x000), 0);
}

TEST(Canvas, SwappedBytesAreTheSamePictureSwapped) {
  const Font& font = spanline_fonts::sans_14;
  Pixels plain(std::size_t{width} * 20, paper), swapped(plain.size(), Rgb565Swapped::from_rgb565(paper));
  Canvas<Rgb565>(plain, width, 0, 20).text(2, 15, "Swap", font, {200, 100, 50});
  Canvas<Rgb565Swapped>(swapped, width, 0, 20).text(2, 15, "Swap", font, {200, 100, 50});
  for (std::size_t i = 0; i < plain.size(); ++i) ASSERT_EQ(Rgb565Swapped::from_rgb565(plain[i]), swapped[i]) << i;
}

}  // namespace
}  // namespace spanline::test
