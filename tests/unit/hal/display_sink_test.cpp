// The joint between a renderer and a present loop, with a renderer that is nothing but bands.
#include "spanline/hal/display_sink.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "panels/fake_buses.hpp"
#include "panels/sim_clock.hpp"
#include "recording_bus.hpp"
#include "spanline/hal/panels/st7789.hpp"

namespace spanline {
namespace {

using hal::DisplayStatus;
using sim::SimClock;
using Panel = hal::St7789<hal::st7789::glass_240x240, sim::QueueBus, SimClock>;

constexpr int rows = 24, bands = Panel::height / rows;

struct Band {
  std::int32_t y0, y1;
  std::span<std::uint16_t> pixels;
  unsigned buffer;
};

/// Three colour bands.
struct Bands {
  std::array<std::vector<std::uint16_t>, 3> memory{std::vector<std::uint16_t>(240 * rows),
                                                   std::vector<std::uint16_t>(240 * rows),
                                                   std::vector<std::uint16_t>(240 * rows)};
  [[nodiscard]] std::span<std::uint16_t> colour_band(unsigned i) const {
    if (i >= memory.size()) return {};
    auto& words = const_cast<std::vector<std::uint16_t>&>(memory[i]);
    return words;
  }
  [[nodiscard]] Band band(int number, int width = Panel::width) const {
    const unsigned buffer = static_cast<unsigned>(number) % 3;
    return {number * rows, (number + 1) * rows, colour_band(buffer).first(static_cast<std::size_t>(width * rows)),
            buffer};
  }
};

/// Writes down what it was asked to fill.
struct NotingFiller {
  void fill(std::uint16_t value, std::uint32_t count, std::uint16_t*) { filled_with += value * count; }
  bool filled() { return works; }
  static inline std::uint32_t filled_with = 0;
  static inline bool works = true;
};

class DisplaySinkTest : public testing::Test {
 protected:
  using Sink = hal::DisplaySink<Panel, SimClock>;

  /// How many bands the sink took.
  int draw(Sink& sink, int width = Panel::width) const {
    for (int number = 0; number < bands; ++number) {
      const Band band = renderer_.band(number, width);
      if (!sink.acquire(band.buffer) || !sink(band)) return number;
    }
    return bands;
  }

  SimClock clock_;
  sim::QueueBus bus_{clock_, 1000};
  Panel panel_{bus_, clock_};
  Bands renderer_;
  Sink sink_{panel_, clock_, renderer_, 5000};
};

TEST_F(DisplaySinkTest, AFrameGoesToThePanelFromTheRenderersOwnBands) {
  const auto shown = sink_.show([&](Sink& sink) { return draw(sink); });
  EXPECT_EQ(shown.display, DisplayStatus::ok);
  EXPECT_EQ(shown.drawing, bands);
  EXPECT_EQ(bus_.transfers(), bands);
  EXPECT_FALSE(bus_.busy());
  EXPECT_EQ(sink_.present().statistics().frames, 1U);
  EXPECT_EQ(sink_.present().buffer(2).data(), renderer_.colour_band(2).data());
  EXPECT_TRUE(sink_.present().buffer(3).empty());
}

TEST_F(DisplaySinkTest, GoingOnDoesNotWaitForTheLastBands) {
  EXPECT_EQ(sink_.show([&](Sink& sink) { return draw(sink); }).display, DisplayStatus::ok);
  EXPECT_EQ(sink_.show_and_go_on([&](Sink& sink) { return draw(sink); }).display, DisplayStatus::ok);
  EXPECT_TRUE(bus_.busy());
}

TEST_F(DisplaySinkTest, BandsOfAnotherWidthThanThePanelsAreNamed) {
  const auto shown = sink_.show([&](Sink& sink) { return draw(sink, Panel::width / 2); });
  EXPECT_EQ(shown.drawing, 0);
  EXPECT_EQ(shown.display, DisplayStatus::window_out_of_range);
  EXPECT_EQ(bus_.transfers(), 0);
  EXPECT_EQ(sink_.show([&](Sink& sink) { return draw(sink); }).display, DisplayStatus::ok)
      << "the next frame is another";
}

TEST_F(DisplaySinkTest, NothingIsDrawnWhereTheFrameDoesNotBegin) {
  test::RecordingBus bus(clock_, 100'000'000);
  hal::St7789<hal::st7789::glass_240x240, test::RecordingBus, SimClock> panel(bus, clock_);
  hal::DisplaySink sink(panel, clock_, renderer_);
  const auto shown = sink.show([&](auto&) { return 7; });
  EXPECT_EQ(shown.display, DisplayStatus::bus_clock_too_high);
  EXPECT_EQ(shown.drawing, 0);
}

TEST_F(DisplaySinkTest, FillsAreThoseOfTheFillerWhereThereIsOne) {
  using Filling = hal::DisplaySink<Panel, SimClock, NotingFiller>;
  Filling sink(panel_, clock_, renderer_);
  sink.fill(3, 5, nullptr);
  EXPECT_EQ(NotingFiller::filled_with, 15U);
  EXPECT_TRUE(sink.filled());
  NotingFiller::works = false;
  EXPECT_FALSE(sink.filled());
  constexpr auto fills = [](auto& any) {
    return requires { any.filled(); };
  };
  EXPECT_TRUE(fills(sink));
  EXPECT_FALSE(fills(sink_));
}

}  // namespace
}  // namespace spanline
