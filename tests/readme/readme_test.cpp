// The program that README.md shows.
#include "readme_example.hpp"

#include <gtest/gtest.h>

#include "spanline/model/validate.hpp"

namespace {

TEST(Readme, TheExampleDrawsACube) {
  EXPECT_TRUE(validate(cube).ok()) << to_string(validate(cube).fault);
  int lines = 0, drawn = 0;
  std::uint16_t middle = 0;
  const Status status = draw_cube(Angle::from_degrees(30), [&](int y0, int y1, auto pixels) {
    EXPECT_EQ(pixels.size(), static_cast<std::size_t>(160 * (y1 - y0)));
    lines += y1 - y0;
    for (const auto pixel : pixels) drawn += pixel != 0;
    if (y0 <= 64 && 64 < y1) middle = pixels[static_cast<std::size_t>(160 * (64 - y0) + 80)];
    return true;
  });
  EXPECT_TRUE(status.ok()) << to_string(status.fault) << ' ' << to_string(status.pool) << ' ' << status.wanted;
  EXPECT_EQ(lines, 128);
  // A cube of side 2 from about 5.4 away under 45°: about 57 pixels a side, 1.2 to 1.7 faces' worth of area in view.
  EXPECT_GT(drawn, 3200);
  EXPECT_LT(drawn, 6500);
  EXPECT_NE(middle, 0);
}

}  // namespace
