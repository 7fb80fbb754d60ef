// Textures: sizes of pyramids, and the faults that validate() finds.
#include "spanline/model/texture.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace spanline::test {
namespace {

const std::vector<std::uint16_t> words(1 << 20), palette_256(256), palette_16(16);
const std::vector<std::uint8_t> bytes(1 << 20);

Texture of_words(std::size_t count) {
  Texture texture{.log2_width = 4, .log2_height = 3};
  texture.words = std::span(words).first(count);
  return texture;
}

TEST(Textures, APyramidTakesAThirdMoreAndLiesInOneBlock) {
  const Texture texture{.log2_width = 4, .log2_height = 3, .levels = 5};
  EXPECT_EQ(texture.level_size(0), 128U);
  EXPECT_EQ(texture.offset_of(1), 128U);
  EXPECT_EQ(texture.offset_of(2), 128U + 32);
  EXPECT_EQ(texture.level_size(3), 2U);  // 2 × 1
  EXPECT_EQ(texture.level_size(4), 1U);
  EXPECT_EQ(texture.offset_of(5), 128U + 32 + 8 + 2 + 1);
}

TEST(Textures, RowsOfHalfBytesAreWholeBytes) {
  const Texture texture{.format = TexelFormat::palette16, .log2_width = 0, .log2_height = 3};
  EXPECT_EQ(texture.level_size(0), 8U);
}

TEST(Textures, TablesMustHoldEveryLevel) {
  EXPECT_EQ(validate(of_words(128)), TextureFault::none);
  EXPECT_EQ(validate(of_words(127)), TextureFault::texels_count);
  Texture pyramid = of_words(170);
  pyramid.levels = 5;
  EXPECT_EQ(validate(pyramid), TextureFault::texels_count);
  pyramid.words = std::span(words).first(171);
  EXPECT_EQ(validate(pyramid), TextureFault::none);
  pyramid.levels = 6;
  EXPECT_EQ(validate(pyramid), TextureFault::levels);
  pyramid.levels = 0;
  EXPECT_EQ(validate(pyramid), TextureFault::levels);
}

TEST(Textures, FormatsWantTheirOwnTableAndPalette) {
  Texture texture = of_words(128);
  texture.format = TexelFormat::palette256;
  EXPECT_EQ(validate(texture), TextureFault::texels_count);
  texture.words = {};
  texture.bytes = std::span(bytes).first(128);
  EXPECT_EQ(validate(texture), TextureFault::palette_count);
  texture.palette = palette_16;
  EXPECT_EQ(validate(texture), TextureFault::palette_count);
  texture.palette = palette_256;
  EXPECT_EQ(validate(texture), TextureFault::none);
  texture.format = TexelFormat::palette16;
  EXPECT_EQ(validate(texture), TextureFault::palette_count);
  texture.palette = palette_16;
  texture.bytes = std::span(bytes).first(64);
  EXPECT_EQ(validate(texture), TextureFault::none);
  texture.words = std::span(words).first(1);
  EXPECT_EQ(validate(texture), TextureFault::texels_count);
  texture = of_words(128);
  texture.palette = palette_16;
  EXPECT_EQ(validate(texture), TextureFault::palette_count);
}

TEST(Textures, SidesAndTheWholeAreLimited) {
  Texture texture{.log2_width = 11, .log2_height = 9, .words = words};
  EXPECT_EQ(validate(texture), TextureFault::none);
  texture.log2_height = 10;
  EXPECT_EQ(validate(texture), TextureFault::too_large);
  texture = {.log2_width = 12, .log2_height = 0, .words = words};
  EXPECT_EQ(validate(texture), TextureFault::too_large);
}

}  // namespace
}  // namespace spanline::test
