#include <gif_lib.h>
#include <zlib.h>

#include <algorithm>
#include <random>

#include "base/failure.hpp"
#include "base/output_file.hpp"
#include "image/animation.hpp"
#include "image/png.hpp"
#include "tool.hpp"

namespace spanline::sim::test {
namespace {

using PictureTest = ToolTest;

Picture noise(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  Picture picture(width, height);
  for (Rgb888& pixel : picture.pixels) pixel = number_pixel(static_cast<std::uint32_t>(random()) & 0xffffffU);
  return picture;
}

TEST(Png, RoundTrip) {
  for (const auto& [width, height] : {std::pair{1, 1}, {7, 3}, {320, 240}, {2047, 1}}) {
    const Picture picture = noise(width, height, 1);
    EXPECT_EQ(decode_png(encode_png(picture)), picture);
  }
}

TEST(Png, RefusesGarbage) {
  const std::vector<std::byte> garbage(100, std::byte{42});
  EXPECT_THROW(static_cast<void>(decode_png(garbage)), Failure);
  const std::vector<std::byte> whole = encode_png(noise(20, 20, 2));
  EXPECT_THROW(static_cast<void>(decode_png(std::span(whole).first(whole.size() / 2))), Failure);
}

TEST_F(PictureTest, ApngHasEveryFrameAndTheFirstAsStill) {
  const std::string path = in_folder("a.png");
  const std::vector<Picture> frames{noise(9, 5, 1), noise(9, 5, 2), noise(9, 5, 3)};
  OutputFile file(path);
  const auto animation = make_animation(AnimationFormat::apng, file, 3);
  for (const Picture& frame : frames) animation->add(frame);
  animation->finish();
  file.commit();
  EXPECT_EQ(read_png(path), frames[0]);

  // The chunks by the specification: acTL with three frames, numbered fcTL and fdAT, right CRCs.
  const std::string bytes = read_text(path);
  const auto u32 = [&](std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes.at(at + i));
    return value;
  };
  std::string types;
  std::uint32_t sequence = 0;
  for (std::size_t at = 8; at < bytes.size(); at += u32(at) + 12) {
    const std::string type = bytes.substr(at + 4, 4);
    const std::size_t size = u32(at);
    EXPECT_EQ(u32(at + 8 + size),
              crc32(0, reinterpret_cast<const Bytef*>(bytes.data()) + at + 4, static_cast<uInt>(size + 4)));
    if (type == "acTL") {
      EXPECT_EQ(u32(at + 8), 3U);
    }
    if (type == "fcTL" || type == "fdAT") {
      EXPECT_EQ(u32(at + 8), sequence++);
    }
    if (!types.ends_with(type + ' ')) types += type + ' ';
  }
  EXPECT_EQ(types, "IHDR acTL fcTL IDAT fcTL fdAT fcTL fdAT IEND ");
}

TEST_F(PictureTest, GifKeepsPicturesOfFewColoursExactly) {
  const std::string path = in_folder("a.gif");
  Picture first(16, 10, {10, 20, 30}), second(16, 10, {200, 100, 0});
  first.at(3, 4) = {255, 255, 255};
  {
    OutputFile file(path);
    const auto animation = make_animation(AnimationFormat::gif, file, 2);
    animation->add(first);
    animation->add(second);
    animation->finish();
    file.commit();
  }
  int error = 0;
  GifFileType* gif = DGifOpenFileName(path.c_str(), &error);
  ASSERT_NE(gif, nullptr);
  ASSERT_EQ(DGifSlurp(gif), GIF_OK);
  ASSERT_EQ(gif->ImageCount, 2);
  for (int image = 0; image < 2; ++image) {
    const SavedImage& saved = gif->SavedImages[image];
    const Picture& want = image == 0 ? first : second;
    for (std::size_t i = 0; i < want.pixels.size(); ++i) {
      const GifColorType& colour = saved.ImageDesc.ColorMap->Colors[saved.RasterBits[i]];
      EXPECT_EQ((Rgb888{colour.Red, colour.Green, colour.Blue}), want.pixels[i]);
    }
  }
  DGifCloseFile(gif, &error);
}

TEST_F(PictureTest, GifTakesPicturesOfManyColours) {
  const std::string path = in_folder("a.gif");
  OutputFile file(path);
  const auto animation = make_animation(AnimationFormat::gif, file, 1);
  animation->add(noise(64, 64, 3));
  animation->finish();
  file.commit();
  EXPECT_TRUE(read_text(path).starts_with("GIF89a"));
}

TEST_F(PictureTest, AnOutputFileAppearsWholeOrNotAtAll) {
  const std::string path = in_folder("a.txt");
  {
    OutputFile file(path);
    file.write(std::string_view("half"));
    EXPECT_FALSE(std::filesystem::exists(path));
  }
  EXPECT_TRUE(files().empty());
  OutputFile file(path);
  file.write(std::string_view("whole"));
  file.commit();
  EXPECT_EQ(read_text(path), "whole");
  EXPECT_EQ(files(), std::vector<std::string>{"a.txt"});
}

TEST_F(PictureTest, AnOutputFileFollowsLinksAndKeepsModes) {
  const std::string target = make_file("target.txt", "old");
  std::filesystem::permissions(target, std::filesystem::perms(0640));
  std::filesystem::create_symlink(target, in_folder("link.txt"));
  OutputFile file(in_folder("link.txt"));
  file.write(std::string_view("new"));
  file.commit();
  EXPECT_EQ(read_text(target), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(in_folder("link.txt")));
  EXPECT_EQ(std::filesystem::status(target).permissions(), std::filesystem::perms(0640));
}

}  // namespace
}  // namespace spanline::sim::test
