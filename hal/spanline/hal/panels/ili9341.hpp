#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "spanline/hal/bus.hpp"
#include "spanline/hal/clock.hpp"
#include "spanline/hal/command_table.hpp"
#include "spanline/hal/panel.hpp"

namespace spanline::hal {

/// What does not depend on bus or orientation: ILI9341 datasheet, chapter 8 (commands).
namespace ili9341 {

inline constexpr std::uint8_t software_reset = 0x01;
inline constexpr std::uint8_t sleep_in = 0x10;
inline constexpr std::uint8_t sleep_out = 0x11;
inline constexpr std::uint8_t display_off = 0x28;
inline constexpr std::uint8_t display_on = 0x29;
inline constexpr std::uint8_t column_address_set = 0x2A;
inline constexpr std::uint8_t page_address_set = 0x2B;
inline constexpr std::uint8_t memory_write = 0x2C;
inline constexpr std::uint8_t memory_access_control = 0x36;
inline constexpr std::uint8_t pixel_format_set = 0x3A;

inline constexpr int native_width = 240;
inline constexpr int native_height = 320;

/// Reset low for at least 10 µs (reset timing); twice that, as a board's delay may be coarse.
inline constexpr std::uint32_t reset_low_us = 20;
/// After reset and on both ways between sleep and waking: 120 ms until the supplies are stable (sections 8.2.2, 8.2.11,
/// 8.2.12). Some commands are allowed after 5 ms; waiting once for all is simpler.
inline constexpr std::uint32_t settle_ms = 120;

/// From reset to a bright panel, without the orientation. It starts with a software reset for boards that have no reset
/// line. Voltages and gamma are those of the common 2.2" to 2.8" modules.
// clang-format off
inline constexpr auto init_table = std::to_array<std::uint8_t>({
    // bytes, pause in ms, command, arguments
    1, 120, software_reset,
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
    2, 0, pixel_format_set, 0x55,              // 16 bits a pixel on both interfaces
    3, 0, 0xB1, 0x00, 0x18,                    // frame rate 79 Hz
    4, 0, 0xB6, 0x08, 0x82, 0x27,              // display function: normally white, 320 lines
    2, 0, 0xF2, 0x00,                          // three-gamma off
    2, 0, 0x26, 0x01,                          // gamma curve 1
    16, 0, 0xE0, 0x0F, 0x31, 0x2B, 0x0C, 0x0E, 0x08, 0x4E, 0xF1,  // positive gamma
                 0x37, 0x07, 0x10, 0x03, 0x0E, 0x09, 0x00,
    16, 0, 0xE1, 0x00, 0x0E, 0x14, 0x03, 0x11, 0x07, 0x31, 0xC1,  // negative gamma
                 0x48, 0x08, 0x0F, 0x0C, 0x31, 0x36, 0x0F,
    1, 120, sleep_out,
    1, 0, display_on,
});
// clang-format on
static_assert(is_well_formed(init_table));

/// The memory access control byte (section 8.2.29): MY 80, MX 40, MV 20, and BGR 08, for the order in which the common
/// glass has its filters. The glass is wired mirrored, which is why upright portrait has MX set.
[[nodiscard]] constexpr std::uint8_t memory_access(Orientation orientation) {
  constexpr std::uint8_t my = 0x80;
  constexpr std::uint8_t mx = 0x40;
  constexpr std::uint8_t mv = 0x20;
  constexpr std::uint8_t bgr = 0x08;
  switch (orientation) {
    case Orientation::landscape:
      return mv | bgr;
    case Orientation::portrait_flipped:
      return my | bgr;
    case Orientation::landscape_flipped:
      return my | mx | mv | bgr;
    case Orientation::portrait:
      break;
  }
  return mx | bgr;
}

/// Column or page address set: first and last address inclusive, high byte first.
[[nodiscard]] constexpr std::array<std::uint8_t, 5> address_command(std::uint8_t command, int first, int end) {
  const auto start = static_cast<unsigned>(first);
  const auto last = static_cast<unsigned>(end - 1);
  return {command, static_cast<std::uint8_t>(start >> 8), static_cast<std::uint8_t>(start),
          static_cast<std::uint8_t>(last >> 8), static_cast<std::uint8_t>(last)};
}

}  // namespace ili9341

/// Driver of the ILI9341, a 240 × 320 RGB TFT controller, over a 4-wire serial bus. Bands are RGB565, high byte first,
/// and go out as they lie in memory. See `Panel` for what each function does.
template <Bus BusType, Clock ClockType, Orientation orientation = Orientation::landscape>
class Ili9341 {
 public:
  static constexpr bool turned = orientation == Orientation::landscape || orientation == Orientation::landscape_flipped;
  static constexpr int width = turned ? ili9341::native_height : ili9341::native_width;
  static constexpr int height = turned ? ili9341::native_width : ili9341::native_height;
  static constexpr PixelOrder pixel_order = PixelOrder::high_byte_first;
  /// Serial write cycle 100 ns (AC characteristics, 4-line serial interface); common modules on short wires run at 40
  /// MHz.
  static constexpr ClockRating clock_rating{.rated_hz = 10'000'000, .tolerated_hz = 40'000'000};

  Ili9341(BusType& bus, ClockType& clock) : bus_(bus), clock_(clock) {}

  Status init() {
    state_ = State::off;
    if (clock_rating.verdict(bus_.clock_hz()) == ClockVerdict::too_high) return Status::bus_clock_too_high;
    bus_.reset(true);
    clock_.delay_us(ili9341::reset_low_us);
    bus_.reset(false);
    if (bus_.busy()) return Status::bus_timeout;  // a stuck bus shows here, before the long pauses
    delay_ms(clock_, ili9341::settle_ms);
    Status status = for_each_step(ili9341::init_table, [this](const CommandStep& step) {
      const Status sent = bus_.command(step.bytes);
      if (sent == Status::ok && step.delay_ms != 0) delay_ms(clock_, step.delay_ms);
      return sent;
    });
    if (status == Status::ok) status = send(ili9341::memory_access_control, ili9341::memory_access(orientation));
    if (status == Status::ok) state_ = State::awake;
    return status;
  }

  Status window(const Window& rectangle) {
    if (const Status status = ready(); status != Status::ok) return status;
    if (!rectangle.fits(width, height)) return Status::window_out_of_range;
    Status status = bus_.command(ili9341::address_command(ili9341::column_address_set, rectangle.x0, rectangle.x1));
    if (status == Status::ok) {
      status = bus_.command(ili9341::address_command(ili9341::page_address_set, rectangle.y0, rectangle.y1));
    }
    return status == Status::ok ? send(ili9341::memory_write) : status;
  }

  Status write(int y0, int y1, std::span<std::uint16_t> pixels) {
    const Window rows{0, y0, width, y1};
    if (!rows.fits(width, height)) return Status::window_out_of_range;
    const std::size_t count = static_cast<std::size_t>(y1 - y0) * width;
    if (pixels.size() < count) return Status::buffer_too_small;
    if (const Status status = window(rows); status != Status::ok) return status;
    return bus_.pixels({reinterpret_cast<const std::uint8_t*>(pixels.data()), count * 2});
  }

  [[nodiscard]] bool busy() const { return bus_.busy(); }

  Status sleep(bool asleep) {
    if (state_ == State::off) return Status::panel_not_ready;
    if (bus_.busy()) return Status::bus_busy;
    if (asleep == (state_ == State::asleep)) return Status::ok;
    Status status = send(asleep ? ili9341::display_off : ili9341::sleep_out);
    if (status == Status::ok && !asleep) delay_ms(clock_, ili9341::settle_ms);
    if (status == Status::ok) status = send(asleep ? ili9341::sleep_in : ili9341::display_on);
    if (status != Status::ok) return status;
    if (asleep) delay_ms(clock_, ili9341::settle_ms);
    state_ = asleep ? State::asleep : State::awake;
    return Status::ok;
  }

 private:
  enum class State : std::uint8_t { off, awake, asleep };

  [[nodiscard]] Status ready() const {
    if (state_ == State::off) return Status::panel_not_ready;
    if (state_ == State::asleep) return Status::panel_asleep;
    return bus_.busy() ? Status::bus_busy : Status::ok;
  }

  template <typename... Bytes>
  Status send(Bytes... bytes) {
    return bus_.command(std::array<std::uint8_t, sizeof...(Bytes)>{bytes...});
  }

  BusType& bus_;
  ClockType& clock_;
  State state_ = State::off;
};

}  // namespace spanline::hal
