#include "spanline/hal/panels/ili9341.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "panels/sim_clock.hpp"
#include "recording_bus.hpp"

namespace spanline {
namespace {

using hal::DisplayStatus;
using hal::Orientation;
using test::Bytes;
using test::RecordingBus;
using Kind = RecordingBus::Event::Kind;

template <Orientation orientation>
using Driver = hal::Ili9341<RecordingBus, sim::SimClock, hal::MipiOptions{.orientation = orientation}>;
using Landscape = Driver<Orientation::landscape>;
using Portrait = Driver<Orientation::portrait>;

static_assert(hal::Panel<Landscape> && Landscape::width == 320 && Landscape::height == 240);
static_assert(hal::Panel<Portrait> && Portrait::width == 240 && Portrait::height == 320);

// Every command from reset to a panel that is awake and dark, as the datasheet spells it; the last byte turns the
// picture.
std::vector<Bytes> init_commands(std::uint8_t memory_access) {
  return {{0x01},
          {0xCF, 0x00, 0xC1, 0x30},
          {0xED, 0x64, 0x03, 0x12, 0x81},
          {0xE8, 0x85, 0x00, 0x78},
          {0xCB, 0x39, 0x2C, 0x00, 0x34, 0x02},
          {0xF7, 0x20},
          {0xEA, 0x00, 0x00},
          {0xC0, 0x23},
          {0xC1, 0x10},
          {0xC5, 0x3E, 0x28},
          {0xC7, 0x86},
          {0x3A, 0x55},
          {0xB1, 0x00, 0x18},
          {0xB6, 0x08, 0x82, 0x27},
          {0xF2, 0x00},
          {0x26, 0x01},
          {0xE0, 0x0F, 0x31, 0x2B, 0x0C, 0x0E, 0x08, 0x4E, 0xF1, 0x37, 0x07, 0x10, 0x03, 0x0E, 0x09, 0x00},
          {0xE1, 0x00, 0x0E, 0x14, 0x03, 0x11, 0x07, 0x31, 0xC1, 0x48, 0x08, 0x0F, 0x0C, 0x31, 0x36, 0x0F},
          {0x11},
          {0x36, memory_access}};
}

template <Orientation orientation>
std::vector<Bytes> commands_of_init() {
  sim::SimClock clock;
  RecordingBus bus(clock);
  Driver<orientation> driver(bus, clock);
  EXPECT_EQ(driver.init(), DisplayStatus::ok);
  return bus.commands();
}

TEST(Ili9341, InitSendsExactlyTheTable) {
  EXPECT_EQ(commands_of_init<Orientation::portrait>(), init_commands(0x48));
  EXPECT_EQ(commands_of_init<Orientation::landscape>(), init_commands(0x28));
  EXPECT_EQ(commands_of_init<Orientation::portrait_flipped>(), init_commands(0x88));
  EXPECT_EQ(commands_of_init<Orientation::landscape_flipped>(), init_commands(0xE8));
}

TEST(Ili9341, InitKeepsTheDatasheetPauses) {
  sim::SimClock clock;
  RecordingBus bus(clock);
  Landscape driver(bus, clock);
  ASSERT_EQ(driver.init(), DisplayStatus::ok);
  const auto& events = bus.events;
  ASSERT_EQ(events[0].kind, Kind::reset_low);
  ASSERT_EQ(events[1].kind, Kind::reset_high);
  EXPECT_GE(events[1].at_us - events[0].at_us, 10U);
  EXPECT_EQ(events[2].bytes, Bytes{0x01});
  EXPECT_GE(events[2].at_us - events[1].at_us, 120'000U);
  EXPECT_GE(events[3].at_us - events[2].at_us, 120'000U);
  const std::size_t sleep_out = events.size() - 2;
  EXPECT_EQ(events[sleep_out].bytes, Bytes{0x11});
  EXPECT_GE(events[sleep_out + 1].at_us - events[sleep_out].at_us, 120'000U);
}

class Ili9341Ready : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(driver_.init(), DisplayStatus::ok);
    bus_.events.clear();
  }

  sim::SimClock clock_;
  RecordingBus bus_{clock_};
  Landscape driver_{bus_, clock_};
};

TEST_F(Ili9341Ready, WindowIsInclusiveAndHighByteFirst) {
  EXPECT_EQ(driver_.window({0, 0, 320, 240}), DisplayStatus::ok);
  EXPECT_EQ(driver_.window({258, 17, 300, 18}), DisplayStatus::ok);
  EXPECT_EQ(bus_.commands(), (std::vector<Bytes>{{0x2A, 0x00, 0x00, 0x01, 0x3F},
                                                 {0x2B, 0x00, 0x00, 0x00, 0xEF},
                                                 {0x2C},
                                                 {0x2A, 0x01, 0x02, 0x01, 0x2B},
                                                 {0x2B, 0x00, 0x11, 0x00, 0x11},
                                                 {0x2C}}));
}

TEST_F(Ili9341Ready, WriteSendsTheWordsAsTheyLie) {
  std::vector<std::uint16_t> pixels(320 * 2 + 5);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    pixels[i] = hal::to_pixel_order(Landscape::pixel_order, static_cast<std::uint16_t>(i));
  }
  ASSERT_EQ(driver_.write(238, 240, pixels), DisplayStatus::ok);
  EXPECT_EQ(bus_.commands(),
            (std::vector<Bytes>{{0x2A, 0x00, 0x00, 0x01, 0x3F}, {0x2B, 0x00, 0xEE, 0x00, 0xEF}, {0x2C}}));
  const Bytes& sent = bus_.events.back().bytes;
  ASSERT_EQ(bus_.events.back().kind, Kind::pixels);
  ASSERT_EQ(sent.size(), 320U * 2 * 2);
  for (std::size_t i = 0; i < 640; ++i) {
    ASSERT_EQ(sent[2 * i], i >> 8);
    ASSERT_EQ(sent[2 * i + 1], i & 255);
  }
}

TEST_F(Ili9341Ready, RefusesWhatTheGlassDoesNotHaveAndSendsNothing) {
  std::vector<std::uint16_t> pixels(320);
  EXPECT_EQ(driver_.window({0, 0, 321, 240}), DisplayStatus::window_out_of_range);
  EXPECT_EQ(driver_.window({0, 0, 320, 241}), DisplayStatus::window_out_of_range);
  EXPECT_EQ(driver_.window({5, 0, 5, 240}), DisplayStatus::window_out_of_range);
  EXPECT_EQ(driver_.write(240, 241, pixels), DisplayStatus::window_out_of_range);
  EXPECT_EQ(driver_.write(-1, 0, pixels), DisplayStatus::window_out_of_range);
  EXPECT_EQ(driver_.write(0, 2, pixels), DisplayStatus::buffer_too_small);
  EXPECT_TRUE(bus_.events.empty());
}

TEST_F(Ili9341Ready, RefusesWhileTheBusIsBusy) {
  std::vector<std::uint16_t> pixels(320);
  bus_.is_busy = true;
  EXPECT_EQ(driver_.window({0, 0, 320, 240}), DisplayStatus::bus_busy);
  EXPECT_EQ(driver_.write(0, 1, pixels), DisplayStatus::bus_busy);
  EXPECT_EQ(driver_.sleep(true), DisplayStatus::bus_busy);
  EXPECT_TRUE(bus_.events.empty());
}

TEST_F(Ili9341Ready, SwitchesOnOnce) {
  EXPECT_EQ(driver_.switch_on(), DisplayStatus::ok);
  EXPECT_EQ(driver_.switch_on(), DisplayStatus::ok);
  EXPECT_EQ(bus_.commands(), std::vector<Bytes>{{0x29}});
}

TEST_F(Ili9341Ready, APanelThatFellAsleepInTheDarkWakesUpDark) {
  EXPECT_EQ(driver_.sleep(true), DisplayStatus::ok);
  EXPECT_EQ(driver_.switch_on(), DisplayStatus::panel_asleep);
  EXPECT_EQ(driver_.sleep(false), DisplayStatus::ok);
  EXPECT_EQ(bus_.commands(), (std::vector<Bytes>{{0x28}, {0x10}, {0x11}}));
}

TEST_F(Ili9341Ready, SleepsAndWakesWithItsPauses) {
  std::vector<std::uint16_t> pixels(320);
  ASSERT_EQ(driver_.switch_on(), DisplayStatus::ok);
  bus_.events.clear();
  const std::uint64_t start_us = clock_.now_ns() / 1000;
  EXPECT_EQ(driver_.sleep(true), DisplayStatus::ok);
  EXPECT_EQ(driver_.sleep(true), DisplayStatus::ok);  // again: nothing to do
  EXPECT_EQ(driver_.write(0, 1, pixels), DisplayStatus::panel_asleep);
  EXPECT_EQ(driver_.window({0, 0, 1, 1}), DisplayStatus::panel_asleep);
  EXPECT_EQ(driver_.sleep(false), DisplayStatus::ok);
  EXPECT_EQ(bus_.commands(), (std::vector<Bytes>{{0x28}, {0x10}, {0x11}, {0x29}}));
  EXPECT_GE(bus_.events[2].at_us - bus_.events[1].at_us, 120'000U);
  EXPECT_GE(bus_.events[3].at_us - start_us, 240'000U);
  EXPECT_EQ(driver_.write(0, 1, pixels), DisplayStatus::ok);
}

TEST(Ili9341, NothingWorksBeforeInit) {
  sim::SimClock clock;
  RecordingBus bus(clock);
  Landscape driver(bus, clock);
  std::vector<std::uint16_t> pixels(320);
  EXPECT_EQ(driver.write(0, 1, pixels), DisplayStatus::panel_not_ready);
  EXPECT_EQ(driver.window({0, 0, 1, 1}), DisplayStatus::panel_not_ready);
  EXPECT_EQ(driver.switch_on(), DisplayStatus::panel_not_ready);
  EXPECT_EQ(driver.sleep(true), DisplayStatus::panel_not_ready);
}

TEST(Ili9341, ChecksTheBusClock) {
  sim::SimClock clock;
  for (const auto& [hz, want] : {std::pair{10'000'000U, DisplayStatus::ok},
                                 {40'000'000U, DisplayStatus::ok},
                                 {40'000'001U, DisplayStatus::bus_clock_too_high}}) {
    RecordingBus bus(clock, hz);
    Landscape driver(bus, clock);
    EXPECT_EQ(driver.init(), want) << hz;
  }
}

TEST(Ili9341, InitSaysThatTheBusDoesNotAnswer) {
  sim::SimClock clock;
  RecordingBus bus(clock);
  Landscape driver(bus, clock);
  bus.is_busy = true;
  EXPECT_EQ(driver.init(), DisplayStatus::bus_timeout);
  EXPECT_LT(clock.now_ns(), 1'000'000U);  // found out before the long pauses
  bus.is_busy = false;
  bus.commands_time_out = true;
  EXPECT_EQ(driver.init(), DisplayStatus::bus_timeout);
  EXPECT_EQ(driver.sleep(true), DisplayStatus::panel_not_ready);
  bus.commands_time_out = false;
  EXPECT_EQ(driver.init(), DisplayStatus::ok);
}

}  // namespace
}  // namespace spanline
