#pragma once
/// @file
/// Init tables of panels.
///
/// ```cpp
/// // Bytes, pause in ms, command, arguments.
/// constexpr std::uint8_t wake_up[] = {1, 120, 0x11, 2, 0, 0x3A, 0x55};
/// static_assert(hal::is_well_formed(wake_up));
///
/// template <class Bus, class Clock>
/// hal::DisplayStatus send(Bus& bus, Clock& clock) {
///   return hal::for_each_step(wake_up, [&](const hal::CommandStep& step) {
///     const hal::DisplayStatus status = bus.command(step.bytes);
///     clock.delay_us(1000 * step.delay_ms);
///     return status;
///   });
/// }
/// ```
#include <cstddef>
#include <cstdint>
#include <span>

#include "spanline/hal/display_status.hpp"

namespace spanline::hal {

/// One step of an init table: a command byte with its arguments, then a pause.
struct CommandStep {
  std::span<const std::uint8_t> bytes;  ///< command byte, then its arguments
  std::uint32_t delay_ms;               ///< pause after the command, milliseconds
};

/// Reads an init table: bytes in flash, one record for each command. A record is the number n of bytes to send (1 ..
/// 255), the pause afterwards in milliseconds (0 .. 255), and the n bytes. Calls `visit(CommandStep)` for each record,
/// and stops at the first status that is not ok and returns it.
template <typename Visitor>
constexpr DisplayStatus for_each_step(std::span<const std::uint8_t> table, Visitor&& visit) {
  std::size_t at = 0;
  while (at < table.size()) {
    const std::size_t length = table[at];
    const DisplayStatus status = visit(CommandStep{table.subspan(at + 2, length), table[at + 1]});
    if (status != DisplayStatus::ok) return status;
    at += 2 + length;
  }
  return DisplayStatus::ok;
}

/// Whether the records of a table fill it exactly and none is empty; for static_assert beside the table.
[[nodiscard]] constexpr bool is_well_formed(std::span<const std::uint8_t> table) {
  std::size_t at = 0;
  while (at < table.size()) {
    if (table[at] == 0 || table.size() - at < 2U + table[at]) return false;
    at += 2U + table[at];
  }
  return true;
}

}  // namespace spanline::hal
