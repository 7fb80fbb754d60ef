// What the viewer sees around failures: light comes behind the first picture, a transfer that broke off shifts no row
// of a later picture, and a panel that lost its power comes back when it is asked for.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "panels/fake_buses.hpp"
#include "panels/host_bus.hpp"
#include "panels/ili9341_model.hpp"
#include "panels/sim_clock.hpp"
#include "panels/ssd0323_model.hpp"
#include "panels/st7789_model.hpp"
#include "recording_bus.hpp"
#include "spanline/hal/panels/ili9341.hpp"
#include "spanline/hal/panels/ssd0323.hpp"
#include "spanline/hal/panels/st7789.hpp"
#include "spanline/hal/present.hpp"

namespace spanline {
namespace {

using hal::DisplayStatus;
using hal::MipiOptions;
using hal::Orientation;
using sim::FailingBus;
using sim::HostBus;
using sim::SimClock;

struct Tft {
  template <class Bus>
  using Driver = hal::Ili9341<Bus, SimClock>;
  static sim::Ili9341Model model() { return sim::Ili9341Model(Orientation::landscape); }
};
struct Ips {
  template <class Bus>
  using Driver = hal::St7789<hal::st7789::glass_135x240, Bus, SimClock>;
  static sim::St7789Model model() { return {sim::St7789Glass::size_135x240, Orientation::landscape}; }
};
struct PackedIps {
  template <class Bus>
  using Driver =
      hal::St7789<hal::st7789::glass_240x320, Bus, SimClock, MipiOptions{.colours = hal::ColourFormat::rgb444}>;
  static sim::St7789Model model() { return {sim::St7789Glass::size_240x320, Orientation::landscape}; }
};
struct Oled {
  template <class Bus>
  using Driver = hal::Ssd0323<Bus, SimClock>;
  static sim::Ssd0323Model model() { return {}; }
};

/// A panel, its driver and a present loop, with a bus on which one transfer may fail.
template <class Parts>
struct Desk {
  using Driver = typename Parts::template Driver<FailingBus>;
  static constexpr int width = Driver::width, height = Driver::height, rows = 8;

  explicit Desk(DisplayStatus failure = DisplayStatus::bus_timeout) : bus(wires, clock, failure) {}

  SimClock clock;
  decltype(Parts::model()) model = Parts::model();
  HostBus wires{model, clock, Driver::clock_rating.rated_hz};
  FailingBus bus;
  Driver driver{bus, clock};
  std::vector<std::uint16_t> first = std::vector<std::uint16_t>(static_cast<std::size_t>(width) * rows);
  std::vector<std::uint16_t> second = first;
  hal::Present<Driver, SimClock> present{driver, clock, first, second};

  /// Every pixel differs from its neighbours, so that rows or columns that are shifted show.
  static std::uint16_t pixel(int x, int y, unsigned frame) {
    const auto value = static_cast<std::uint16_t>(static_cast<unsigned>(x * 2011 + y * 4099) + frame * 977);
    return hal::to_pixel_order(Driver::pixel_order, value);
  }
  static void draw(std::span<std::uint16_t> band, int y0, unsigned frame) {
    for (std::size_t i = 0; i < band.size(); ++i)
      band[i] = pixel(static_cast<int>(i) % width, y0 + static_cast<int>(i) / width, frame);
  }

  /// Rows from `top` on: a program may send a part of the picture alone.
  DisplayStatus show(unsigned frame, int top = 0) {
    DisplayStatus status = present.begin_frame();
    for (int y = top, index = 0; status == DisplayStatus::ok && y < height; y += rows, index ^= 1) {
      const int end = std::min(y + rows, height);
      status = present.acquire(index);
      if (status != DisplayStatus::ok) break;
      draw(present.buffer(index), y, frame);
      status = present.submit(y, end, index);
    }
    const DisplayStatus ended = present.end_frame();
    return status == DisplayStatus::ok ? ended : status;
  }

  std::vector<std::uint8_t> seen() const { return model.picture().rgb; }
  /// What the viewer sees of a frame on a panel that nothing ever happened to.
  static std::vector<std::uint8_t> wanted(unsigned frame) {
    Desk other;
    EXPECT_EQ(other.show(frame), DisplayStatus::ok);
    return other.seen();
  }
  bool is_dark() const {
    const std::vector<std::uint8_t> rgb = seen();
    return std::all_of(rgb.begin(), rgb.end(), [](std::uint8_t channel) { return channel == 0; });
  }
  void expect_no_complaints() const {
    for (const sim::Complaint& complaint : model.complaints()) ADD_FAILURE() << describe(complaint);
  }
};

template <class Parts>
class PanelRecovery : public testing::Test {};
using AllParts = testing::Types<Tft, Ips, PackedIps, Oled>;
TYPED_TEST_SUITE(PanelRecovery, AllParts);

TYPED_TEST(PanelRecovery, IsDarkUntilTheFirstPictureIsThere) {
  Desk<TypeParam> desk;
  ASSERT_EQ(desk.present.begin_frame(), DisplayStatus::ok);
  for (int y = 0; y < desk.height; y += desk.rows) {
    ASSERT_EQ(desk.present.acquire(0), DisplayStatus::ok);
    desk.draw(desk.present.buffer(0), y, 1);
    ASSERT_EQ(desk.present.submit(y, std::min(y + desk.rows, desk.height), 0), DisplayStatus::ok);
    ASSERT_TRUE(desk.is_dark());
  }
  ASSERT_EQ(desk.present.end_frame(), DisplayStatus::ok);
  EXPECT_EQ(desk.seen(), Desk<TypeParam>::wanted(1));
  EXPECT_FALSE(desk.is_dark());
  desk.expect_no_complaints();
}

TYPED_TEST(PanelRecovery, AFirstFrameThatFailsStaysDark) {
  Desk<TypeParam> desk;
  desk.bus.fail_at(3, 11);
  EXPECT_NE(desk.show(1), DisplayStatus::ok);
  EXPECT_TRUE(desk.is_dark());
  EXPECT_EQ(desk.show(2), DisplayStatus::ok);
  EXPECT_EQ(desk.seen(), Desk<TypeParam>::wanted(2));
}

TYPED_TEST(PanelRecovery, AnErrorInMidBandShiftsNoRowOfTheNextFrame) {
  for (const DisplayStatus failure : {DisplayStatus::bus_timeout, DisplayStatus::bus_busy}) {
    Desk<TypeParam> desk(failure);
    ASSERT_EQ(desk.show(1), DisplayStatus::ok);
    desk.bus.fail_at(4, 13);
    EXPECT_EQ(desk.show(2), failure);
    EXPECT_EQ(desk.show(3), DisplayStatus::ok);
    EXPECT_EQ(desk.seen(), Desk<TypeParam>::wanted(3)) << to_string(failure);
    EXPECT_EQ(desk.present.statistics().initialisations, failure == DisplayStatus::bus_timeout ? 2U : 1U);
  }
}

// The frame after the error begins with just the row at which the driver would have gone on.
TYPED_TEST(PanelRecovery, AnErrorInMidBandShiftsNoRowOfAPartThatFollows) {
  using Desk = Desk<TypeParam>;
  Desk desk(DisplayStatus::bus_busy);
  ASSERT_EQ(desk.show(1), DisplayStatus::ok);
  desk.bus.fail_at(1, 13);
  EXPECT_EQ(desk.show(1), DisplayStatus::bus_busy);
  EXPECT_EQ(desk.show(1, Desk::rows), DisplayStatus::ok);
  const std::vector<std::uint8_t> seen = desk.seen(), wanted = Desk::wanted(1);
  EXPECT_EQ(seen, wanted) << "the rows that were not sent again are those of the first frame";
}

TYPED_TEST(PanelRecovery, APanelThatLostItsPowerComesBackWhenItIsAskedFor) {
  Desk<TypeParam> desk;
  ASSERT_EQ(desk.show(1), DisplayStatus::ok);
  desk.model.lose_power(desk.clock.now_ns());
  desk.present.restart_panel();
  ASSERT_EQ(desk.show(2), DisplayStatus::ok);
  EXPECT_EQ(desk.seen(), Desk<TypeParam>::wanted(2));
  EXPECT_EQ(desk.present.statistics().initialisations, 2U);
  desk.expect_no_complaints();
}

TYPED_TEST(PanelRecovery, WithoutTheCallItStaysDarkAndItsModelComplains) {
  Desk<TypeParam> desk;
  ASSERT_EQ(desk.show(1), DisplayStatus::ok);
  desk.model.lose_power(desk.clock.now_ns());
  ASSERT_EQ(desk.show(2), DisplayStatus::ok);
  EXPECT_TRUE(desk.is_dark());
  EXPECT_TRUE(any_failure(desk.model.complaints()));
}

TYPED_TEST(PanelRecovery, TheCallAbandonsBandsThatAreStillOnTheirWay) {
  Desk<TypeParam> desk;
  ASSERT_EQ(desk.show(1), DisplayStatus::ok);
  ASSERT_EQ(desk.present.begin_frame(), DisplayStatus::ok);
  ASSERT_EQ(desk.present.acquire(0), DisplayStatus::ok);
  ASSERT_EQ(desk.present.submit(0, desk.rows, 0), DisplayStatus::ok);
  ASSERT_EQ(desk.present.end_frame_early(), DisplayStatus::ok);
  ASSERT_TRUE(desk.driver.busy());
  desk.model.lose_power(desk.clock.now_ns());
  desk.present.restart_panel();
  ASSERT_EQ(desk.show(2), DisplayStatus::ok);
  EXPECT_EQ(desk.seen(), Desk<TypeParam>::wanted(2));
  desk.expect_no_complaints();
}

/// Writes down what happens to the backlight among the commands, as a command FFh or 00h of two bytes.
struct LitRecordingBus : test::RecordingBus {
  using RecordingBus::RecordingBus;
  void backlight(bool lit) { static_cast<void>(command(lit ? test::Bytes{0xFF, 0xFF} : test::Bytes{0x00, 0x00})); }
};

TEST(Backlight, GoesOffBeforeTheDisplayAndOnBehindIt) {
  SimClock clock;
  LitRecordingBus bus(clock);
  hal::Ili9341<LitRecordingBus, SimClock> driver(bus, clock);
  static_assert(hal::BacklitBus<LitRecordingBus> && !hal::BacklitBus<test::RecordingBus>);
  const test::Bytes on{0xFF, 0xFF}, off{0x00, 0x00};
  ASSERT_EQ(driver.init(), DisplayStatus::ok);
  EXPECT_EQ(bus.events[0].bytes, off) << "before the reset";
  bus.events.clear();
  ASSERT_EQ(driver.switch_on(), DisplayStatus::ok);
  ASSERT_EQ(driver.sleep(true), DisplayStatus::ok);
  ASSERT_EQ(driver.sleep(false), DisplayStatus::ok);
  EXPECT_EQ(bus.commands(), (std::vector<test::Bytes>{{0x29}, on, off, {0x28}, {0x10}, {0x11}, {0x29}, on}));
}

}  // namespace
}  // namespace spanline
