#pragma once
#include "oled_bus.hpp"
#include "spanline/hal/panels/ssd0323.hpp"
#include "system_clock.hpp"

/// The display of this board. Programs for any board with one use these names.
namespace spanline::board {

using DisplayBus = OledBus;
using DisplayClock = SystemClock;
using DisplayPanel = hal::Ssd0323<DisplayBus, DisplayClock>;

static_assert(DisplayPanel::clock_rating.verdict(DisplayBus::clock_hz()) == hal::ClockVerdict::rated);

}  // namespace spanline::board
