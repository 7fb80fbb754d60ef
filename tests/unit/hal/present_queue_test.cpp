// The present loop over a bus that queues: drawing runs ahead of the wire by as many buffers as there are.
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "panels/fake_buses.hpp"
#include "panels/sim_clock.hpp"
#include "recording_bus.hpp"
#include "spanline/hal/panels/st7789.hpp"
#include "spanline/hal/present.hpp"

namespace spanline {
namespace {

using hal::DisplayStatus;
using Panel = hal::St7789<hal::st7789::glass_240x320, sim::QueueBus, sim::SimClock>;
using Present = hal::Present<Panel, sim::SimClock>;

static_assert(hal::QueueingBus<sim::QueueBus> && !hal::QueueingBus<sim::LateBus>);

constexpr int rows = 24;
constexpr int bands = Panel::height / rows;
constexpr std::uint32_t transfer_us = 1000;

class PresentQueue : public ::testing::Test {
 protected:
  /// A band that takes `draw_us` to draw.
  void show_band(int band, int index, std::uint32_t draw_us) {
    ASSERT_EQ(present_.acquire(index), DisplayStatus::ok);
    clock_.delay_us(draw_us);
    ASSERT_EQ(present_.submit(band * rows, (band + 1) * rows, index), DisplayStatus::ok);
  }
  [[nodiscard]] std::uint64_t now_us() const { return clock_.now_ns() / 1000; }

  sim::SimClock clock_;
  sim::QueueBus bus_{clock_, transfer_us};
  Panel panel_{bus_, clock_};
  std::array<std::vector<std::uint16_t>, 3> memory_{std::vector<std::uint16_t>(320 * rows),
                                                    std::vector<std::uint16_t>(320 * rows),
                                                    std::vector<std::uint16_t>(320 * rows)};
  std::array<std::span<std::uint16_t>, 4> buffers_{memory_[0], memory_[1], memory_[2], {}};
  Present present_{panel_, clock_, buffers_};
};

TEST_F(PresentQueue, EmptyBuffersDoNotCount) {
  ASSERT_EQ(present_.begin_frame(), DisplayStatus::ok);
  EXPECT_EQ(present_.acquire(2), DisplayStatus::ok);
  EXPECT_EQ(present_.acquire(3), DisplayStatus::out_of_order);
  EXPECT_TRUE(present_.buffer(3).empty());
}

TEST_F(PresentQueue, QuickBandsRunAheadByAsManyAsThereAreBuffers) {
  ASSERT_EQ(present_.begin_frame(), DisplayStatus::ok);
  const std::uint64_t start = now_us();
  for (int band = 0; band < 3; ++band) show_band(band, band, 10);
  EXPECT_LT(now_us() - start, 100U) << "nothing to wait for";
  show_band(3, 0, 10);  // waits for the first band's buffer, not for the others
  EXPECT_GE(now_us() - start, transfer_us);
  EXPECT_LT(now_us() - start, 2 * transfer_us);
  EXPECT_EQ(bus_.misuses(), 0);
}

TEST_F(PresentQueue, TellsWhetherABufferIsFree) {
  ASSERT_EQ(present_.begin_frame(), DisplayStatus::ok);
  for (int index = 0; index < 3; ++index) EXPECT_TRUE(present_.available(index));
  for (int band = 0; band < 3; ++band) show_band(band, band, 10);
  for (int index = 0; index < 3; ++index) EXPECT_FALSE(present_.available(index));
  clock_.delay_us(transfer_us + 10);
  EXPECT_TRUE(present_.available(0));
  EXPECT_FALSE(present_.available(1));
  const std::uint64_t start = now_us();
  EXPECT_EQ(present_.acquire(0), DisplayStatus::ok);
  EXPECT_LT(now_us() - start, 10U);
}

TEST_F(PresentQueue, AFrameOfUnevenBandsTakesAsLongAsTheWire) {
  ASSERT_EQ(present_.begin_frame(), DisplayStatus::ok);
  const std::uint64_t start = now_us();
  for (int band = 0; band < bands; ++band) show_band(band, band % 3, band % 2 == 0 ? 100 : 1800);
  ASSERT_EQ(present_.end_frame(), DisplayStatus::ok);
  // Drawing takes 0.95 of the wire's time on average; with the first band and one late one it is a little more in all.
  EXPECT_LT(now_us() - start, (bands + 2) * transfer_us);
  EXPECT_EQ(bus_.transfers(), bands);
}

TEST_F(PresentQueue, ThePanelGoesOnBehindTheFirstFrameWhichIsWaitedFor) {
  ASSERT_EQ(present_.begin_frame(), DisplayStatus::ok);
  for (int band = 0; band < bands; ++band) show_band(band, band % 3, 10);
  const int commands = bus_.commands();
  ASSERT_EQ(present_.end_frame_early(), DisplayStatus::ok);
  EXPECT_FALSE(bus_.busy());
  EXPECT_EQ(bus_.commands(), commands + 1);
  EXPECT_EQ(bus_.misuses(), 0);
}

TEST_F(PresentQueue, TheNextFrameBeginsWhileTheLastBandsLeave) {
  ASSERT_EQ(present_.begin_frame(), DisplayStatus::ok);
  ASSERT_EQ(present_.end_frame_early(), DisplayStatus::ok);
  ASSERT_EQ(present_.begin_frame(), DisplayStatus::ok);
  for (int band = 0; band < bands; ++band) show_band(band, band % 3, 10);
  const int commands = bus_.commands();
  ASSERT_EQ(present_.end_frame_early(), DisplayStatus::ok);
  EXPECT_TRUE(bus_.busy());
  EXPECT_EQ(present_.statistics().frames, 2U);
  ASSERT_EQ(present_.begin_frame(), DisplayStatus::ok);
  EXPECT_TRUE(bus_.busy());
  // The first band's window wants an idle bus: submit waits for it, and no command goes out before.
  show_band(0, bands % 3, 10);
  EXPECT_EQ(bus_.commands(), commands + 3);
  EXPECT_EQ(bus_.misuses(), 0);
}

TEST_F(PresentQueue, EndingEarlyWithoutAFrameIsOutOfOrder) {
  EXPECT_EQ(present_.end_frame_early(), DisplayStatus::out_of_order);
}

TEST_F(PresentQueue, ABufferIsTheBusesUntilItIsAcquiredAgain) {
  ASSERT_EQ(present_.begin_frame(), DisplayStatus::ok);
  show_band(0, 0, 10);
  EXPECT_EQ(present_.submit(rows, 2 * rows, 0), DisplayStatus::out_of_order);
}

}  // namespace
}  // namespace spanline
