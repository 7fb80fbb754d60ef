#include <gtest/gtest.h>

#include <array>
#include <set>
#include <string>
#include <vector>

#include "panels/fake_buses.hpp"
#include "panels/host_bus.hpp"
#include "panels/sim_clock.hpp"
#include "recording_bus.hpp"
#include "spanline/hal/bus.hpp"
#include "spanline/hal/clock.hpp"
#include "spanline/hal/clock_rating.hpp"
#include "spanline/hal/command_table.hpp"
#include "spanline/hal/panel.hpp"
#include "spanline/hal/pixel_order.hpp"

namespace spanline {
namespace {

using hal::DisplayStatus;

static_assert(hal::Bus<sim::HostBus> && hal::Bus<sim::LateBus> && hal::Bus<sim::StuckBus> &&
              hal::Bus<test::RecordingBus> && hal::Clock<sim::SimClock>);

TEST(DisplayStatus, EveryValueHasANameOfItsOwn) {
  std::set<std::string> names;
  for (int value = 0; value <= static_cast<int>(DisplayStatus::out_of_order); ++value) {
    names.insert(hal::to_string(static_cast<DisplayStatus>(value)));
  }
  EXPECT_EQ(names.size(), static_cast<std::size_t>(DisplayStatus::out_of_order) + 1);
  EXPECT_EQ(names.count("unknown"), 0U);
}

TEST(ClockRating, ThreeVerdicts) {
  constexpr hal::ClockRating rating{.rated_hz = 10, .tolerated_hz = 40};
  EXPECT_EQ(rating.verdict(10), hal::ClockVerdict::rated);
  EXPECT_EQ(rating.verdict(11), hal::ClockVerdict::above_rating);
  EXPECT_EQ(rating.verdict(40), hal::ClockVerdict::above_rating);
  EXPECT_EQ(rating.verdict(41), hal::ClockVerdict::too_high);
}

TEST(PixelOrder, HighByteFirstPutsRedFirstInMemory) {
  const std::uint16_t word = hal::to_pixel_order(hal::PixelOrder::high_byte_first, 0xF81F);
  EXPECT_EQ(reinterpret_cast<const std::uint8_t*>(&word)[0], 0xF8);
  EXPECT_EQ(reinterpret_cast<const std::uint8_t*>(&word)[1], 0x1F);
  EXPECT_EQ(hal::to_pixel_order(hal::PixelOrder::high_byte_first, word), 0xF81F);
  EXPECT_EQ(hal::to_pixel_order(hal::PixelOrder::native, 0x1234), 0x1234);
}

TEST(Window, FitsOnlyInside) {
  EXPECT_TRUE((hal::Window{0, 0, 4, 3}.fits(4, 3)));
  EXPECT_TRUE((hal::Window{3, 2, 4, 3}.fits(4, 3)));
  EXPECT_FALSE((hal::Window{0, 0, 5, 3}.fits(4, 3)));
  EXPECT_FALSE((hal::Window{0, 0, 4, 4}.fits(4, 3)));
  EXPECT_FALSE((hal::Window{-1, 0, 4, 3}.fits(4, 3)));
  EXPECT_FALSE((hal::Window{0, -1, 4, 3}.fits(4, 3)));
  EXPECT_FALSE((hal::Window{2, 0, 2, 3}.fits(4, 3)));
  EXPECT_FALSE((hal::Window{0, 3, 4, 2}.fits(4, 3)));
}

TEST(CommandTable, StepsInOrderWithTheirPauses) {
  constexpr auto table = std::to_array<std::uint8_t>({1, 5, 0xAA, 3, 0, 0xBB, 1, 2});
  static_assert(hal::is_well_formed(table));
  std::vector<test::Bytes> bytes;
  std::vector<std::uint32_t> pauses;
  const DisplayStatus status = hal::for_each_step(table, [&](const hal::CommandStep& step) {
    bytes.emplace_back(step.bytes.begin(), step.bytes.end());
    pauses.push_back(step.delay_ms);
    return DisplayStatus::ok;
  });
  EXPECT_EQ(status, DisplayStatus::ok);
  EXPECT_EQ(bytes, (std::vector<test::Bytes>{{0xAA}, {0xBB, 1, 2}}));
  EXPECT_EQ(pauses, (std::vector<std::uint32_t>{5, 0}));
}

TEST(CommandTable, StopsAtTheFirstFailure) {
  constexpr auto table = std::to_array<std::uint8_t>({1, 0, 0xAA, 1, 0, 0xBB});
  int steps = 0;
  const DisplayStatus status = hal::for_each_step(table, [&](const hal::CommandStep&) {
    ++steps;
    return DisplayStatus::bus_timeout;
  });
  EXPECT_EQ(status, DisplayStatus::bus_timeout);
  EXPECT_EQ(steps, 1);
}

TEST(CommandTable, RefusesRecordsThatDoNotFit) {
  EXPECT_TRUE(hal::is_well_formed({}));
  EXPECT_FALSE(hal::is_well_formed(std::array<std::uint8_t, 1>{1}));
  EXPECT_FALSE(hal::is_well_formed(std::array<std::uint8_t, 3>{2, 0, 0xAA}));
  EXPECT_FALSE(hal::is_well_formed(std::array<std::uint8_t, 2>{0, 0}));
}

TEST(SimClock, WrapsLikeARealMicrosecondCounter) {
  sim::SimClock clock;
  clock.advance_ns((std::uint64_t{1} << 32) * 1000 - 3000);
  const std::uint32_t before = clock.now_us();
  clock.delay_us(10);
  EXPECT_EQ(clock.now_us() - before, 11U);
}

}  // namespace
}  // namespace spanline
