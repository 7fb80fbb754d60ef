#include "spanline/hal/panels/ssd0323.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "panels/sim_clock.hpp"
#include "recording_bus.hpp"

namespace spanline {
namespace {

using hal::DisplayStatus;
using test::Bytes;
using test::RecordingBus;
using Driver = hal::Ssd0323<RecordingBus, sim::SimClock>;

static_assert(hal::Panel<Driver> && Driver::width == 128 && Driver::height == 64);

// All bytes of all commands in a row; the driver sends them one a call, which is checked here.
Bytes flat(const RecordingBus& bus) {
  Bytes all;
  for (const Bytes& command : bus.commands()) {
    EXPECT_EQ(command.size(), 1U) << "arguments go out with D/C low";
    all.insert(all.end(), command.begin(), command.end());
  }
  return all;
}

TEST(Ssd0323, InitSendsExactlyTheTable) {
  sim::SimClock clock;
  RecordingBus bus(clock);
  Driver driver(bus, clock);
  ASSERT_EQ(driver.init(), DisplayStatus::ok);
  EXPECT_EQ(flat(bus), (Bytes{0xAE, 0xB3, 0x91, 0xA8, 0x3F, 0xA2, 0x40, 0xA1, 0x00, 0xAD, 0x02, 0xA0,
                              0x52, 0x86, 0xB8, 0x01, 0x11, 0x22, 0x32, 0x43, 0x54, 0x65, 0x76, 0x81,
                              0x70, 0xB2, 0x51, 0xB1, 0x55, 0xBC, 0x10, 0xBE, 0x1C, 0xBF, 0x0F, 0xA4}));
  EXPECT_EQ(bus.events[0].kind, RecordingBus::Event::Kind::reset_low);
  EXPECT_EQ(bus.events[1].kind, RecordingBus::Event::Kind::reset_high);
}

class Ssd0323Ready : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(driver_.init(), DisplayStatus::ok);
    bus_.events.clear();
  }

  sim::SimClock clock_;
  RecordingBus bus_{clock_};
  Driver driver_{bus_, clock_};
};

TEST_F(Ssd0323Ready, WindowCountsPairsOfColumns) {
  EXPECT_EQ(driver_.window({0, 0, 128, 64}), DisplayStatus::ok);
  EXPECT_EQ(driver_.window({10, 3, 12, 4}), DisplayStatus::ok);
  EXPECT_EQ(flat(bus_), (Bytes{0x15, 0x00, 0x3F, 0x75, 0x00, 0x3F, 0x15, 0x05, 0x05, 0x75, 0x03, 0x03}));
}

TEST_F(Ssd0323Ready, WindowKeepsToTheColumnGrid) {
  EXPECT_EQ(driver_.window({1, 0, 128, 64}), DisplayStatus::window_out_of_range);
  EXPECT_EQ(driver_.window({0, 0, 127, 64}), DisplayStatus::window_out_of_range);
  EXPECT_EQ(driver_.window({0, 0, 130, 64}), DisplayStatus::window_out_of_range);
  EXPECT_EQ(driver_.window({0, 0, 128, 65}), DisplayStatus::window_out_of_range);
  EXPECT_TRUE(bus_.events.empty());
}

TEST_F(Ssd0323Ready, WritePacksTwoPixelsAByteLeftOneHigh) {
  std::vector<std::uint16_t> pixels(128 * 2, 0x0000);
  pixels[0] = 0xFFFF;
  pixels[255] = 0xFFFF;
  ASSERT_EQ(driver_.write(62, 64, pixels), DisplayStatus::ok);
  EXPECT_EQ(flat(bus_), (Bytes{0x15, 0x00, 0x3F, 0x75, 0x3E, 0x3F}));
  Bytes want(128, 0x00);
  want.front() = 0xF0;
  want.back() = 0x0F;
  EXPECT_EQ(bus_.events.back().bytes, want);
}

TEST_F(Ssd0323Ready, PackingInPlaceReadsEveryPixelBeforeItIsOverwritten) {
  std::vector<std::uint16_t> pixels(128 * 3);
  for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = static_cast<std::uint16_t>(i * 2654435761U >> 7);
  const std::vector<std::uint16_t> original = pixels;
  ASSERT_EQ(driver_.write(0, 3, pixels), DisplayStatus::ok);
  const Bytes& sent = bus_.events.back().bytes;
  ASSERT_EQ(sent.size(), original.size() / 2);
  for (std::size_t i = 0; i < original.size(); ++i) {
    const unsigned nibble = i % 2 == 0 ? sent[i / 2] >> 4U : sent[i / 2] & 15U;
    ASSERT_EQ(nibble, hal::ssd0323::grey_level(original[i])) << i;
  }
}

TEST_F(Ssd0323Ready, SleepIsDisplayOff) {
  std::vector<std::uint16_t> pixels(128);
  ASSERT_EQ(driver_.switch_on(), DisplayStatus::ok);
  ASSERT_EQ(driver_.switch_on(), DisplayStatus::ok);
  EXPECT_EQ(flat(bus_), Bytes{0xAF});
  bus_.events.clear();
  EXPECT_EQ(driver_.sleep(true), DisplayStatus::ok);
  EXPECT_EQ(driver_.write(0, 1, pixels), DisplayStatus::panel_asleep);
  EXPECT_EQ(driver_.sleep(false), DisplayStatus::ok);
  EXPECT_EQ(flat(bus_), (Bytes{0xAE, 0xAF}));
  EXPECT_EQ(driver_.write(0, 1, pixels), DisplayStatus::ok);
}

TEST_F(Ssd0323Ready, APanelThatFellAsleepInTheDarkWakesUpDark) {
  EXPECT_EQ(driver_.sleep(true), DisplayStatus::ok);
  EXPECT_EQ(driver_.sleep(false), DisplayStatus::ok);
  EXPECT_EQ(flat(bus_), (Bytes{0xAE, 0xAE}));
}

TEST_F(Ssd0323Ready, RefusesShortBuffersAndABusyBus) {
  std::vector<std::uint16_t> pixels(128);
  EXPECT_EQ(driver_.write(0, 2, pixels), DisplayStatus::buffer_too_small);
  bus_.is_busy = true;
  EXPECT_EQ(driver_.write(0, 1, pixels), DisplayStatus::bus_busy);
  EXPECT_EQ(driver_.sleep(true), DisplayStatus::bus_busy);
  EXPECT_TRUE(bus_.events.empty());
}

TEST(Ssd0323, ChecksTheBusClockAndTheBus) {
  sim::SimClock clock;
  RecordingBus fast(clock, 4'000'001);
  EXPECT_EQ(Driver(fast, clock).init(), DisplayStatus::bus_clock_too_high);
  RecordingBus stuck(clock, 4'000'000);
  stuck.is_busy = true;
  Driver driver(stuck, clock);
  std::vector<std::uint16_t> pixels(128);
  EXPECT_EQ(driver.init(), DisplayStatus::bus_timeout);
  EXPECT_EQ(driver.write(0, 1, pixels), DisplayStatus::panel_not_ready);
  EXPECT_EQ(driver.sleep(false), DisplayStatus::panel_not_ready);
}

// The formula against BT.601 in floating point, over all 65,536 colours: right save where the luma lies within the
// rounding of the weights of a step.
TEST(Ssd0323, GreyLevelFollowsTheLuma) {
  for (unsigned pixel = 0; pixel < 65536; ++pixel) {
    const double luma = 0.299 * (pixel >> 11) / 31 + 0.587 * (pixel >> 5 & 63) / 63 + 0.114 * (pixel & 31) / 31;
    const double scaled = luma * 255 / 16;
    const int level = hal::ssd0323::grey_level(static_cast<std::uint16_t>(pixel));
    ASSERT_LE(level, 15);
    ASSERT_GE(scaled, level - 0.007) << pixel;
    ASSERT_LT(scaled, level + 1.007) << pixel;
  }
  EXPECT_EQ(hal::ssd0323::grey_level(0x0000), 0);
  EXPECT_EQ(hal::ssd0323::grey_level(0xFFFF), 15);
}

}  // namespace
}  // namespace spanline
