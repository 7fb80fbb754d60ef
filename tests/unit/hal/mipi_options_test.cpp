// Every option of the MIPI panels through driver and model: a picture is right for the viewer, and nothing is written
// into memory that the glass does not show.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "panels/fake_buses.hpp"
#include "panels/host_bus.hpp"
#include "panels/ili9341_model.hpp"
#include "panels/st7789_model.hpp"
#include "recording_bus.hpp"
#include "spanline/hal/panels/ili9341.hpp"
#include "spanline/hal/panels/st7789.hpp"

namespace spanline {
namespace {

using hal::ColourFormat;
using hal::DisplayStatus;
using hal::MipiOptions;
using hal::Orientation;
using sim::HostBus;
using sim::SimClock;
using sim::St7789Glass;
using Frame = std::vector<std::uint16_t>;

struct Tft {
  template <MipiOptions options>
  using Driver = hal::Ili9341<HostBus, SimClock, options>;
  static sim::Ili9341Model model(Orientation held) { return sim::Ili9341Model(held); }
};

template <hal::mipi::Glass glass, St7789Glass size>
struct Ips {
  template <MipiOptions options>
  using Driver = hal::St7789<glass, HostBus, SimClock, options>;
  static sim::St7789Model model(Orientation held) { return {size, held}; }
};
using Ips240x320 = Ips<hal::st7789::glass_240x320, St7789Glass::size_240x320>;
using Ips240x240 = Ips<hal::st7789::glass_240x240, St7789Glass::size_240x240>;
using Ips135x240 = Ips<hal::st7789::glass_135x240, St7789Glass::size_135x240>;

/// A driver at work on its panel.
template <class Parts, MipiOptions options>
struct Desk {
  using Driver = typename Parts::template Driver<options>;
  SimClock clock;
  decltype(Parts::model(options.orientation)) model = Parts::model(options.orientation);
  HostBus bus{model, clock, Driver::clock_rating.rated_hz};
  Driver driver{bus, clock};

  static std::vector<std::uint16_t> ordered(Frame words) {
    for (std::uint16_t& word : words) word = hal::to_pixel_order(Driver::pixel_order, word);
    return words;
  }
  /// Waits until everything has arrived; the first time, the panel goes on.
  void finish() {
    while (driver.busy()) clock.delay_us(100);
    model.end_of_stream();
    ASSERT_EQ(driver.switch_on(), DisplayStatus::ok);
  }
};

Frame random_frame(int width, int height) {
  std::mt19937 random(3);
  Frame frame(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (std::uint16_t& pixel : frame) pixel = static_cast<std::uint16_t>(random());
  return frame;
}

std::array<int, 3> wanted(std::uint16_t pixel, const MipiOptions& options) {
  int red = pixel >> 11, green = pixel >> 5 & 63, blue = pixel & 31;
  std::array<int, 3> rgb{red << 3 | red >> 2, green << 2 | green >> 4, blue << 3 | blue >> 2};
  if (options.colours == ColourFormat::rgb444) rgb = {(red >> 1) * 17, (green >> 2) * 17, (blue >> 1) * 17};
  if (options.swap_red_blue) std::swap(rgb[0], rgb[2]);
  if (options.inverted) rgb = {255 - rgb[0], 255 - rgb[1], 255 - rgb[2]};
  return rgb;
}

std::array<int, 3> at(const sim::PanelPicture& picture, int x, int y) {
  const std::uint8_t* rgb = picture.at(x, y);
  return {rgb[0], rgb[1], rgb[2]};
}

template <class Parts, MipiOptions options>
void expect_right() {
  Desk<Parts, options> desk;
  using Driver = typename Desk<Parts, options>::Driver;
  ASSERT_EQ(desk.driver.init(), DisplayStatus::ok);
  const Frame frame = random_frame(Driver::width, Driver::height);
  Frame words = desk.ordered(frame);
  ASSERT_EQ(desk.driver.write(0, Driver::height, words), DisplayStatus::ok);
  desk.finish();
  const sim::PanelPicture picture = desk.model.picture();
  ASSERT_EQ(picture.width, Driver::width);
  ASSERT_EQ(picture.height, Driver::height);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const int source = options.mirrored ? picture.width - 1 - x : x;
      const auto index = static_cast<std::size_t>(y * picture.width + source);
      ASSERT_EQ(at(picture, x, y), wanted(frame[index], options)) << x << ", " << y;
    }
  }
  EXPECT_EQ(desk.model.written_beside_the_glass(), 0U);
  for (const sim::Complaint& complaint : desk.model.complaints()) ADD_FAILURE() << describe(complaint);
}

template <class Parts, Orientation orientation>
void expect_right_however_held() {
  expect_right<Parts, MipiOptions{.orientation = orientation}>();
  expect_right<Parts, MipiOptions{.orientation = orientation, .mirrored = true}>();
}

template <class Parts>
void expect_right_in_all_orientations() {
  expect_right_however_held<Parts, Orientation::portrait>();
  expect_right_however_held<Parts, Orientation::landscape>();
  expect_right_however_held<Parts, Orientation::portrait_flipped>();
  expect_right_however_held<Parts, Orientation::landscape_flipped>();
}

TEST(MipiPanelOptions, EveryOrientationIsUprightAndMirrorsForItsViewer) {
  expect_right_in_all_orientations<Tft>();
  expect_right_in_all_orientations<Ips240x320>();
  expect_right_in_all_orientations<Ips240x240>();
  expect_right_in_all_orientations<Ips135x240>();
}

template <class Parts>
void expect_right_colours() {
  expect_right<Parts, MipiOptions{.swap_red_blue = true}>();
  expect_right<Parts, MipiOptions{.inverted = true}>();
}

TEST(MipiPanelOptions, ColoursSwapAndInvert) {
  expect_right_colours<Tft>();
  expect_right_colours<Ips240x240>();
}

TEST(MipiPanelOptions, TwelveBitsAPixel) {
  constexpr auto packed = ColourFormat::rgb444;
  expect_right<Ips240x320, MipiOptions{.colours = packed}>();
  expect_right<Ips240x240, MipiOptions{.orientation = Orientation::portrait_flipped, .colours = packed}>();
  expect_right<Ips135x240, MipiOptions{.colours = packed}>();
}

TEST(MipiPanelOptions, APartialWindowChangesNothingElse) {
  Desk<Ips135x240, MipiOptions{}> desk;
  ASSERT_EQ(desk.driver.init(), DisplayStatus::ok);
  Frame all = desk.ordered(Frame(240 * 135, 0x1234)), part = desk.ordered(Frame(20 * 10, 0xFFFF));
  ASSERT_EQ(desk.driver.write(0, 135, all), DisplayStatus::ok);
  desk.finish();
  const hal::Window window{30, 50, 50, 60};
  ASSERT_EQ(desk.driver.draw(window, part), DisplayStatus::ok);
  desk.finish();
  const sim::PanelPicture picture = desk.model.picture();
  for (int y = 0; y < 135; ++y) {
    for (int x = 0; x < 240; ++x) {
      const bool inside = x >= window.x0 && x < window.x1 && y >= window.y0 && y < window.y1;
      ASSERT_EQ(at(picture, x, y), wanted(inside ? 0xFFFF : 0x1234, {})) << x << ", " << y;
    }
  }
  EXPECT_EQ(desk.driver.draw({30, 50, 241, 60}, part), DisplayStatus::window_out_of_range);
  EXPECT_EQ(desk.driver.draw({30, 50, 51, 60}, part), DisplayStatus::buffer_too_small);
  EXPECT_TRUE(desk.model.complaints().empty());
}

TEST(MipiPanelOptions, ABandAfterAPartialWindowGoesToItsOwnRows) {
  Desk<Ips240x320, MipiOptions{}> desk;
  ASSERT_EQ(desk.driver.init(), DisplayStatus::ok);
  Frame all = desk.ordered(Frame(320 * 240, 0)), band = desk.ordered(Frame(320 * 8, 0x0F0F)),
        part = desk.ordered(Frame(4, 0xFFFF));
  ASSERT_EQ(desk.driver.write(0, 240, all), DisplayStatus::ok);
  desk.finish();
  ASSERT_EQ(desk.driver.write(0, 8, band), DisplayStatus::ok);
  desk.finish();
  ASSERT_EQ(desk.driver.draw({100, 100, 102, 102}, part), DisplayStatus::ok);
  desk.finish();
  ASSERT_EQ(desk.driver.write(8, 16, band), DisplayStatus::ok);
  desk.finish();
  const sim::PanelPicture picture = desk.model.picture();
  EXPECT_EQ(at(picture, 0, 8), wanted(0x0F0F, {}));
  EXPECT_EQ(at(picture, 319, 15), wanted(0x0F0F, {}));
  EXPECT_EQ(at(picture, 101, 101), wanted(0xFFFF, {}));
  EXPECT_TRUE(desk.model.complaints().empty());
}

TEST(MipiPanelOptions, InversionGoesBothWaysAtRunTime) {
  Desk<Ips240x240, MipiOptions{.orientation = Orientation::portrait}> desk;
  EXPECT_EQ(desk.driver.invert(true), DisplayStatus::panel_not_ready);
  ASSERT_EQ(desk.driver.init(), DisplayStatus::ok);
  Frame words = desk.ordered(Frame(240 * 240, 0x8410));
  ASSERT_EQ(desk.driver.write(0, 240, words), DisplayStatus::ok);
  desk.finish();
  ASSERT_EQ(desk.driver.invert(true), DisplayStatus::ok);
  EXPECT_EQ(at(desk.model.picture(), 5, 5), wanted(0x8410, {.inverted = true}));
  ASSERT_EQ(desk.driver.invert(false), DisplayStatus::ok);
  EXPECT_EQ(at(desk.model.picture(), 5, 5), wanted(0x8410, {}));
}

TEST(MipiPanelOptions, ALineThatSaysNothingIsAWarningAndThePanelWorks) {
  SimClock clock;
  sim::St7789Model model(St7789Glass::size_240x320, Orientation::landscape);
  HostBus wires(model, clock, 62'500'000);
  sim::PluggedBus bus(wires);
  hal::St7789<hal::st7789::glass_240x320, sim::PluggedBus, SimClock> driver(bus, clock);
  bus.plug(false);
  EXPECT_EQ(driver.init(), DisplayStatus::ok);
  EXPECT_EQ(driver.identity_status(), DisplayStatus::panel_unidentified);
  bus.plug(true);
  EXPECT_EQ(driver.init(), DisplayStatus::ok);
  EXPECT_EQ(driver.identity_status(), DisplayStatus::ok);
  EXPECT_TRUE(model.complaints().empty());
}

TEST(MipiPanelOptions, AnotherChipIsAWarning) {
  SimClock clock;
  sim::Ili9341Model model(Orientation::landscape);
  HostBus bus(model, clock, 10'000'000);
  hal::St7789<hal::st7789::glass_240x320, HostBus, SimClock> driver(bus, clock);
  EXPECT_EQ(driver.init(), DisplayStatus::ok);
  EXPECT_EQ(driver.identity_status(), DisplayStatus::panel_unidentified);
}

/// A bus whose answer to every question a test gives.
struct AnsweringBus : test::RecordingBus {
  using RecordingBus::RecordingBus;
  DisplayStatus read(std::uint8_t command, std::span<std::uint8_t> into) {
    EXPECT_EQ(command, 0xD3);
    EXPECT_EQ(into.size(), answer.size());
    std::copy(answer.begin(), answer.end(), into.begin());
    return DisplayStatus::ok;
  }
  std::array<std::uint8_t, 4> answer{};
};

DisplayStatus identity_status(std::array<std::uint8_t, 4> answer) {
  SimClock clock;
  AnsweringBus bus(clock);
  bus.answer = answer;
  hal::Ili9341<AnsweringBus, SimClock> driver(bus, clock);
  EXPECT_EQ(driver.init(), DisplayStatus::ok);
  return driver.identity_status();
}

TEST(MipiPanelOptions, TheFirstByteOfAnIdentityMeansNothing) {
  for (const std::uint8_t first : {std::uint8_t{0x00}, std::uint8_t{0xFF}, std::uint8_t{0x5A}})
    EXPECT_EQ(identity_status({first, 0x00, 0x93, 0x41}), DisplayStatus::ok) << int{first};
}

TEST(MipiPanelOptions, EachOtherByteOfAnIdentityCounts) {
  EXPECT_EQ(identity_status({0x00, 0x01, 0x93, 0x41}), DisplayStatus::panel_unidentified);
  EXPECT_EQ(identity_status({0x00, 0x00, 0x92, 0x41}), DisplayStatus::panel_unidentified);
  EXPECT_EQ(identity_status({0x00, 0x00, 0x93, 0x40}), DisplayStatus::panel_unidentified);
}

}  // namespace
}  // namespace spanline
