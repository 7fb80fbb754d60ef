#include "panels/complaint.hpp"

#include <algorithm>

namespace spanline::sim {

Severity severity(ComplaintKind kind) {
  switch (kind) {
    case ComplaintKind::clock_above_rating:
    case ComplaintKind::more_pixels_than_window:
    case ComplaintKind::not_modelled:
      return Severity::warning;
    default:
      return Severity::failure;
  }
}

const char* to_string(ComplaintKind kind) {
  switch (kind) {
    case ComplaintKind::clock_above_rating:
      return "clock_above_rating";
    case ComplaintKind::clock_too_high:
      return "clock_too_high";
    case ComplaintKind::missing_reset:
      return "missing_reset";
    case ComplaintKind::reset_too_short:
      return "reset_too_short";
    case ComplaintKind::byte_during_reset:
      return "byte_during_reset";
    case ComplaintKind::missing_delay:
      return "missing_delay";
    case ComplaintKind::unknown_command:
      return "unknown_command";
    case ComplaintKind::wrong_argument_count:
      return "wrong_argument_count";
    case ComplaintKind::data_without_command:
      return "data_without_command";
    case ComplaintKind::window_out_of_range:
      return "window_out_of_range";
    case ComplaintKind::write_during_sleep:
      return "write_during_sleep";
    case ComplaintKind::more_pixels_than_window:
      return "more_pixels_than_window";
    case ComplaintKind::partial_pixel:
      return "partial_pixel";
    case ComplaintKind::shown_before_picture:
      return "shown_before_picture";
    case ComplaintKind::wrong_setup:
      return "wrong_setup";
    case ComplaintKind::not_modelled:
      return "not_modelled";
    case ComplaintKind::bus_used_while_busy:
      return "bus_used_while_busy";
    case ComplaintKind::buffer_changed_in_flight:
      return "buffer_changed_in_flight";
  }
  return "unknown";
}

std::string describe(const Complaint& complaint) {
  std::string line = severity(complaint.kind) == Severity::warning ? "warning: " : "failure: ";
  line += to_string(complaint.kind);
  line += ": " + complaint.text + " (at " + std::to_string(complaint.first_ns / 1000) + " us";
  if (complaint.count > 1) line += ", " + std::to_string(complaint.count) + " times";
  return line + ")";
}

bool any_failure(std::span<const Complaint> complaints) {
  return std::any_of(complaints.begin(), complaints.end(),
                     [](const Complaint& complaint) { return severity(complaint.kind) == Severity::failure; });
}

}  // namespace spanline::sim
