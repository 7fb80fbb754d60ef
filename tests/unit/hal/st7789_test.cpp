#include "spanline/hal/panels/st7789.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "panels/sim_clock.hpp"
#include "recording_bus.hpp"

namespace spanline {
namespace {

using hal::ColourFormat;
using hal::DisplayStatus;
using hal::MipiOptions;
using hal::Orientation;
using test::Bytes;
using test::RecordingBus;

template <hal::mipi::Glass glass, MipiOptions options = MipiOptions{}>
using Driver = hal::St7789<glass, RecordingBus, sim::SimClock, options>;
using Landscape = Driver<hal::st7789::glass_240x320>;

static_assert(hal::Panel<Landscape> && Landscape::width == 320 && Landscape::height == 240);
static_assert(Driver<hal::st7789::glass_135x240>::width == 240 && Driver<hal::st7789::glass_135x240>::height == 135);

TEST(St7789, InitSendsExactlyTheTable) {
  sim::SimClock clock;
  RecordingBus bus(clock);
  Driver<hal::st7789::glass_240x320, MipiOptions{.colours = ColourFormat::rgb444}> driver(bus, clock);
  ASSERT_EQ(driver.init(), DisplayStatus::ok);
  EXPECT_EQ(bus.commands(),
            (std::vector<Bytes>{
                {0x01},
                {0x11},
                {0x3A, 0x55},
                {0xB2, 0x0C, 0x0C, 0x00, 0x33, 0x33},
                {0xB7, 0x35},
                {0xBB, 0x19},
                {0xC0, 0x2C},
                {0xC2, 0x01, 0xFF},
                {0xC3, 0x12},
                {0xC4, 0x20},
                {0xC6, 0x0F},
                {0xD0, 0xA4, 0xA1},
                {0xE0, 0xD0, 0x04, 0x0D, 0x11, 0x13, 0x2B, 0x3F, 0x54, 0x4C, 0x18, 0x0D, 0x0B, 0x1F, 0x23},
                {0xE1, 0xD0, 0x04, 0x0C, 0x11, 0x13, 0x2C, 0x3F, 0x44, 0x51, 0x2F, 0x1F, 0x1F, 0x20, 0x23},
                {0x13},
                {0x3A, 0x53},
                {0x21},
                {0x36, 0x60},
            }));
}

/// Memory access byte and the window commands for the picture's first and last pixel.
template <hal::mipi::Glass glass, Orientation orientation>
std::vector<Bytes> turned() {
  sim::SimClock clock;
  RecordingBus bus(clock);
  Driver<glass, MipiOptions{.orientation = orientation}> driver(bus, clock);
  EXPECT_EQ(driver.init(), DisplayStatus::ok);
  const Bytes access = bus.commands().back();
  bus.events.clear();
  EXPECT_EQ(driver.window({0, 0, driver.width, driver.height}), DisplayStatus::ok);
  std::vector<Bytes> all = bus.commands();
  all.insert(all.begin(), access);
  return all;
}

// Offsets as the makers of the modules state them: 52 or 53 columns and 40 rows for the narrow glass, 80 rows for the
// square one when it stands on its head.
TEST(St7789, OffsetsFollowTheOrientation) {
  using hal::st7789::glass_135x240, hal::st7789::glass_240x240;
  EXPECT_EQ((turned<glass_135x240, Orientation::portrait>()),
            (std::vector<Bytes>{{0x36, 0x00}, {0x2A, 0, 52, 0, 186}, {0x2B, 0, 40, 1, 23}, {0x2C}}));
  EXPECT_EQ((turned<glass_135x240, Orientation::landscape>()),
            (std::vector<Bytes>{{0x36, 0x60}, {0x2A, 0, 40, 1, 23}, {0x2B, 0, 53, 0, 187}, {0x2C}}));
  EXPECT_EQ((turned<glass_135x240, Orientation::portrait_flipped>()),
            (std::vector<Bytes>{{0x36, 0xC0}, {0x2A, 0, 53, 0, 187}, {0x2B, 0, 40, 1, 23}, {0x2C}}));
  EXPECT_EQ((turned<glass_135x240, Orientation::landscape_flipped>()),
            (std::vector<Bytes>{{0x36, 0xA0}, {0x2A, 0, 40, 1, 23}, {0x2B, 0, 52, 0, 186}, {0x2C}}));
  EXPECT_EQ((turned<glass_240x240, Orientation::portrait>()),
            (std::vector<Bytes>{{0x36, 0x00}, {0x2A, 0, 0, 0, 239}, {0x2B, 0, 0, 0, 239}, {0x2C}}));
  EXPECT_EQ((turned<glass_240x240, Orientation::portrait_flipped>()),
            (std::vector<Bytes>{{0x36, 0xC0}, {0x2A, 0, 0, 0, 239}, {0x2B, 0, 80, 1, 63}, {0x2C}}));
  EXPECT_EQ((turned<glass_240x240, Orientation::landscape_flipped>()),
            (std::vector<Bytes>{{0x36, 0xA0}, {0x2A, 0, 80, 1, 63}, {0x2B, 0, 0, 0, 239}, {0x2C}}));
}

class St7789Ready : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(driver_.init(), DisplayStatus::ok);
    bus_.events.clear();
  }

  sim::SimClock clock_;
  RecordingBus bus_{clock_};
  Landscape driver_{bus_, clock_};
  std::vector<std::uint16_t> band_ = std::vector<std::uint16_t>(320 * 8);
};

TEST_F(St7789Ready, BandsThatFollowOneAnotherNeedNoCommands) {
  for (int y = 0; y < 240; y += 8) ASSERT_EQ(driver_.write(y, y + 8, band_), DisplayStatus::ok);
  EXPECT_EQ(bus_.commands(), (std::vector<Bytes>{{0x2A, 0, 0, 1, 63}, {0x2B, 0, 0, 0, 239}, {0x2C}}));
  ASSERT_EQ(driver_.write(0, 8, band_), DisplayStatus::ok);  // the next frame starts anew
  EXPECT_EQ(bus_.commands().size(), 6U);
}

TEST_F(St7789Ready, BandsOutOfOrderGetAWindow) {
  ASSERT_EQ(driver_.write(16, 24, band_), DisplayStatus::ok);
  ASSERT_EQ(driver_.write(8, 16, band_), DisplayStatus::ok);
  ASSERT_EQ(driver_.write(16, 24, band_), DisplayStatus::ok);
  EXPECT_EQ(
      bus_.commands(),
      (std::vector<Bytes>{
          {0x2A, 0, 0, 1, 63}, {0x2B, 0, 16, 0, 239}, {0x2C}, {0x2A, 0, 0, 1, 63}, {0x2B, 0, 8, 0, 239}, {0x2C}}));
}

TEST_F(St7789Ready, WhateverElseIsSentEndsTheRunOfBands) {
  ASSERT_EQ(driver_.write(0, 8, band_), DisplayStatus::ok);
  ASSERT_EQ(driver_.invert(false), DisplayStatus::ok);
  ASSERT_EQ(driver_.write(8, 16, band_), DisplayStatus::ok);
  EXPECT_EQ(bus_.commands(), (std::vector<Bytes>{{0x2A, 0, 0, 1, 63},
                                                 {0x2B, 0, 0, 0, 239},
                                                 {0x2C},
                                                 {0x21},
                                                 {0x2A, 0, 0, 1, 63},
                                                 {0x2B, 0, 8, 0, 239},
                                                 {0x2C}}));
  bus_.is_busy = true;
  EXPECT_EQ(driver_.write(16, 24, band_), DisplayStatus::bus_busy);
}

TEST(St7789, PacksTwoPixelsIntoThreeBytesInPlace) {
  // Red, green and blue of 5, 6 and 5 bits: their high four are 0xA, 0xB, 0xC and 0x1, 0x2, 0x3.
  std::vector<std::uint16_t> words{0xA << 12 | 0xB << 7 | 0xC << 1, 0x1 << 12 | 0x2 << 7 | 0x3 << 1, 0xFFFF, 0x0000};
  const auto packed = hal::mipi::pack_444_in_place(words);
  EXPECT_EQ(Bytes(packed.begin(), packed.end()), (Bytes{0xAB, 0xC1, 0x23, 0xFF, 0xF0, 0x00}));
}

TEST(St7789, ChecksTheBusClock) {
  sim::SimClock clock;
  for (const auto& [hz, want] : {std::pair{62'500'000U, DisplayStatus::ok},
                                 {80'000'000U, DisplayStatus::ok},
                                 {80'000'001U, DisplayStatus::bus_clock_too_high}}) {
    RecordingBus bus(clock, hz);
    Landscape driver(bus, clock);
    EXPECT_EQ(driver.init(), want) << hz;
  }
}

}  // namespace
}  // namespace spanline
