#pragma once
/// @file
/// Drivers of panels with the MIPI display command set.
///
/// ```cpp
/// // A square of the picture alone: what moves, in front of what stays.
/// template <class Panel>
/// hal::DisplayStatus show_icon(Panel& panel, std::span<std::uint16_t> pixels) {
///   return panel.draw({.x0 = 10, .y0 = 10, .x1 = 26, .y1 = 26}, pixels);
/// }
/// ```
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "spanline/hal/bus.hpp"
#include "spanline/hal/clock.hpp"
#include "spanline/hal/command_table.hpp"
#include "spanline/hal/panel.hpp"

namespace spanline::hal {

/// Bits of a pixel on the bus.
enum class ColourFormat : std::uint8_t {
  rgb565,  ///< 16 bits; bands are sent as they are in memory
  rgb444,  ///< 12 bits: three quarters of the transfer time, but each band is packed in place first
};

/// A program's choices for a panel with the MIPI display command set.
struct MipiOptions {
  Orientation orientation = Orientation::landscape;  ///< how the viewer holds it; landscape by default
  bool mirrored = false;       ///< left and right exchanged, for a panel seen in a mirror; false by default
  bool swap_red_blue = false;  ///< for modules whose colour filters are in the opposite order; false by default
  bool inverted = false;       ///< shows the complement of every colour; false by default
  ColourFormat colours = ColourFormat::rgb565;  ///< bits a pixel on the wire; 16 by default
};

/// What the chips that speak the MIPI display command set (DCS) have in common.
namespace mipi {

inline constexpr std::uint8_t software_reset = 0x01;         ///< all registers as after power-up; wait 120 ms
inline constexpr std::uint8_t sleep_in = 0x10;               ///< wait 120 ms
inline constexpr std::uint8_t sleep_out = 0x11;              ///< wait 120 ms
inline constexpr std::uint8_t normal_mode = 0x13;            ///< neither partial nor scrolling
inline constexpr std::uint8_t inversion_off = 0x20;          ///< colours as they are in the memory
inline constexpr std::uint8_t inversion_on = 0x21;           ///< colours as complements
inline constexpr std::uint8_t display_off = 0x28;            ///< dark; the memory stays
inline constexpr std::uint8_t display_on = 0x29;             ///< shows the memory
inline constexpr std::uint8_t column_address_set = 0x2A;     ///< first and last column of the window
inline constexpr std::uint8_t page_address_set = 0x2B;       ///< first and last row of the window
inline constexpr std::uint8_t memory_write = 0x2C;           ///< pixels follow, from the window's first corner
inline constexpr std::uint8_t memory_access_control = 0x36;  ///< directions, and the order of red and blue
inline constexpr std::uint8_t pixel_format_set = 0x3A;       ///< bits a pixel

inline constexpr std::uint8_t format_12_bits = 0x53;  ///< two pixels in three bytes
inline constexpr std::uint8_t format_16_bits = 0x55;  ///< two bytes a pixel, high byte first

// Bits of the memory access control byte.
inline constexpr std::uint8_t flip_rows = 0x80;     ///< rows from the other end
inline constexpr std::uint8_t flip_columns = 0x40;  ///< columns from the other end
inline constexpr std::uint8_t exchange = 0x20;      ///< rows and columns exchanged
inline constexpr std::uint8_t blue_first = 0x08;    ///< the order BGR

/// The reset pulse is at least 10 µs; this is twice as long, because a board's delay may be coarse.
inline constexpr std::uint32_t reset_low_us = 20;
/// Pause after reset and after entering or leaving sleep: the supplies are stable after 120 ms. Some commands are
/// allowed after 5 ms; waiting once for all of them is simpler.
inline constexpr std::uint32_t settle_ms = 120;

/// The part of a chip's memory that a glass shows, in memory columns and rows as they are with nothing flipped.
struct Glass {
  int memory_columns;  ///< of the whole memory, [1, 65536]
  int memory_rows;     ///< of the whole memory, [1, 65536]
  int column;          ///< memory address of the first pixel, [0, memory_columns − width]
  int row;             ///< memory address of the first pixel, [0, memory_rows − height]
  int width;           ///< of the upright glass, pixels
  int height;          ///< of the upright glass, pixels
};

/// How the viewer's picture maps to the chip's addresses.
struct Addressing {
  std::uint8_t memory_access;  ///< the byte for memory access control
  int width;                   ///< of the picture, pixels
  int height;                  ///< of the picture, pixels
  int column_offset;           ///< address of its first pixel
  int row_offset;              ///< address of its first pixel
};

/// Computes the addressing. `wired_mirrored`: memory column 0 is at the viewer's right. `filters_blue_first`: the glass
/// has its colour filters in the order blue, green, red.
[[nodiscard]] constexpr Addressing addressing(const Glass& glass, bool wired_mirrored, bool filters_blue_first,
                                              const MipiOptions& options) {
  const auto bits = [&]() -> unsigned {
    switch (options.orientation) {
      case Orientation::landscape:
        return flip_columns | exchange;
      case Orientation::portrait_flipped:
        return flip_columns | flip_rows;
      case Orientation::landscape_flipped:
        return flip_rows | exchange;
      case Orientation::portrait:
        break;
    }
    return 0;
  }();
  const bool turned = (bits & exchange) != 0;
  unsigned access = bits;
  if (wired_mirrored) access ^= flip_columns;
  // The viewer's horizontal axis runs along the columns, or along the rows if the panel is turned.
  if (options.mirrored) access ^= turned ? flip_rows : flip_columns;
  const int column = (access & flip_columns) != 0 ? glass.memory_columns - glass.column - glass.width : glass.column;
  const int row = (access & flip_rows) != 0 ? glass.memory_rows - glass.row - glass.height : glass.row;
  if (filters_blue_first != options.swap_red_blue) access |= blue_first;
  return {.memory_access = static_cast<std::uint8_t>(access),
          .width = turned ? glass.height : glass.width,
          .height = turned ? glass.width : glass.height,
          .column_offset = turned ? row : column,
          .row_offset = turned ? column : row};
}

/// Column or page address set: first and last address inclusive, high byte first.
[[nodiscard]] constexpr std::array<std::uint8_t, 5> address_command(std::uint8_t command, int first, int end) {
  const auto start = static_cast<unsigned>(first);
  const auto last = static_cast<unsigned>(end - 1);
  return {command, static_cast<std::uint8_t>(start >> 8), static_cast<std::uint8_t>(start),
          static_cast<std::uint8_t>(last >> 8), static_cast<std::uint8_t>(last)};
}

/// Packs RGB565 words into 12 bits each, in place: two pixels in three bytes, RRRRGGGG BBBBRRRR GGGGBBBB, with the high
/// four bits of each channel. pixels.size() is even. Bytes 3k … 3k + 2 come from words 2k and 2k + 1, which lie no
/// earlier in memory, so no word is overwritten before it is read.
inline std::span<const std::uint8_t> pack_444_in_place(std::span<std::uint16_t> pixels) {
  auto* packed = reinterpret_cast<std::uint8_t*>(pixels.data());
  const auto twelve_bits = [](std::uint32_t pixel) {
    return (pixel >> 4 & 0xF00U) | (pixel >> 3 & 0xF0U) | (pixel >> 1 & 0xFU);
  };
  std::uint8_t* out = packed;
  for (std::size_t i = 0; i + 1 < pixels.size(); i += 2) {
    const std::uint32_t both = twelve_bits(pixels[i]) << 12 | twelve_bits(pixels[i + 1]);
    *out++ = static_cast<std::uint8_t>(both >> 16);
    *out++ = static_cast<std::uint8_t>(both >> 8);
    *out++ = static_cast<std::uint8_t>(both);
  }
  return {packed, static_cast<std::size_t>(out - packed)};
}

}  // namespace mipi

/// Driver of a TFT controller with the MIPI display command set, over a 4-wire serial bus. `Chip` is a table of facts:
/// see `Ili9341Chip`. See `Panel` for what each function does.
///
/// Bands that follow one another from the top are sent without commands between them, because the chip's address
/// advances by itself.
///
/// If the bus can read, init() asks for the chip's identity; identity_status() gives the result. An unexpected answer
/// does not stop anything, because many working modules give one or have no line back.
///
/// After any bus failure the next band sets its window again, so that lost bytes cannot shift the rows of later bands.
template <class Chip, Bus BusType, Clock ClockType, MipiOptions options = MipiOptions{}>
class MipiPanel {
 public:
  /// How the picture lies in the chip's memory.
  static constexpr mipi::Addressing addressing =
      mipi::addressing(Chip::glass, Chip::wired_mirrored, Chip::filters_blue_first, options);
  static constexpr int width = addressing.width;    ///< of the picture as the viewer sees it, pixels
  static constexpr int height = addressing.height;  ///< of the picture as the viewer sees it, pixels
  /// Whether write() packs pixels into 12 bits, in place.
  static constexpr bool packs = options.colours == ColourFormat::rgb444;
  static_assert(!packs || Chip::takes_rgb444, "this chip has no 12-bit pixels on its serial bus");
  static_assert(!packs || width % 2 == 0, "12-bit pixels come in pairs, and a row must end with a pair");
  /// How the words of a band must lie: native where they are packed, else as they go over the wire.
  static constexpr PixelOrder pixel_order = packs ? PixelOrder::native : PixelOrder::high_byte_first;
  static constexpr ClockRating clock_rating = Chip::clock_rating;  ///< the chip's

  /// Both stay with the caller and must outlive the driver.
  MipiPanel(BusType& bus, ClockType& clock) : bus_(bus), clock_(clock) {}

  /// Resets, identifies and wakes the panel, which stays dark; takes 240 to 360 ms. `bus_clock_too_high`,
  /// `bus_timeout`.
  DisplayStatus init() {
    state_ = State::off;
    is_on_ = false;
    next_row_ = none;
    identity_ = DisplayStatus::ok;
    light(false);
    if (clock_rating.verdict(bus_.clock_hz()) == ClockVerdict::too_high) return DisplayStatus::bus_clock_too_high;
    bus_.reset(true);
    clock_.delay_us(mipi::reset_low_us);
    bus_.reset(false);
    if (bus_.busy()) return DisplayStatus::bus_timeout;  // a stuck bus is found here, before the long pauses
    delay_ms(clock_, mipi::settle_ms);
    DisplayStatus status = identify();
    if (status == DisplayStatus::ok) status = send_table();
    if (status == DisplayStatus::ok && packs) status = send(mipi::pixel_format_set, mipi::format_12_bits);
    if (status == DisplayStatus::ok && Chip::shows_complement != options.inverted) status = send(mipi::inversion_on);
    if (status == DisplayStatus::ok) status = send(mipi::memory_access_control, addressing.memory_access);
    if (status == DisplayStatus::ok) state_ = State::awake;
    return status;
  }

  /// Display on, then the backlight, behind the first picture.
  DisplayStatus switch_on() {
    if (const DisplayStatus status = ready(); status != DisplayStatus::ok) return status;
    if (is_on_) return DisplayStatus::ok;
    next_row_ = none;
    const DisplayStatus status = send(mipi::display_on);
    if (status != DisplayStatus::ok) return status;
    is_on_ = true;
    light(true);
    return DisplayStatus::ok;
  }

  /// panel_unidentified if the last init() asked the panel who it is and the answer was not the chip's; else ok.
  [[nodiscard]] DisplayStatus identity_status() const { return identity_; }

  /// What the next pixels() calls of the bus fill.
  DisplayStatus window(const Window& rectangle) {
    if (const DisplayStatus status = ready(); status != DisplayStatus::ok) return status;
    if (!rectangle.fits(width, height)) return DisplayStatus::window_out_of_range;
    next_row_ = none;
    DisplayStatus status = bus_.command(mipi::address_command(
        mipi::column_address_set, rectangle.x0 + addressing.column_offset, rectangle.x1 + addressing.column_offset));
    if (status == DisplayStatus::ok) {
      status = bus_.command(mipi::address_command(mipi::page_address_set, rectangle.y0 + addressing.row_offset,
                                                  rectangle.y1 + addressing.row_offset));
    }
    return status == DisplayStatus::ok ? send(mipi::memory_write) : status;
  }

  /// Sends rows y0 .. y1 − 1; see Panel.
  DisplayStatus write(int y0, int y1, std::span<std::uint16_t> pixels) {
    const Window rows{0, y0, width, y1};
    if (!rows.fits(width, height)) return DisplayStatus::window_out_of_range;
    const std::size_t count = static_cast<std::size_t>(y1 - y0) * width;
    if (pixels.size() < count) return DisplayStatus::buffer_too_small;
    if (y0 == next_row_) {
      if (state_ == State::asleep) return DisplayStatus::panel_asleep;
      if (!takes(y0)) return DisplayStatus::bus_busy;
    } else {
      const DisplayStatus status = window({0, y0, width, height});  // to the last row, so that bands may follow
      if (status != DisplayStatus::ok) return status;
    }
    const DisplayStatus status = start(pixels.first(count));
    next_row_ = status == DisplayStatus::ok && y1 != height ? y1 : none;
    return status;
  }

  /// Sends a single rectangle. `pixels` holds it row by row, an even number of words, and belongs to the bus until
  /// busy() has returned false.
  DisplayStatus draw(const Window& rectangle, std::span<std::uint16_t> pixels) {
    if (!rectangle.fits(width, height)) return DisplayStatus::window_out_of_range;
    const std::size_t count =
        static_cast<std::size_t>(rectangle.x1 - rectangle.x0) * static_cast<std::size_t>(rectangle.y1 - rectangle.y0);
    if (packs && count % 2 != 0) return DisplayStatus::window_out_of_range;
    if (pixels.size() < count) return DisplayStatus::buffer_too_small;
    if (const DisplayStatus status = window(rectangle); status != DisplayStatus::ok) return status;
    return start(pixels.first(count));
  }

  /// Whether the last write is still on its way.
  [[nodiscard]] bool busy() const { return bus_.busy(); }

  /// Whether write() would accept a band that begins at row y0 now. On a bus that queues, a band that follows the last
  /// one may join those still being sent.
  [[nodiscard]] bool takes(int y0) const {
    if constexpr (QueueingBus<BusType>) {
      if (y0 == next_row_) return bus_.takes_pixels();
    }
    return !bus_.busy();
  }

  /// How many of the bands written last still have pixels in their buffers.
  [[nodiscard]] std::uint32_t bands_left() const {
    if constexpr (QueueingBus<BusType>) {
      return bus_.transfers_left();
    } else {
      return bus_.busy() ? 1 : 0;
    }
  }

  /// Shows the complement of every colour, or normal colours again. init() restores the setting of the options.
  DisplayStatus invert(bool inverted) {
    if (const DisplayStatus status = ready(); status != DisplayStatus::ok) return status;
    next_row_ = none;
    return send(inverted != Chip::shows_complement ? mipi::inversion_on : mipi::inversion_off);
  }

  /// Darkens the panel and puts it to sleep, or wakes it and lights it if it was lit; takes 120 ms.
  DisplayStatus sleep(bool asleep) {
    if (state_ == State::off) return DisplayStatus::panel_not_ready;
    if (bus_.busy()) return DisplayStatus::bus_busy;
    if (asleep == (state_ == State::asleep)) return DisplayStatus::ok;
    next_row_ = none;
    const DisplayStatus status = asleep ? fall_asleep() : wake_up();
    if (status == DisplayStatus::ok) state_ = asleep ? State::asleep : State::awake;
    return status;
  }

 private:
  enum class State : std::uint8_t { off, awake, asleep };
  static constexpr int none = -1;

  [[nodiscard]] DisplayStatus ready() const {
    if (state_ == State::off) return DisplayStatus::panel_not_ready;
    if (state_ == State::asleep) return DisplayStatus::panel_asleep;
    return bus_.busy() ? DisplayStatus::bus_busy : DisplayStatus::ok;
  }

  /// The first byte of the answer is ignored: the bus turns round during it, and nothing drives the line.
  DisplayStatus identify() {
    if constexpr (ReadableBus<BusType>) {
      std::array<std::uint8_t, 1 + Chip::identity.size()> answer{};
      if (const DisplayStatus status = bus_.read(Chip::identity_command, answer); status != DisplayStatus::ok)
        return status;
      if (!std::ranges::equal(std::span(answer).subspan(1), Chip::identity))
        identity_ = DisplayStatus::panel_unidentified;
    }
    return DisplayStatus::ok;
  }

  DisplayStatus fall_asleep() {
    light(false);
    DisplayStatus status = send(mipi::display_off);
    if (status == DisplayStatus::ok) status = send(mipi::sleep_in);
    if (status == DisplayStatus::ok) delay_ms(clock_, mipi::settle_ms);
    return status;
  }

  /// Wakes the panel. It stays dark if it was dark before it slept.
  DisplayStatus wake_up() {
    DisplayStatus status = send(mipi::sleep_out);
    if (status != DisplayStatus::ok) return status;
    delay_ms(clock_, mipi::settle_ms);
    if (!is_on_) return DisplayStatus::ok;
    status = send(mipi::display_on);
    if (status == DisplayStatus::ok) light(true);
    return status;
  }

  void light(bool lit) {
    if constexpr (BacklitBus<BusType>) bus_.backlight(lit);
  }

  DisplayStatus send_table() {
    return for_each_step(Chip::init_table, [this](const CommandStep& step) {
      const DisplayStatus sent = bus_.command(step.bytes);
      if (sent == DisplayStatus::ok && step.delay_ms != 0) delay_ms(clock_, step.delay_ms);
      return sent;
    });
  }

  DisplayStatus start(std::span<std::uint16_t> pixels) {
    if constexpr (packs) {
      return bus_.pixels(mipi::pack_444_in_place(pixels));
    } else {
      return bus_.pixels({reinterpret_cast<const std::uint8_t*>(pixels.data()), pixels.size() * 2});
    }
  }

  template <typename... Bytes>
  DisplayStatus send(Bytes... bytes) {
    return bus_.command(std::array<std::uint8_t, sizeof...(Bytes)>{bytes...});
  }

  BusType& bus_;
  ClockType& clock_;
  int next_row_ = none;  ///< row of the chip's address; none: a window must be set first
  State state_ = State::off;
  bool is_on_ = false;  ///< since switch_on()
  DisplayStatus identity_ = DisplayStatus::ok;
};

}  // namespace spanline::hal
