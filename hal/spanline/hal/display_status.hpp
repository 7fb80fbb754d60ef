#pragma once
/// @file
/// What calls of the HAL return.
///
/// ```cpp
/// const char* say(hal::DisplayStatus status) {
///   return status == hal::DisplayStatus::ok ? "shown" : hal::to_string(status);
/// }
/// ```
#include <cstdint>

namespace spanline::hal {

/// The result of a HAL call. With every value but `ok` the call has not done what it was asked to do, except where a
/// value is called a warning.
enum class [[nodiscard]] DisplayStatus : std::uint8_t{
    ok,                   ///< done
    bus_timeout,          ///< the bus did not finish a transfer in time; the frame is abandoned
    bus_busy,             ///< a transfer is still in flight: wait until the bus is not busy
    bus_clock_too_high,   ///< the bus clock is above what the panel's table tolerates
    bus_clock_too_low,    ///< a warning: the divider gives less than was asked for; pictures are right but take longer
    panel_unidentified,   ///< a warning: the panel did not answer with the identity of its chip
    window_out_of_range,  ///< a window or band is empty, outside the panel, off its column grid or of another width
    buffer_too_small,     ///< the pixel buffer holds fewer pixels than the rows need
    panel_not_ready,      ///< pixels or sleep before a successful init()
    panel_asleep,         ///< pixels while the panel sleeps
    out_of_order,         ///< a present call outside a frame, an unknown buffer, or a buffer that the bus still owns
};

/// The name of a status, for consoles and test output.
[[nodiscard]] constexpr const char* to_string(DisplayStatus status) {
  switch (status) {
    case DisplayStatus::ok:
      return "ok";
    case DisplayStatus::bus_timeout:
      return "bus_timeout";
    case DisplayStatus::bus_busy:
      return "bus_busy";
    case DisplayStatus::bus_clock_too_high:
      return "bus_clock_too_high";
    case DisplayStatus::bus_clock_too_low:
      return "bus_clock_too_low";
    case DisplayStatus::panel_unidentified:
      return "panel_unidentified";
    case DisplayStatus::window_out_of_range:
      return "window_out_of_range";
    case DisplayStatus::buffer_too_small:
      return "buffer_too_small";
    case DisplayStatus::panel_not_ready:
      return "panel_not_ready";
    case DisplayStatus::panel_asleep:
      return "panel_asleep";
    case DisplayStatus::out_of_order:
      return "out_of_order";
  }
  return "unknown";
}

}  // namespace spanline::hal
