#include "panels/panel_model.hpp"

#include <algorithm>
#include <utility>

namespace spanline::sim {

void PanelModel::reset_line(bool low, std::uint64_t now_ns) {
  now_ns_ = now_ns;
  if (low == reset_low_) return;
  reset_low_ = low;
  if (low) {
    complain_of_light("the reset line goes low");
    reset_start_ns_ = now_ns;
    return;
  }
  const std::uint64_t held_ns = now_ns - reset_start_ns_;
  if (held_ns < limits_.reset_low_ns) {
    complain(ComplaintKind::reset_too_short, "reset held low for " + std::to_string(held_ns) + " ns, the panel wants " +
                                                 std::to_string(limits_.reset_low_ns) + " ns");
  }
  was_reset_ = true;
  pause_until_ns_ = 0;
  require_pause(limits_.reset_settle_ns, "reset");
  on_reset();
}

void PanelModel::mark_reset() {
  complain_of_light("a software reset");
  was_reset_ = true;
}

void PanelModel::backlight_line(bool lit, std::uint64_t now_ns) {
  now_ns_ = now_ns;
  backlight_is_switched_ = true;
  lit_ = lit;
  if (lit && !shows_picture()) {
    complain(ComplaintKind::shown_before_picture, "the backlight goes on before the panel shows a picture");
  }
}

void PanelModel::complain_of_light(const char* what) {
  if (!backlight_is_switched_ || !lit_) return;
  complain(ComplaintKind::shown_before_picture, std::string(what) + " while the backlight is on");
}

void PanelModel::lose_power(std::uint64_t now_ns) {
  now_ns_ = now_ns;
  was_reset_ = false;
  pause_until_ns_ = 0;
  on_power_up();
  on_reset();
}

void PanelModel::byte(bool data, std::uint8_t value, std::uint64_t now_ns) {
  now_ns_ = now_ns;
  if (reset_low_) {
    complain(ComplaintKind::byte_during_reset, hex(value) + " sent while the reset line is low");
    return;
  }
  if (!data && now_ns < pause_until_ns_) {
    complain(ComplaintKind::missing_delay, "command " + hex(value) + " sent " +
                                               std::to_string((pause_until_ns_ - now_ns + 999) / 1000) +
                                               " us too soon after " + pause_after_);
    pause_until_ns_ = now_ns;  // one complaint a pause
  }
  const bool reset_before = was_reset_;
  data ? on_data(value) : on_command(value);
  if (!reset_before && !was_reset_) {
    complain(ComplaintKind::missing_reset, hex(value) + " sent before any reset");
  }
}

std::vector<std::uint8_t> PanelModel::read(std::uint8_t command, std::uint64_t now_ns) {
  now_ns_ = now_ns;
  return reset_low_ ? std::vector<std::uint8_t>{} : on_read(command);
}

void PanelModel::set_clock(std::uint32_t clock_hz, std::uint64_t now_ns) {
  const std::string clock = "bus clock " + std::to_string(clock_hz) + " Hz, ";
  switch (limits_.clock.verdict(clock_hz)) {
    case hal::ClockVerdict::rated:
      break;
    case hal::ClockVerdict::above_rating:
      complain(ComplaintKind::clock_above_rating, clock + "rated " + std::to_string(limits_.clock.rated_hz) + " Hz",
               now_ns);
      break;
    case hal::ClockVerdict::too_high:
      complain(ComplaintKind::clock_too_high, clock + "tolerated " + std::to_string(limits_.clock.tolerated_hz) + " Hz",
               now_ns);
      break;
  }
}

void PanelModel::complain(ComplaintKind kind, std::string text, std::uint64_t now_ns) {
  const auto known = std::find_if(complaints_.begin(), complaints_.end(),
                                  [kind](const Complaint& complaint) { return complaint.kind == kind; });
  if (known != complaints_.end()) {
    ++known->count;
  } else {
    complaints_.push_back({.kind = kind, .text = std::move(text), .first_ns = now_ns, .count = 1});
  }
}

void PanelModel::require_pause(std::uint64_t ns, std::string after) {
  if (now_ns_ + ns <= pause_until_ns_) return;
  pause_until_ns_ = now_ns_ + ns;
  pause_after_ = std::move(after);
}

std::string hex(std::uint8_t value) {
  constexpr const char* digits = "0123456789ABCDEF";
  return {'0', 'x', digits[value >> 4], digits[value & 15]};
}

}  // namespace spanline::sim
