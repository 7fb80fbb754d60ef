#pragma once
/// @file
/// What a display is to programs.
///
/// ```cpp
/// // Fills the panel with one colour; `row` holds a row of pixels.
/// template <hal::Panel Panel>
/// hal::DisplayStatus fill(Panel& panel, std::uint16_t (&row)[Panel::width]) {
///   hal::DisplayStatus status = panel.init();
///   for (int y = 0; status == hal::DisplayStatus::ok && y < Panel::height; ++y) {
///     while (panel.busy()) {}
///     for (std::uint16_t& pixel : row) pixel = hal::to_pixel_order(Panel::pixel_order, 0x051F);
///     status = panel.write(y, y + 1, row);
///   }
///   while (panel.busy()) {}
///   return status == hal::DisplayStatus::ok ? panel.switch_on() : status;
/// }
/// ```
#include <concepts>
#include <cstdint>
#include <span>

#include "spanline/hal/clock_rating.hpp"
#include "spanline/hal/display_status.hpp"
#include "spanline/hal/pixel_order.hpp"

namespace spanline::hal {

/// A rectangle of pixels, half open: columns x0 .. x1 − 1, rows y0 .. y1 − 1, from the top left of the picture.
struct Window {
  int x0 = 0;  ///< first column, pixels, [0, width − 1]
  int y0 = 0;  ///< first row, pixels, [0, height − 1]
  int x1 = 0;  ///< behind the last column, pixels, [1, width]
  int y1 = 0;  ///< behind the last row, pixels, [1, height]

  /// Whether it holds a pixel and lies inside `width` × `height`.
  [[nodiscard]] constexpr bool fits(int width, int height) const {
    return x0 >= 0 && y0 >= 0 && x0 < x1 && y0 < y1 && x1 <= width && y1 <= height;
  }

  /// The same rectangle.
  friend constexpr bool operator==(const Window&, const Window&) = default;
};

/// How the panel is held, in quarter turns from its native portrait.
enum class Orientation : std::uint8_t {
  portrait,           ///< not turned
  landscape,          ///< a quarter turn
  portrait_flipped,   ///< upside down
  landscape_flipped,  ///< three quarter turns
};

/// A display panel: a driver composed over a bus and a clock at compile time.
///
/// - `width`, `height`: the picture as the viewer sees it, pixels. `pixel_order`: how a band's words must lie.
/// - `init()`: reset, init table and wake-up; leaves the panel awake and dark, because its memory holds noise. May be
///   called again at any time, and is how a panel is brought back after a bus failure or a loss of power.
/// - `switch_on()`: shows the memory, then lights the backlight where the bus has one. To be called when the first
///   picture after an init() has left the bus; nothing happens where the panel is on already.
/// - `window(w)`: the rectangle that the next pixels() calls of the bus fill, row by row.
/// - `write(y0, y1, pixels)`: sends rows y0 .. y1 − 1 in full width; `pixels` holds at least (y1 − y0) × width words.
///   May return before they have left. The driver may change the words (a panel with fewer colours packs them in
///   place), so they mean nothing afterwards; the memory is the bus's until busy() has returned false.
/// - `busy()`: whether the last write is still on its way.
/// - `sleep(asleep)`: puts the panel to sleep, which is dark, or wakes it; the panel keeps its picture.
///
/// All but busy() want a bus that is not busy, and say bus_busy otherwise; init() abandons a transfer in flight.
template <typename P>
concept Panel = requires(P& panel, const Window& rectangle, int row, std::span<std::uint16_t> pixels, bool asleep) {
  { P::width } -> std::convertible_to<int>;
  { P::height } -> std::convertible_to<int>;
  { P::pixel_order } -> std::convertible_to<PixelOrder>;
  { P::clock_rating } -> std::convertible_to<ClockRating>;
  { panel.init() } -> std::same_as<DisplayStatus>;
  { panel.switch_on() } -> std::same_as<DisplayStatus>;
  { panel.window(rectangle) } -> std::same_as<DisplayStatus>;
  { panel.write(row, row, pixels) } -> std::same_as<DisplayStatus>;
  { panel.busy() } -> std::same_as<bool>;
  { panel.sleep(asleep) } -> std::same_as<DisplayStatus>;
};

}  // namespace spanline::hal
