#include "panels/panel_registry.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "recording_bus.hpp"
#include "spanline/hal/panels/ssd0323.hpp"

namespace spanline {
namespace {

using hal::DisplayStatus;
using hal::PixelOrder;
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
  if (panel.ends_with("-444")) return {(red >> 1) * 17, (green >> 2) * 17, (blue >> 1) * 17};
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
  EXPECT_EQ(names, (std::set<std::string_view>{"ili9341", "ili9341-portrait", "st7789", "st7789-portrait", "st7789-444",
                                               "st7789-240x240", "st7789-135x240", "ssd0323"}));
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
        ASSERT_EQ(session->show(band, copy_from(frame, info.width, order)), DisplayStatus::ok);
        expect_picture(*session, frame);
      }
      EXPECT_TRUE(session->complaints().empty()) << describe(session->complaints().front());
    }
  }
}

TEST(PanelRegistry, SleepIsDarkAndWakesUpWithItsPicture) {
  for (const sim::PanelInfo& info : sim::panels()) {
    const auto session = sim::open_panel(info.name);
    EXPECT_EQ(session->sleep(true), DisplayStatus::panel_not_ready);
    const Frame frame = random_frame(info.width, info.height, 9);
    const sim::DrawBand draw = copy_from(frame, info.width, PixelOrder::native);
    ASSERT_EQ(session->show(16, draw), DisplayStatus::ok);
    ASSERT_EQ(session->sleep(true), DisplayStatus::ok);
    const sim::PanelPicture dark = session->picture();
    EXPECT_EQ(std::count(dark.rgb.begin(), dark.rgb.end(), 0), static_cast<std::ptrdiff_t>(dark.rgb.size()));
    EXPECT_EQ(session->show(16, draw), DisplayStatus::panel_asleep);
    ASSERT_EQ(session->sleep(false), DisplayStatus::ok);
    expect_picture(*session, frame);
    EXPECT_TRUE(session->complaints().empty());
  }
}

TEST(PanelRegistry, TakesItsTimeFromTheBusClock) {
  const auto session = sim::open_panel("ili9341");
  ASSERT_EQ(session->show(16, [](int, int, std::span<std::uint16_t>) {}), DisplayStatus::ok);
  // 320 × 240 × 16 bits at 10 MHz are 122,880 µs; windows and polling add little.
  EXPECT_NEAR(session->statistics().last_frame_us, 122'880, 500);
}

TEST(PanelRegistry, FewerBitsAPixelTakeThreeQuartersOfTheTime) {
  const auto full = sim::open_panel("st7789"), packed = sim::open_panel("st7789-444");
  const auto draw = [](int, int, std::span<std::uint16_t>) {};
  ASSERT_EQ(full->show(16, draw), DisplayStatus::ok);
  ASSERT_EQ(packed->show(16, draw), DisplayStatus::ok);
  // 320 × 240 × 16 bits at 62.5 MHz are 19,661 µs, and × 12 bits 14,746.
  EXPECT_NEAR(full->statistics().last_frame_us, 19'661, 100);
  EXPECT_NEAR(packed->statistics().last_frame_us, 14'746, 100);
}

TEST(PanelRegistry, GivesModelsByName) {
  EXPECT_EQ(sim::make_panel_model("vga"), nullptr);
  for (const sim::PanelInfo& info : sim::panels()) {
    const auto model = sim::make_panel_model(info.name);
    ASSERT_NE(model, nullptr);
    EXPECT_EQ(model->picture().width, info.width);
    EXPECT_EQ(model->picture().height, info.height);
  }
}

TEST(PanelRegistry, AboveTheRatingIsAWarningAndFarAboveAFailure) {
  const auto draw = [](int, int, std::span<std::uint16_t>) {};
  const auto fast = sim::open_panel("ili9341", {.clock_hz = 40'000'000});
  EXPECT_EQ(fast->show(16, draw), DisplayStatus::ok);
  ASSERT_EQ(fast->complaints().size(), 1U);
  EXPECT_EQ(fast->complaints()[0].kind, sim::ComplaintKind::clock_above_rating);
  EXPECT_FALSE(any_failure(fast->complaints()));

  const auto too_fast = sim::open_panel("ili9341", {.clock_hz = 62'500'000});
  EXPECT_EQ(too_fast->show(16, draw), DisplayStatus::bus_clock_too_high);
  EXPECT_TRUE(any_failure(too_fast->complaints()));

  const auto rated = sim::open_panel("st7789", {.clock_hz = 62'500'000});
  EXPECT_EQ(rated->show(16, draw), DisplayStatus::ok);
  EXPECT_TRUE(rated->complaints().empty());
  const auto above = sim::open_panel("st7789", {.clock_hz = 80'000'000});
  EXPECT_EQ(above->show(16, draw), DisplayStatus::ok);
  EXPECT_EQ(above->complaints().size(), 1U);
  EXPECT_FALSE(any_failure(above->complaints()));
  EXPECT_EQ(sim::open_panel("st7789", {.clock_hz = 80'000'001})->show(16, draw), DisplayStatus::bus_clock_too_high);
}

}  // namespace
}  // namespace spanline
