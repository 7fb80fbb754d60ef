#pragma once
/// @file
/// The driver of the SSD0323.
///
/// ```cpp
/// static_assert(hal::ssd0323::grey_level(0xFFFF) == 15);
/// template <hal::Bus Bus, hal::Clock Clock>
/// using Oled = hal::Ssd0323<Bus, Clock>;
/// ```
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "spanline/hal/bus.hpp"
#include "spanline/hal/clock.hpp"
#include "spanline/hal/command_table.hpp"
#include "spanline/hal/panel.hpp"

namespace spanline::hal {

/// The part that does not depend on the bus. Commands and arguments follow the datasheet of the SSD1325, a chip of
/// the same maker and size whose commands these are too: its command table and command descriptions.
namespace ssd0323 {

inline constexpr std::uint8_t set_column_address = 0x15;  ///< first and last pair of columns follow
inline constexpr std::uint8_t set_row_address = 0x75;     ///< first and last row follow
inline constexpr std::uint8_t display_off = 0xAE;         ///< dark; the memory stays
inline constexpr std::uint8_t display_on = 0xAF;          ///< shows the memory

/// The controllers of this family need a few microseconds of reset; a longer pulse allows for slow edges.
inline constexpr std::uint32_t reset_low_us = 1000;
/// Time for the panel's own supply to rise before the first command.
inline constexpr std::uint32_t settle_ms = 100;

/// For the OSRAM Pictiva 128 × 64 glass. It uses only commands that both the chip and QEMU's model of it know.
// clang-format off
inline constexpr auto init_table = std::to_array<std::uint8_t>({
    // bytes, pause in ms, command, arguments
    1, 0, display_off,
    2, 0, 0xB3, 0x91,  // clock divider and oscillator
    2, 0, 0xA8, 0x3F,  // multiplex ratio 64
    2, 0, 0xA2, 0x40,  // display offset: how this glass is wired
    2, 0, 0xA1, 0x00,  // start line 0
    2, 0, 0xAD, 0x02,  // external supply, internal VCOMH
    2, 0, 0xA0, 0x52,  // COM split and remap, high nibble left, addresses run along rows
    1, 0, 0x86,        // full current range
    9, 0, 0xB8, 0x01, 0x11, 0x22, 0x32, 0x43, 0x54, 0x65, 0x76,  // grey table, close to linear
    2, 0, 0x81, 0x70,  // contrast
    2, 0, 0xB2, 0x51,  // row period
    2, 0, 0xB1, 0x55,  // phase lengths
    2, 0, 0xBC, 0x10,  // pre-charge voltage
    2, 0, 0xBE, 0x1C,  // VCOMH
    2, 0, 0xBF, 0x0F,  // segment low voltage
    1, 0, 0xA4,        // pixels come from the memory
});
// clang-format on
static_assert(is_well_formed(init_table));

/// The grey level, 0 .. 15, of an RGB565 pixel: floor(Y × 255 / 16) with the luma Y in 0 .. 1 of ITU-R BT.601,
/// Y = 0.299 R + 0.587 G + 0.114 B. In integers: floor((630 r + 608 g + 240 b) / 4096) for r, b in 0 .. 31 and g in
/// 0 .. 63; the weights are 65280 × (0.299 / 31, 0.587 / 63, 0.114 / 31), rounded, which is within 0.007 of a level.
/// White gives 65274 / 4096, which is 15.
[[nodiscard]] constexpr std::uint8_t grey_level(std::uint16_t rgb565) {
  const std::uint32_t red = rgb565 >> 11;
  const std::uint32_t green = (rgb565 >> 5) & 0x3FU;
  const std::uint32_t blue = rgb565 & 0x1FU;
  return static_cast<std::uint8_t>((630U * red + 608U * green + 240U * blue) >> 12);
}

/// Packs RGB565 words into grey nibbles, in place: bytes 0 .. pixels.size() / 2 − 1 of the span's memory hold two
/// pixels each, the left one in the high nibble. pixels.size() is even. Byte k comes from words 2k and 2k + 1, which
/// lie no earlier in memory, so no word is overwritten before it is read.
inline std::span<const std::uint8_t> pack_in_place(std::span<std::uint16_t> pixels) {
  auto* packed = reinterpret_cast<std::uint8_t*>(pixels.data());
  const std::size_t count = pixels.size() / 2;
  for (std::size_t k = 0; k < count; ++k) {
    const unsigned left = grey_level(pixels[2 * k]);
    const unsigned right = grey_level(pixels[2 * k + 1]);
    packed[k] = static_cast<std::uint8_t>(left << 4 | right);
  }
  return {packed, count};
}

}  // namespace ssd0323

/// Driver of the SSD0323, a 128 × 64 OLED with 16 grey levels. Bands are RGB565 in native order; write() packs them in
/// place, so it needs no buffer of its own. This controller takes arguments with D/C low, like commands, so every byte
/// of a command is sent by its own bus command. See `Panel` for what each function does.
template <Bus BusType, Clock ClockType>
class Ssd0323 {
 public:
  static constexpr int width = 128;                              ///< pixels
  static constexpr int height = 64;                              ///< pixels
  static constexpr PixelOrder pixel_order = PixelOrder::native;  ///< write() computes with them
  /// Serial clock cycle 250 ns (AC characteristics); no faster clock is known to be safe.
  static constexpr ClockRating clock_rating{.rated_hz = 4'000'000, .tolerated_hz = 4'000'000};

  /// Both stay with the caller and must outlive the driver.
  Ssd0323(BusType& bus, ClockType& clock) : bus_(bus), clock_(clock) {}

  /// Resets and sets the panel up, which stays dark; takes 101 ms. `bus_clock_too_high`, `bus_timeout`.
  DisplayStatus init() {
    state_ = State::off;
    is_on_ = false;
    if (clock_rating.verdict(bus_.clock_hz()) == ClockVerdict::too_high) return DisplayStatus::bus_clock_too_high;
    bus_.reset(true);
    clock_.delay_us(ssd0323::reset_low_us);
    bus_.reset(false);
    if (bus_.busy()) return DisplayStatus::bus_timeout;  // a stuck bus is found here, before the long pause
    delay_ms(clock_, ssd0323::settle_ms);
    const DisplayStatus status = for_each_step(ssd0323::init_table, [this](const CommandStep& step) {
      const DisplayStatus sent = send(step.bytes);
      if (sent == DisplayStatus::ok && step.delay_ms != 0) delay_ms(clock_, step.delay_ms);
      return sent;
    });
    if (status == DisplayStatus::ok) state_ = State::awake;
    return status;
  }

  /// Display on, behind the first picture.
  DisplayStatus switch_on() {
    if (const DisplayStatus status = ready(); status != DisplayStatus::ok) return status;
    if (is_on_) return DisplayStatus::ok;
    const DisplayStatus status = send(std::array{ssd0323::display_on});
    is_on_ = status == DisplayStatus::ok;
    return status;
  }

  /// x0 and x1 must be even, because a memory column holds two pixels.
  DisplayStatus window(const Window& rectangle) {
    if (const DisplayStatus status = ready(); status != DisplayStatus::ok) return status;
    if (!rectangle.fits(width, height) || rectangle.x0 % 2 != 0 || rectangle.x1 % 2 != 0) {
      return DisplayStatus::window_out_of_range;
    }
    return send(std::array{ssd0323::set_column_address, static_cast<std::uint8_t>(rectangle.x0 / 2),
                           static_cast<std::uint8_t>(rectangle.x1 / 2 - 1), ssd0323::set_row_address,
                           static_cast<std::uint8_t>(rectangle.y0), static_cast<std::uint8_t>(rectangle.y1 - 1)});
  }

  /// Sends rows y0 .. y1 − 1; see Panel.
  DisplayStatus write(int y0, int y1, std::span<std::uint16_t> pixels) {
    const Window rows{0, y0, width, y1};
    if (!rows.fits(width, height)) return DisplayStatus::window_out_of_range;
    const std::size_t count = static_cast<std::size_t>(y1 - y0) * width;
    if (pixels.size() < count) return DisplayStatus::buffer_too_small;
    if (const DisplayStatus status = window(rows); status != DisplayStatus::ok) return status;
    return bus_.pixels(ssd0323::pack_in_place(pixels.first(count)));
  }

  /// Whether the last write is still on its way.
  [[nodiscard]] bool busy() const { return bus_.busy(); }

  /// Sleep switches the display off. The chip would still accept writes, but the driver refuses them, as for every
  /// panel.
  DisplayStatus sleep(bool asleep) {
    if (state_ == State::off) return DisplayStatus::panel_not_ready;
    if (bus_.busy()) return DisplayStatus::bus_busy;
    const DisplayStatus status = send(std::array{asleep || !is_on_ ? ssd0323::display_off : ssd0323::display_on});
    if (status == DisplayStatus::ok) state_ = asleep ? State::asleep : State::awake;
    return status;
  }

 private:
  enum class State : std::uint8_t { off, awake, asleep };

  [[nodiscard]] DisplayStatus ready() const {
    if (state_ == State::off) return DisplayStatus::panel_not_ready;
    if (state_ == State::asleep) return DisplayStatus::panel_asleep;
    return bus_.busy() ? DisplayStatus::bus_busy : DisplayStatus::ok;
  }

  DisplayStatus send(std::span<const std::uint8_t> bytes) {
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      if (const DisplayStatus status = bus_.command(bytes.subspan(i, 1)); status != DisplayStatus::ok) return status;
    }
    return DisplayStatus::ok;
  }

  BusType& bus_;
  ClockType& clock_;
  State state_ = State::off;
  bool is_on_ = false;  ///< since switch_on()
};

}  // namespace spanline::hal
