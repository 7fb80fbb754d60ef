#pragma once
#include <cstdint>

#include "band_filler.hpp"
#include "microsecond_clock.hpp"
#include "registers.hpp"
#include "spanline/hal/panels/ili9341.hpp"
#include "spanline/hal/panels/st7789.hpp"
#include "spi_bus.hpp"

/// The display on the Pico's SPI0. Programs for any board with a display use the names at the end;
/// SPANLINE_PICO_DISPLAY says which one is wired up, by its name here.
namespace spanline::board {
namespace displays {

/// How a program cuts the picture: lines a band, and bands to draw into. Drawing runs ahead of the wire by as many.
struct DisplayBands {
  std::uint16_t lines;
  std::uint8_t count;
  std::uint8_t depth_count;  ///< 2 where a BandFiller clears a band while the one above is drawn
};

template <hal::mipi::Glass glass, std::uint32_t hz>
struct St7789 {
  using Bus = SpiBus;
  using Panel = hal::St7789<glass, SpiBus, MicrosecondClock>;
  static constexpr std::uint32_t clock_hz = hz;
};

using st7789_240x320 = St7789<hal::st7789::glass_240x320, 62'500'000>;
using st7789_240x240 = St7789<hal::st7789::glass_240x240, 62'500'000>;
using st7789_135x240 = St7789<hal::st7789::glass_135x240, 62'500'000>;
/// A clock that the divider cannot give: it makes 31.25 MHz of it.
using st7789_at_50_mhz = St7789<hal::st7789::glass_240x320, 50'000'000>;

/// These modules have a line back, so the driver asks whether one is there.
struct ili9341 {
  using Bus = ReadableSpiBus;
  using Panel = hal::Ili9341<ReadableSpiBus, MicrosecondClock>;
  static constexpr std::uint32_t clock_hz = 31'250'000;
};

#if !defined(SPANLINE_PICO_DISPLAY)
using Wired = st7789_240x320;
#else
using Wired = SPANLINE_PICO_DISPLAY;
#endif

static_assert(Wired::Panel::clock_rating.verdict(Wired::clock_hz) != hal::ClockVerdict::too_high);

}  // namespace displays

class DisplayBus : public displays::Wired::Bus {
 public:
  DisplayBus() : displays::Wired::Bus(displays::Wired::clock_hz) {}
};
using DisplayClock = MicrosecondClock;

using DisplayPanel = displays::Wired::Panel;

inline constexpr displays::DisplayBands display_bands{.lines = 48, .count = 4, .depth_count = 2};

/// Feeds the watchdog, and starts it the first time: a program that shows no frame for 1.5 s starts anew. The counter
/// goes down by two a microsecond (RP2040-E1).
inline void frame_done() {
  constexpr std::uint32_t timeout_us = 1'500'000;
  io(watchdog::load) = 2 * timeout_us;
  set_bits(watchdog::control, watchdog::enable);
}

}  // namespace spanline::board
