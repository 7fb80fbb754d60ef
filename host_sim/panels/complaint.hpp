#pragma once
#include <cstdint>
#include <span>
#include <string>

namespace spanline::sim {

/// What a panel model, or the bus in front of it, finds wrong with a stream of bytes.
enum class ComplaintKind : std::uint8_t {
  clock_above_rating,        ///< warning: bus clock above the datasheet's rating, and tolerated
  clock_too_high,            ///< bus clock above what the panel's table tolerates
  missing_reset,             ///< a command before any reset: registers are unknown after power-up
  reset_too_short,           ///< reset line held low for less than the datasheet wants
  byte_during_reset,         ///< bytes while the reset line is low
  missing_delay,             ///< a command too soon after reset, software reset, sleep in or sleep out
  unknown_command,           ///< a command byte that the datasheet does not list
  wrong_argument_count,      ///< too few or too many arguments
  data_without_command,      ///< data where no command takes any
  window_out_of_range,       ///< window reversed, or outside the memory
  write_during_sleep,        ///< pixels while the panel sleeps
  more_pixels_than_window,   ///< warning: the write wrapped round and overwrote its own start
  partial_pixel,             ///< a write that stopped within a pixel
  shown_before_picture,      ///< display or backlight on while the glass shows noise, or a reset in full light
  wrong_setup,               ///< registers that do not suit the glass
  not_modelled,              ///< warning: a legal command whose effect on the picture the model does not show
  bus_used_while_busy,       ///< command or pixels while a transfer was in flight
  buffer_changed_in_flight,  ///< pixels changed between pixels() and the end of the transfer
};

enum class Severity : std::uint8_t { warning, failure };

/// One kind of complaint, however often it was raised.
struct Complaint {
  ComplaintKind kind{};
  std::string text;            ///< what exactly was wrong, the first time
  std::uint64_t first_ns = 0;  ///< simulated time of the first time, nanoseconds
  std::uint64_t count = 0;     ///< how often it happened
};

/// `clock_above_rating`, `more_pixels_than_window` and `not_modelled` are warnings; all else is a failure.
[[nodiscard]] Severity severity(ComplaintKind kind);

/// The kind's name, as it is spelled in the enumeration.
[[nodiscard]] const char* to_string(ComplaintKind kind);

/// One line: severity, name, text, time and count.
[[nodiscard]] std::string describe(const Complaint& complaint);

/// Whether any of them is a failure.
[[nodiscard]] bool any_failure(std::span<const Complaint> complaints);

}  // namespace spanline::sim
