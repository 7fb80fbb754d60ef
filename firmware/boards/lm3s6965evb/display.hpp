#pragma once
#include "oled_bus.hpp"
#include "spanline/hal/filler.hpp"
#include "spanline/hal/panels/ssd0323.hpp"
#include "system_clock.hpp"

/// The display of this board. Programs for any board with one use these names.
namespace spanline::board {

using DisplayBus = OledBus;
using DisplayClock = SystemClock;
using DisplayPanel = hal::Ssd0323<DisplayBus, DisplayClock>;

static_assert(DisplayPanel::clock_rating.verdict(DisplayBus::clock_hz()) == hal::ClockVerdict::rated);

/// How a program cuts the picture: lines a band, and bands to draw into.
struct DisplayBands {
  std::uint16_t lines;
  std::uint8_t count;
  std::uint8_t depth_count;
};
inline constexpr DisplayBands display_bands{.lines = 8, .count = 2, .depth_count = 1};
using BandFiller = hal::NoFiller;

/// Called once a frame, for boards with a watchdog to feed.
inline void frame_done() {}

}  // namespace spanline::board
