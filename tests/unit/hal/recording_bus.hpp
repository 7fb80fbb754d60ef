#pragma once
#include <cstdint>
#include <ostream>
#include <span>
#include <vector>

#include "panels/sim_clock.hpp"
#include "spanline/hal/display_status.hpp"

namespace spanline::hal {
// NOLINTNEXTLINE(readability-identifier-naming): GoogleTest looks for this name.
inline void PrintTo(DisplayStatus status, std::ostream* out) { *out << to_string(status); }
}  // namespace spanline::hal

namespace spanline::test {

using Bytes = std::vector<std::uint8_t>;

/// A bus that writes down what a driver does to it, and finishes everything at once.
class RecordingBus {
 public:
  struct Event {
    enum class Kind { reset_low, reset_high, command, pixels } kind;
    Bytes bytes;
    std::uint64_t at_us;
  };

  explicit RecordingBus(sim::SimClock& clock, std::uint32_t clock_hz = 1'000'000)
      : clock_(clock), clock_hz_(clock_hz) {}

  hal::DisplayStatus command(std::span<const std::uint8_t> bytes) {
    note(Event::Kind::command, bytes);
    return commands_time_out ? hal::DisplayStatus::bus_timeout : hal::DisplayStatus::ok;
  }
  hal::DisplayStatus pixels(std::span<const std::uint8_t> bytes) {
    note(Event::Kind::pixels, bytes);
    return hal::DisplayStatus::ok;
  }
  [[nodiscard]] bool busy() const { return is_busy; }
  void reset(bool held) { note(held ? Event::Kind::reset_low : Event::Kind::reset_high, {}); }
  [[nodiscard]] std::uint32_t clock_hz() const { return clock_hz_; }

  /// The bytes of all commands so far, one entry a call.
  [[nodiscard]] std::vector<Bytes> commands() const {
    std::vector<Bytes> all;
    for (const Event& event : events) {
      if (event.kind == Event::Kind::command) all.push_back(event.bytes);
    }
    return all;
  }

  std::vector<Event> events;
  bool is_busy = false;
  bool commands_time_out = false;

 private:
  void note(Event::Kind kind, std::span<const std::uint8_t> bytes) {
    events.push_back({kind, Bytes(bytes.begin(), bytes.end()), clock_.now_ns() / 1000});
  }

  sim::SimClock& clock_;
  std::uint32_t clock_hz_;
};

}  // namespace spanline::test
