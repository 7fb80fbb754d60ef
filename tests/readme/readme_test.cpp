// The programs that README.md and docs/display.md show.
#include "readme_example.hpp"
// Behind what it is ten lines longer than.
#include "display_example.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "panels/host_bus.hpp"
#include "panels/sim_clock.hpp"
#include "panels/st7789_model.hpp"

#include "spanline/model/validate.hpp"

namespace {

TEST(Readme, TheExampleDrawsACube) {
  EXPECT_TRUE(validate(cube).ok()) << to_string(validate(cube).fault);
  int lines = 0, drawn = 0;
  std::uint16_t middle = 0;
  Picture renderer(picture_size, picture_memory);
  const Status status = draw_cube(renderer, Angle::from_degrees(30), [&](const auto& band) {
    EXPECT_EQ(band.pixels.size(), static_cast<std::size_t>(240 * (band.y1 - band.y0)));
    lines += band.y1 - band.y0;
    for (const auto pixel : band.pixels) drawn += pixel != 0;
    if (band.y0 <= 120 && 120 < band.y1) middle = band.pixels[static_cast<std::size_t>(240 * (120 - band.y0) + 120)];
    return true;
  });
  EXPECT_TRUE(status.ok()) << to_string(status.fault) << ' ' << to_string(status.pool) << ' ' << status.wanted;
  EXPECT_EQ(lines, 240);
  // A cube of side 2 from about 5.4 away under 45°: about 107 pixels a side, 1.2 to 1.7 faces' worth of area in view.
  EXPECT_GT(drawn, 11'250);
  EXPECT_LT(drawn, 22'800);
  EXPECT_NE(middle, 0);
}

TEST(Readme, TheDisplaysExampleShowsTheSameCubeOnItsPanel) {
  sim::SimClock clock;
  sim::St7789Model model(sim::St7789Glass::size_240x240, hal::Orientation::landscape);
  sim::HostBus bus(model, clock, 62'500'000);
  constexpr unsigned frames = 6;
  turn_cube(bus, clock, frames);
  std::vector<std::uint8_t> wanted;
  Picture renderer(picture_size, picture_memory);
  const Status status = draw_cube(renderer, Angle::from_turns(frames - 1, 60), [&](const auto& band) {
    for (const auto pixel : band.pixels) {
      const unsigned word = hal::to_pixel_order(hal::PixelOrder::high_byte_first, pixel);
      const unsigned red = word >> 11, green = word >> 5 & 63, blue = word & 31;
      for (const unsigned channel : {red << 3 | red >> 2, green << 2 | green >> 4, blue << 3 | blue >> 2})
        wanted.push_back(static_cast<std::uint8_t>(channel));
    }
    return true;
  });
  ASSERT_TRUE(status.ok());
  EXPECT_EQ(model.picture().rgb, wanted);
  for (const sim::Complaint& complaint : model.complaints()) ADD_FAILURE() << describe(complaint);
}

}  // namespace
