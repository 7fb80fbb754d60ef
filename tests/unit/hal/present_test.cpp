#include "spanline/hal/present.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "panels/fake_buses.hpp"
#include "panels/host_bus.hpp"
#include "panels/ili9341_model.hpp"
#include "panels/sim_clock.hpp"
#include "recording_bus.hpp"
#include "spanline/hal/panels/ili9341.hpp"

namespace spanline {
namespace {

using hal::DisplayStatus;
using sim::ComplaintKind;

constexpr int band_rows = 16;
constexpr int width = 320;
constexpr int height = 240;
constexpr int bands = height / band_rows;

/// The loop of the class documentation, with a callback for the drawing.
template <typename PresentType, typename Draw>
DisplayStatus show(PresentType& present, Draw&& draw) {
  DisplayStatus status = present.begin_frame();
  for (int y = 0, index = 0; status == DisplayStatus::ok && y < height; y += band_rows, index ^= 1) {
    status = present.acquire(index);
    if (status != DisplayStatus::ok) break;
    draw(y, present.buffer(index));
    status = present.submit(y, y + band_rows, index);
  }
  return present.end_frame();
}

struct Buffers {
  std::vector<std::uint16_t> first = std::vector<std::uint16_t>(width * band_rows);
  std::vector<std::uint16_t> second = std::vector<std::uint16_t>(width * band_rows);
};

class PresentLate : public ::testing::Test {
 protected:
  using Driver = hal::Ili9341<sim::LateBus, sim::SimClock>;
  static constexpr std::uint32_t transfer_us = 1000;

  sim::SimClock clock_;
  sim::LateBus bus_{clock_, transfer_us};
  Driver driver_{bus_, clock_};
  Buffers buffers_;
  hal::Present<Driver, sim::SimClock> present_{driver_, clock_, buffers_.first, buffers_.second, 5000};
};

TEST_F(PresentLate, DrawsOneBandWhileTheOtherIsInFlight) {
  ASSERT_EQ(show(present_, [&](int, std::span<std::uint16_t>) { bus_.draw(400); }), DisplayStatus::ok);
  EXPECT_EQ(bus_.transfers(), bands);
  EXPECT_EQ(bus_.draws_while_busy(), bands - 1);  // all but the first
  EXPECT_EQ(bus_.misuses(), 0);
  EXPECT_FALSE(bus_.busy());
}

TEST_F(PresentLate, CountsWhatItWaited) {
  ASSERT_EQ(show(present_, [&](int, std::span<std::uint16_t>) { bus_.draw(400); }), DisplayStatus::ok);
  const hal::PresentStatistics& statistics = present_.statistics();
  EXPECT_EQ(statistics.frames, 1U);
  EXPECT_EQ(statistics.frames_given_up, 0U);
  EXPECT_EQ(statistics.bands, static_cast<std::uint32_t>(bands));
  EXPECT_EQ(statistics.initialisations, 1U);
  // A transfer takes 1000 µs, and drawing hides 400 of them for all but the last band.
  EXPECT_NEAR(statistics.last_wait_us, (bands - 1) * 600 + 1000, 10 * bands);
  EXPECT_NEAR(statistics.last_frame_us, 400 + bands * 1000, 10 * bands);
}

TEST_F(PresentLate, DoesNotWaitWhenDrawingIsSlower) {
  ASSERT_EQ(show(present_, [&](int, std::span<std::uint16_t>) { bus_.draw(1500); }), DisplayStatus::ok);
  EXPECT_EQ(bus_.draws_while_busy(), bands - 1);
  EXPECT_LE(present_.statistics().last_wait_us, transfer_us + 10);  // only for the last band
}

TEST_F(PresentLate, AcquireOfTheOtherBufferDoesNotWait) {
  ASSERT_EQ(present_.begin_frame(), DisplayStatus::ok);
  ASSERT_EQ(present_.acquire(0), DisplayStatus::ok);
  ASSERT_EQ(present_.submit(0, band_rows, 0), DisplayStatus::ok);
  ASSERT_TRUE(bus_.busy());
  EXPECT_EQ(present_.acquire(1), DisplayStatus::ok);
  EXPECT_TRUE(bus_.busy());
  EXPECT_EQ(present_.acquire(0), DisplayStatus::ok);  // this one waits
  EXPECT_FALSE(bus_.busy());
  EXPECT_EQ(present_.end_frame(), DisplayStatus::ok);
}

TEST_F(PresentLate, RefusesCallsOutOfOrderAndLivesOn) {
  EXPECT_EQ(present_.acquire(0), DisplayStatus::out_of_order);
  EXPECT_EQ(present_.submit(0, 1, 0), DisplayStatus::out_of_order);
  EXPECT_EQ(present_.end_frame(), DisplayStatus::out_of_order);
  ASSERT_EQ(present_.begin_frame(), DisplayStatus::ok);
  EXPECT_EQ(present_.begin_frame(), DisplayStatus::out_of_order);
  EXPECT_EQ(present_.acquire(2), DisplayStatus::out_of_order);
  EXPECT_EQ(present_.acquire(-1), DisplayStatus::out_of_order);
  ASSERT_EQ(present_.submit(0, band_rows, 0), DisplayStatus::ok);
  EXPECT_EQ(present_.submit(band_rows, 2 * band_rows, 0), DisplayStatus::out_of_order);  // the bus owns it
  EXPECT_EQ(present_.submit(0, band_rows + 1, 1), DisplayStatus::buffer_too_small);
  EXPECT_EQ(present_.submit(height - 1, height + 1, 1), DisplayStatus::window_out_of_range);
  EXPECT_EQ(present_.submit(5, 5, 1), DisplayStatus::window_out_of_range);
  EXPECT_EQ(present_.submit(height - 1, height, 1), DisplayStatus::ok);
  EXPECT_EQ(present_.end_frame(), DisplayStatus::ok);
  EXPECT_EQ(present_.statistics().bands, 2U);
}

TEST_F(PresentLate, TimesOutOnABusThatIsTooLate) {
  hal::Present<Driver, sim::SimClock> hasty(driver_, clock_, buffers_.first, buffers_.second, 500);
  EXPECT_EQ(show(hasty, [](int, std::span<std::uint16_t>) {}), DisplayStatus::bus_timeout);
  EXPECT_EQ(hasty.statistics().frames_given_up, 1U);
}

TEST_F(PresentLate, TimesRightAcrossTheWrapOfTheClock) {
  clock_.advance_ns((std::uint64_t{1} << 32) * 1000 - 500'000'000);
  for (int frame = 0; frame < 100; ++frame) {
    ASSERT_EQ(show(present_, [&](int, std::span<std::uint16_t>) { bus_.draw(100); }), DisplayStatus::ok);
    ASSERT_LT(present_.statistics().last_frame_us, 20'000U);
  }
}

TEST_F(PresentLate, ASleepingPanelEndsTheFrameWithoutANewInit) {
  ASSERT_EQ(show(present_, [](int, std::span<std::uint16_t>) {}), DisplayStatus::ok);
  ASSERT_EQ(driver_.sleep(true), DisplayStatus::ok);
  EXPECT_EQ(show(present_, [](int, std::span<std::uint16_t>) {}), DisplayStatus::panel_asleep);
  ASSERT_EQ(driver_.sleep(false), DisplayStatus::ok);
  EXPECT_EQ(show(present_, [](int, std::span<std::uint16_t>) {}), DisplayStatus::ok);
  EXPECT_EQ(present_.statistics().initialisations, 1U);
}

class PresentStuck : public ::testing::Test {
 protected:
  using Driver = hal::Ili9341<sim::StuckBus, sim::SimClock>;

  /// Draws a frame of one colour.
  DisplayStatus show_color(std::uint16_t color) {
    return show(present_, [color](int, std::span<std::uint16_t> pixels) {
      for (std::uint16_t& pixel : pixels) pixel = hal::to_pixel_order(Driver::pixel_order, color);
    });
  }

  void expect_all(std::uint8_t red, std::uint8_t green, std::uint8_t blue) const {
    const sim::PanelPicture picture = model_.picture();
    for (int y = 0; y < picture.height; ++y) {
      for (int x = 0; x < picture.width; ++x) {
        const std::uint8_t* pixel = picture.at(x, y);
        ASSERT_TRUE(pixel[0] == red && pixel[1] == green && pixel[2] == blue) << x << ", " << y;
      }
    }
  }

  sim::SimClock clock_;
  sim::Ili9341Model model_{hal::Orientation::landscape};
  sim::HostBus host_bus_{model_, clock_, 10'000'000};
  sim::StuckBus bus_{host_bus_};
  Driver driver_{bus_, clock_};
  Buffers buffers_;
  hal::Present<Driver, sim::SimClock> present_{driver_, clock_, buffers_.first, buffers_.second, 20'000};
};

TEST_F(PresentStuck, GivesAStatusAndRecoversOnTheNextFrame) {
  ASSERT_EQ(show_color(0xF800), DisplayStatus::ok);
  expect_all(255, 0, 0);

  bus_.stick_at(3);
  const std::uint64_t before_ns = clock_.now_ns();
  EXPECT_EQ(show_color(0x07E0), DisplayStatus::bus_timeout);
  EXPECT_LT(clock_.now_ns() - before_ns, 100'000'000U);  // one timeout, not one a band
  EXPECT_EQ(present_.statistics().frames_given_up, 1U);

  EXPECT_EQ(show_color(0x07E0), DisplayStatus::bus_timeout);  // still stuck: the init says so
  EXPECT_EQ(present_.statistics().frames_given_up, 2U);
  EXPECT_EQ(present_.statistics().initialisations, 1U);

  bus_.recover();
  EXPECT_EQ(show_color(0x001F), DisplayStatus::ok);
  expect_all(0, 0, 255);
  EXPECT_EQ(present_.statistics().initialisations, 2U);
  EXPECT_EQ(present_.statistics().frames, 2U);
  EXPECT_TRUE(model_.complaints().empty()) << describe(model_.complaints().front());
}

TEST_F(PresentStuck, EveryCallReturnsTheFailureUntilTheNextFrame) {
  ASSERT_EQ(present_.begin_frame(), DisplayStatus::ok);
  bus_.stick_at(1);
  ASSERT_EQ(present_.submit(0, 1, 0), DisplayStatus::ok);
  EXPECT_EQ(present_.acquire(0), DisplayStatus::bus_timeout);
  const std::uint64_t failed_ns = clock_.now_ns();
  EXPECT_EQ(present_.acquire(1), DisplayStatus::bus_timeout);
  EXPECT_EQ(present_.submit(1, 2, 1), DisplayStatus::bus_timeout);
  EXPECT_EQ(present_.end_frame(), DisplayStatus::bus_timeout);
  EXPECT_EQ(present_.end_frame(), DisplayStatus::bus_timeout);
  EXPECT_LT(clock_.now_ns() - failed_ns, 20'000'000U);  // none of them waited again
  bus_.recover();
  EXPECT_EQ(show_color(0xFFFF), DisplayStatus::ok);
  expect_all(255, 255, 255);
}

TEST_F(PresentStuck, AFrameThatFailedNeedsNoEnd) {
  ASSERT_EQ(present_.begin_frame(), DisplayStatus::ok);
  bus_.stick_at(0);
  EXPECT_EQ(present_.submit(0, 1, 0), DisplayStatus::bus_timeout);
  bus_.recover();
  EXPECT_EQ(show_color(0xFFFF), DisplayStatus::ok);
  expect_all(255, 255, 255);
  EXPECT_EQ(present_.statistics().frames_given_up, 1U);
}

TEST_F(PresentStuck, TheLastBandTimesOutInEndFrame) {
  bus_.stick_at(bands);
  EXPECT_EQ(show_color(0xFFFF), DisplayStatus::bus_timeout);
  EXPECT_EQ(present_.statistics().bands, static_cast<std::uint32_t>(bands));
  EXPECT_EQ(present_.statistics().frames, 0U);
}

TEST(Present, ABusThatIsTooFastNeverStarts) {
  sim::SimClock clock;
  test::RecordingBus bus(clock, 80'000'000);
  hal::Ili9341<test::RecordingBus, sim::SimClock> driver(bus, clock);
  Buffers buffers;
  hal::Present present(driver, clock, buffers.first, buffers.second);
  EXPECT_EQ(show(present, [](int, std::span<std::uint16_t>) {}), DisplayStatus::bus_clock_too_high);
  EXPECT_TRUE(bus.events.empty());
}

}  // namespace
}  // namespace spanline
