#pragma once
/// @file
/// The driver of the ILI9341.
///
/// ```cpp
/// // Held upright, by a viewer whose module has its colour filters the other way round.
/// template <hal::Bus Bus, hal::Clock Clock>
/// using Upright = hal::Ili9341<Bus, Clock,
///                              hal::MipiOptions{.orientation = hal::Orientation::portrait, .swap_red_blue = true}>;
/// ```
#include <array>
#include <cstdint>

#include "spanline/hal/panels/mipi_panel.hpp"

namespace spanline::hal {

/// The ILI9341, a 240 × 320 RGB TFT controller (ILI9341 datasheet, chapter 8), with the glass of the common 2.2"
/// to 2.8" modules.
struct Ili9341Chip {
  /// What the glass shows of the chip's memory.
  static constexpr mipi::Glass glass{
      .memory_columns = 240, .memory_rows = 320, .column = 0, .row = 0, .width = 240, .height = 320};
  static constexpr bool wired_mirrored = true;      ///< memory column 0 is at the viewer's right
  static constexpr bool filters_blue_first = true;  ///< the glass has its colour filters in the order BGR
  static constexpr bool shows_complement = false;   ///< the glass shows true colours with inversion on
  static constexpr bool takes_rgb444 = false;       ///< section 8.2.33: 16 or 18 bits a pixel only
  /// Serial write cycle 100 ns (AC characteristics, 4-line serial interface); common modules on short wires run at 40
  /// MHz.
  static constexpr ClockRating clock_rating{.rated_hz = 10'000'000, .tolerated_hz = 40'000'000};
  /// Read ID4 (section 8.3.23). The answer is a dummy byte, then version and model.
  static constexpr std::uint8_t identity_command = 0xD3;
  /// What it answers, without the first byte, which means nothing.
  static constexpr std::array<std::uint8_t, 3> identity{0x00, 0x93, 0x41};

  /// From reset to a panel that is awake and dark, without the orientation. It starts with a software reset for boards
  /// that have no reset line.
  // clang-format off
static constexpr auto init_table = std::to_array<std::uint8_t>({
    // bytes, pause in ms, command, arguments
    1, 120, mipi::software_reset,
    4, 0, 0xCF, 0x00, 0xC1, 0x30,              // power control B
    5, 0, 0xED, 0x64, 0x03, 0x12, 0x81,        // power-on sequence
    4, 0, 0xE8, 0x85, 0x00, 0x78,              // driver timing A
    6, 0, 0xCB, 0x39, 0x2C, 0x00, 0x34, 0x02,  // power control A
    2, 0, 0xF7, 0x20,                          // pump ratio: DDVDH = 2 × VCI
    3, 0, 0xEA, 0x00, 0x00,                    // driver timing B
    2, 0, 0xC0, 0x23,                          // power control 1: GVDD 4.60 V
    2, 0, 0xC1, 0x10,                          // power control 2
    3, 0, 0xC5, 0x3E, 0x28,                    // VCOM control 1
    2, 0, 0xC7, 0x86,                          // VCOM control 2
    2, 0, mipi::pixel_format_set, mipi::format_16_bits,  // 16 bits a pixel on both interfaces
    3, 0, 0xB1, 0x00, 0x18,                    // frame rate 79 Hz
    4, 0, 0xB6, 0x08, 0x82, 0x27,              // display function: normally white, 320 lines
    2, 0, 0xF2, 0x00,                          // three-gamma off
    2, 0, 0x26, 0x01,                          // gamma curve 1
    16, 0, 0xE0, 0x0F, 0x31, 0x2B, 0x0C, 0x0E, 0x08, 0x4E, 0xF1,  // positive gamma
                 0x37, 0x07, 0x10, 0x03, 0x0E, 0x09, 0x00,
    16, 0, 0xE1, 0x00, 0x0E, 0x14, 0x03, 0x11, 0x07, 0x31, 0xC1,  // negative gamma
                 0x48, 0x08, 0x0F, 0x0C, 0x31, 0x36, 0x0F,
    1, 120, mipi::sleep_out,
});
  // clang-format on
  static_assert(is_well_formed(init_table));
};

/// The driver over a bus and a clock of yours; see MipiPanel.
template <Bus BusType, Clock ClockType, MipiOptions options = MipiOptions{}>
using Ili9341 = MipiPanel<Ili9341Chip, BusType, ClockType, options>;

}  // namespace spanline::hal
