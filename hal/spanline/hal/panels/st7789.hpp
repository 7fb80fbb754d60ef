#pragma once
/// @file
/// The driver of the ST7789.
///
/// ```cpp
/// // Held upright, by a viewer whose module has its colour filters the other way round.
/// template <hal::Bus Bus, hal::Clock Clock>
/// using Upright = hal::St7789<hal::st7789::glass_240x320, Bus, Clock,
///                              hal::MipiOptions{.orientation = hal::Orientation::portrait, .swap_red_blue = true}>;
/// ```
#include <array>
#include <cstdint>

#include "spanline/hal/panels/mipi_panel.hpp"

namespace spanline::hal {

/// The glasses that are sold with an ST7789. The chip's memory is always 240 × 320; a smaller glass shows a part of it,
/// whose offsets depend on the orientation.
namespace st7789 {

/// 2.0" to 2.8": all of the memory.
inline constexpr mipi::Glass glass_240x320{
    .memory_columns = 240, .memory_rows = 320, .column = 0, .row = 0, .width = 240, .height = 320};
/// 1.3" and 1.54": the upper 240 rows.
inline constexpr mipi::Glass glass_240x240{
    .memory_columns = 240, .memory_rows = 320, .column = 0, .row = 0, .width = 240, .height = 240};
/// 1.14": the middle, 52 columns from one side and 53 from the other.
inline constexpr mipi::Glass glass_135x240{
    .memory_columns = 240, .memory_rows = 320, .column = 52, .row = 40, .width = 135, .height = 240};

}  // namespace st7789

/// The ST7789, a 240 × 320 RGB TFT controller (ST7789V datasheet, chapter 9), with IPS glass.
template <mipi::Glass shown>
struct St7789Chip {
  /// What the glass shows of the chip's memory.
  static constexpr mipi::Glass glass = shown;
  static constexpr bool wired_mirrored = false;      ///< memory column 0 is at the viewer's right
  static constexpr bool filters_blue_first = false;  ///< the glass has its colour filters in the order BGR
  static constexpr bool shows_complement = true;     ///< IPS glass shows true colours with inversion on
  static constexpr bool takes_rgb444 = true;         ///< section 9.1.32: 12, 16 or 18 bits a pixel
  /// Serial write cycle 16 ns (section 7.4.3, 4-line serial interface); common modules run at 80 MHz.
  static constexpr ClockRating clock_rating{.rated_hz = 62'500'000, .tolerated_hz = 80'000'000};
  /// Read display ID (section 9.1.3). The answer is a dummy byte, then manufacturer, version and model.
  static constexpr std::uint8_t identity_command = 0x04;
  /// What it answers, without the first byte, which means nothing.
  static constexpr std::array<std::uint8_t, 3> identity{0x85, 0x85, 0x52};

  /// From reset to a panel that is awake and dark, without the orientation. It starts with a software reset for boards
  /// that have no reset line. Voltages and gamma are those of the common 1.3" to 2.8" IPS modules.
  // clang-format off
  static constexpr auto init_table = std::to_array<std::uint8_t>({
      // bytes, pause in ms, command, arguments
      1, 120, mipi::software_reset,
      1, 120, mipi::sleep_out,
      2, 0, mipi::pixel_format_set, mipi::format_16_bits,
      6, 0, 0xB2, 0x0C, 0x0C, 0x00, 0x33, 0x33,  // porches
      2, 0, 0xB7, 0x35,                          // gate voltages 13.26 V and -10.43 V
      2, 0, 0xBB, 0x19,                          // VCOM 0.725 V
      2, 0, 0xC0, 0x2C,                          // panel control as after reset
      3, 0, 0xC2, 0x01, 0xFF,                    // VDV and VRH come from the next two commands
      2, 0, 0xC3, 0x12,                          // VRH 4.45 V
      2, 0, 0xC4, 0x20,                          // VDV 0 V
      2, 0, 0xC6, 0x0F,                          // frame rate 60 Hz
      3, 0, 0xD0, 0xA4, 0xA1,                    // power: AVDD 6.8 V, AVCL -4.8 V
      15, 0, 0xE0, 0xD0, 0x04, 0x0D, 0x11, 0x13, 0x2B, 0x3F,  // positive gamma
                   0x54, 0x4C, 0x18, 0x0D, 0x0B, 0x1F, 0x23,
      15, 0, 0xE1, 0xD0, 0x04, 0x0C, 0x11, 0x13, 0x2C, 0x3F,  // negative gamma
                   0x44, 0x51, 0x2F, 0x1F, 0x1F, 0x20, 0x23,
      1, 0, mipi::normal_mode,
  });
  // clang-format on
  static_assert(is_well_formed(init_table));
};

/// The driver over a bus and a clock of yours; see MipiPanel.
template <mipi::Glass glass, Bus BusType, Clock ClockType, MipiOptions options = MipiOptions{}>
using St7789 = MipiPanel<St7789Chip<glass>, BusType, ClockType, options>;

}  // namespace spanline::hal
