#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "panels/panel_model.hpp"
#include "panels/sim_clock.hpp"
#include "spanline/hal/bus.hpp"

namespace spanline::sim {

/// A serial bus that satisfies hal::Bus and feeds a panel model, in simulated time: every byte takes eight clocks.
///
/// pixels() returns at once, as with DMA. The model gets the bytes when the transfer is over, from the caller's buffer
/// as it is then, and a buffer that changed in between is complained of.
class HostBus {
 public:
  HostBus(PanelModel& model, SimClock& clock, std::uint32_t clock_hz)
      : model_(model), clock_(clock), clock_hz_(clock_hz) {
    model_.set_clock(clock_hz, clock_.now_ns());
  }

  hal::DisplayStatus command(std::span<const std::uint8_t> bytes) {
    refuse_while_busy("command");
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      clock_.advance_ns(transfer_ns(1));
      model_.byte(i != 0, bytes[i], clock_.now_ns());
    }
    return hal::DisplayStatus::ok;
  }

  /// At 1 MHz. A panel that does not answer leaves the line high.
  hal::DisplayStatus read(std::uint8_t command, std::span<std::uint8_t> answer) {
    refuse_while_busy("read");
    clock_.advance_ns(8'000 * (1 + answer.size()));
    const std::vector<std::uint8_t> said = model_.read(command, clock_.now_ns());
    for (std::size_t i = 0; i < answer.size(); ++i) answer[i] = i < said.size() ? said[i] : 0xFF;
    return hal::DisplayStatus::ok;
  }

  hal::DisplayStatus pixels(std::span<const std::uint8_t> bytes) {
    refuse_while_busy("pixels");
    in_flight_ = bytes;
    at_start_.assign(bytes.begin(), bytes.end());
    done_ns_ = clock_.now_ns() + transfer_ns(bytes.size());
    return hal::DisplayStatus::ok;
  }

  bool busy() {
    if (in_flight_.empty()) return false;
    if (clock_.now_ns() < done_ns_) return true;
    deliver();
    return false;
  }

  void reset(bool held) {
    if (held) in_flight_ = {};
    model_.reset_line(held, clock_.now_ns());
  }

  void backlight(bool lit) { model_.backlight_line(lit, clock_.now_ns()); }

  [[nodiscard]] std::uint32_t clock_hz() const { return clock_hz_; }

 private:
  [[nodiscard]] std::uint64_t transfer_ns(std::uint64_t bytes) const { return bytes * 8'000'000'000U / clock_hz_; }

  void refuse_while_busy(const char* verb) {
    if (!busy()) return;
    model_.complain(ComplaintKind::bus_used_while_busy, std::string(verb) + " during a transfer", clock_.now_ns());
    clock_.advance_ns(done_ns_ - clock_.now_ns());
    deliver();
  }

  void deliver() {
    if (!std::equal(in_flight_.begin(), in_flight_.end(), at_start_.begin())) {
      model_.complain(ComplaintKind::buffer_changed_in_flight, "pixels changed before they had left", clock_.now_ns());
    }
    for (const std::uint8_t value : in_flight_) model_.byte(true, value, done_ns_);
    in_flight_ = {};
  }

  PanelModel& model_;
  SimClock& clock_;
  std::uint32_t clock_hz_;
  std::span<const std::uint8_t> in_flight_;
  std::vector<std::uint8_t> at_start_;
  std::uint64_t done_ns_ = 0;
};

}  // namespace spanline::sim
