#include "panels/panel_registry.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "panels/host_bus.hpp"
#include "panels/ili9341_model.hpp"
#include "recording_bus.hpp"
#include "spanline/hal/panels/ili9341.hpp"
#include "spanline/hal/panels/ssd0323.hpp"

namespace spanline {
namespace {

using hal::PixelOrder;
using hal::Status;
using Frame = std::vector<std::uint16_t>;

Frame random_frame(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  Frame frame(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (std::uint16_t& pixel : frame) pixel = static_cast<std::uint16_t>(random());
  return frame;
}

/// A DrawBand that copies rows of a frame, in the order wanted.
sim::DrawBand copy_from(const Frame& frame, int width, PixelOrder order) {
  return [&frame, width, order](int y0, int y1, std::span<std::uint16_t> pixels) {
    ASSERT_EQ(pixels.size(), static_cast<std::size_t>((y1 - y0) * width));
    const auto start = frame.begin() + static_cast<std::ptrdiff_t>(y0) * width;
    std::transform(start, start + static_cast<std::ptrdiff_t>(pixels.size()), pixels.begin(),
                   [order](std::uint16_t pixel) { return hal::to_pixel_order(order, pixel); });
  };
}

std::array<int, 3> wanted_color(std::string_view panel, std::uint16_t pixel) {
  if (panel == "ssd0323") {
    const int grey = hal::ssd0323::grey_level(pixel) * 17;
    return {grey, grey, grey};
  }
  const int red = pixel >> 11;
  const int green = pixel >> 5 & 63;
  const int blue = pixel & 31;
  return {red << 3 | red >> 2, green << 2 | green >> 4, blue << 3 | blue >> 2};
}

void expect_picture(const sim::PanelSession& session, const Frame& frame) {
  const sim::PanelPicture picture = session.picture();
  ASSERT_EQ(picture.width, session.info().width);
  ASSERT_EQ(picture.height, session.info().height);
  ASSERT_EQ(picture.rgb.size(), frame.size() * 3);
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const std::array<int, 3> got{picture.rgb[3 * i], picture.rgb[3 * i + 1], picture.rgb[3 * i + 2]};
    ASSERT_EQ(got, wanted_color(session.info().name, frame[i])) << session.info().name << " pixel " << i;
  }
}

TEST(PanelRegistry, ListsEachPanelOnce) {
  std::set<std::string_view> names;
  for (const sim::PanelInfo& info : sim::panels()) {
    EXPECT_TRUE(names.insert(info.name).second);
    EXPECT_FALSE(info.description.empty());
    EXPECT_EQ(info.panel_class.find(std::to_string(info.width) + "x" + std::to_string(info.height)), 0U);
    EXPECT_EQ(sim::find_panel(info.name), &info);
  }
  EXPECT_EQ(names, (std::set<std::string_view>{"ili9341", "ili9341-portrait", "ssd0323"}));
}

TEST(PanelRegistry, UnknownNames) {
  EXPECT_EQ(sim::find_panel("vga"), nullptr);
  EXPECT_EQ(sim::open_panel("vga"), nullptr);
}

TEST(PanelRegistry, EveryPanelShowsRandomPicturesExactlyAtEveryBandHeight) {
  for (const sim::PanelInfo& info : sim::panels()) {
    for (const PixelOrder order : {PixelOrder::native, PixelOrder::high_byte_first}) {
      const auto session = sim::open_panel(info.name, {.drawn_order = order});
      unsigned seed = 1;
      for (const int band : {1, 2, 7, 16, 1000}) {
        const Frame frame = random_frame(info.width, info.height, seed++);
        ASSERT_EQ(session->show(band, copy_from(frame, info.width, order)), Status::ok);
        expect_picture(*session, frame);
      }
      EXPECT_TRUE(session->complaints().empty()) << describe(session->complaints().front());
    }
  }
}

TEST(PanelRegistry, SleepIsDarkAndWakesUpWithItsPicture) {
  for (const sim::PanelInfo& info : sim::panels()) {
    const auto session = sim::open_panel(info.name);
    EXPECT_EQ(session->sleep(true), Status::panel_not_ready);
    const Frame frame = random_frame(info.width, info.height, 9);
    const sim::DrawBand draw = copy_from(frame, info.width, PixelOrder::native);
    ASSERT_EQ(session->show(16, draw), Status::ok);
    ASSERT_EQ(session->sleep(true), Status::ok);
    const sim::PanelPicture dark = session->picture();
    EXPECT_EQ(std::count(dark.rgb.begin(), dark.rgb.end(), 0), static_cast<std::ptrdiff_t>(dark.rgb.size()));
    EXPECT_EQ(session->show(16, draw), Status::panel_asleep);
    ASSERT_EQ(session->sleep(false), Status::ok);
    expect_picture(*session, frame);
    EXPECT_TRUE(session->complaints().empty());
  }
}

TEST(PanelRegistry, TakesItsTimeFromTheBusClock) {
  const auto session = sim::open_panel("ili9341");
  ASSERT_EQ(session->show(16, [](int, int, std::span<std::uint16_t>) {}), Status::ok);
  // 320 × 240 × 16 bits at 10 MHz are 122,880 µs; windows and polling add little.
  EXPECT_NEAR(session->statistics().last_frame_us, 122'880, 500);
}

TEST(PanelRegistry, AboveTheRatingIsAWarningAndFarAboveAFailure) {
  const auto draw = [](int, int, std::span<std::uint16_t>) {};
  const auto fast = sim::open_panel("ili9341", {.clock_hz = 40'000'000});
  EXPECT_EQ(fast->show(16, draw), Status::ok);
  ASSERT_EQ(fast->complaints().size(), 1U);
  EXPECT_EQ(fast->complaints()[0].kind, sim::ComplaintKind::clock_above_rating);
  EXPECT_FALSE(any_failure(fast->complaints()));

  const auto too_fast = sim::open_panel("ili9341", {.clock_hz = 62'500'000});
  EXPECT_EQ(too_fast->show(16, draw), Status::bus_clock_too_high);
  EXPECT_TRUE(any_failure(too_fast->complaints()));
}

// The flipped orientations are not in the registry; the viewer sees the same picture when the panel is held that way.
template <hal::Orientation orientation>
void expect_upright() {
  using Driver = hal::Ili9341<sim::HostBus, sim::SimClock, orientation>;
  sim::SimClock clock;
  sim::Ili9341Model model(orientation);
  sim::HostBus bus(model, clock, 10'000'000);
  Driver driver(bus, clock);
  ASSERT_EQ(driver.init(), Status::ok);
  const Frame frame = random_frame(Driver::width, Driver::height, 3);
  Frame words = frame;
  for (std::uint16_t& word : words) word = hal::to_pixel_order(Driver::pixel_order, word);
  ASSERT_EQ(driver.write(0, Driver::height, words), Status::ok);
  while (driver.busy()) clock.delay_us(100);
  const sim::PanelPicture picture = model.picture();
  ASSERT_EQ(picture.width, Driver::width);
  for (std::size_t i = 0; i < frame.size(); ++i) {
    ASSERT_EQ((std::array<int, 3>{picture.rgb[3 * i], picture.rgb[3 * i + 1], picture.rgb[3 * i + 2]}),
              wanted_color("ili9341", frame[i]));
  }
  EXPECT_TRUE(model.complaints().empty());
}

TEST(Ili9341Orientation, AllFourAreUprightForTheirViewer) {
  expect_upright<hal::Orientation::portrait>();
  expect_upright<hal::Orientation::landscape>();
  expect_upright<hal::Orientation::portrait_flipped>();
  expect_upright<hal::Orientation::landscape_flipped>();
}

}  // namespace
}  // namespace spanline
