#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "spanline/hal/clock.hpp"
#include "spanline/hal/panel.hpp"
#include "spanline/hal/status.hpp"

namespace spanline::hal {

/// What a present loop has done so far; counts wrap at 2^32. `last_…` describe the frame that ended last.
struct PresentStatistics {
  std::uint32_t frames = 0;           ///< frames that reached the panel whole
  std::uint32_t frames_given_up = 0;  ///< frames that failed, at their begin or later
  std::uint32_t bands = 0;            ///< bands handed to the panel
  std::uint32_t initialisations = 0;  ///< successful panel inits: 1, and one for each recovery
  std::uint32_t last_frame_us = 0;    ///< from begin_frame (without a panel init) to end_frame, microseconds
  std::uint32_t last_wait_us = 0;     ///< how much of that went into waiting for the bus, microseconds
};

/// The present loop: one band is drawn while the other is on its way to the panel.
///
///     Status status = present.begin_frame();
///     for (int y = 0, index = 0; status == Status::ok && y < height; y += band, index ^= 1) {
///       status = present.acquire(index);
///       if (status != Status::ok) break;
///       draw(y, present.buffer(index));  // while the other buffer leaves
///       status = present.submit(y, y + band, index);
///     }
///     status = present.end_frame();  // the frame's first failure, or ok
///
/// Waiting ends after the timeout: the frame is given up, and every call returns its failure until the next
/// begin_frame, which initialises the panel anew (reset, init table) and goes on if the bus works again.
template <Panel PanelType, Clock ClockType>
class Present {
 public:
  /// Longer than a whole 320 × 240 frame at 10 MHz (123 ms).
  static constexpr std::uint32_t default_timeout_us = 250'000;

  /// Both buffers are the caller's, in RAM that the bus's DMA reaches; each holds the rows of the tallest band. The
  /// timeout is for one wait and longer than the transfer of one band: rows × width × 16 bits / bus clock.
  Present(PanelType& panel, ClockType& clock, std::span<std::uint16_t> first, std::span<std::uint16_t> second,
          std::uint32_t timeout_us = default_timeout_us)
      : panel_(panel), clock_(clock), buffers_{first, second}, timeout_us_(timeout_us) {}

  /// Starts a frame; initialises the panel for the first one and after a bus timeout. `out_of_order` if a frame is
  /// under way that has not failed; else what Panel::init returned. After a failure there is no frame.
  Status begin_frame() {
    if (in_frame_ && failure_ == Status::ok) return Status::out_of_order;
    if (in_frame_) count_end();
    if (needs_init_) {
      failure_ = panel_.init();
      if (failure_ != Status::ok) {
        ++statistics_.frames_given_up;
        return failure_;
      }
      needs_init_ = false;
      in_flight_ = none;
      ++statistics_.initialisations;
    }
    in_frame_ = true;
    failure_ = Status::ok;
    wait_us_ = 0;
    start_us_ = clock_.now_us();
    return Status::ok;
  }

  /// Waits until buffer 0 or 1 may be drawn into. Does not wait when only the other one is in flight.
  Status acquire(int index) {
    if (const Status status = check(index); status != Status::ok) return status;
    return index == in_flight_ ? wait_idle() : Status::ok;
  }

  /// The memory of buffer 0 or 1, whose words lie in the panel's pixel order. Drawn into only between acquire and
  /// submit.
  [[nodiscard]] std::span<std::uint16_t> buffer(int index) const { return buffers_[index == 0 ? 0 : 1]; }

  /// Hands over rows y0 .. y1 − 1, full width, from the start of an acquired buffer; waits until the previous band has
  /// left. The buffer's words mean nothing afterwards. `window_out_of_range`, `buffer_too_small` and `out_of_order`
  /// leave the frame alive; everything else gives it up.
  Status submit(int y0, int y1, int index) {
    if (const Status status = check(index); status != Status::ok) return status;
    if (index == in_flight_) return Status::out_of_order;
    if (!Window{0, y0, PanelType::width, y1}.fits(PanelType::width, PanelType::height)) {
      return Status::window_out_of_range;
    }
    const std::size_t count = static_cast<std::size_t>(y1 - y0) * PanelType::width;
    if (buffer(index).size() < count) return Status::buffer_too_small;
    if (const Status status = wait_idle(); status != Status::ok) return status;
    if (const Status status = panel_.write(y0, y1, buffer(index).first(count)); status != Status::ok) {
      return give_up(status);
    }
    in_flight_ = index;
    ++statistics_.bands;
    return Status::ok;
  }

  /// Waits for the last band and ends the frame. Returns the frame's first failure, or ok.
  Status end_frame() {
    if (!in_frame_) return failure_ == Status::ok ? Status::out_of_order : failure_;
    if (failure_ == Status::ok) static_cast<void>(wait_idle());  // a failure is in failure_
    count_end();
    return failure_;
  }

  [[nodiscard]] const PresentStatistics& statistics() const { return statistics_; }

 private:
  static constexpr int none = -1;

  [[nodiscard]] Status check(int index) const {
    if (failure_ != Status::ok) return failure_;
    if (!in_frame_) return Status::out_of_order;
    return index == 0 || index == 1 ? Status::ok : Status::out_of_order;
  }

  Status wait_idle() {
    if (panel_.busy()) {
      const std::uint32_t start = clock_.now_us();
      bool late = false;
      while (panel_.busy() && !late) late = clock_.now_us() - start >= timeout_us_;
      wait_us_ += clock_.now_us() - start;
      if (late && panel_.busy()) return give_up(Status::bus_timeout);
    }
    in_flight_ = none;
    return Status::ok;
  }

  Status give_up(Status status) {
    failure_ = status;
    needs_init_ = needs_init_ || status == Status::bus_timeout;
    return status;
  }

  void count_end() {
    in_frame_ = false;
    ++(failure_ == Status::ok ? statistics_.frames : statistics_.frames_given_up);
    statistics_.last_frame_us = clock_.now_us() - start_us_;
    statistics_.last_wait_us = wait_us_;
  }

  PanelType& panel_;
  ClockType& clock_;
  std::array<std::span<std::uint16_t>, 2> buffers_;
  std::uint32_t timeout_us_;
  std::uint32_t start_us_ = 0;
  std::uint32_t wait_us_ = 0;
  PresentStatistics statistics_;
  int in_flight_ = none;
  Status failure_ = Status::ok;
  bool in_frame_ = false;
  bool needs_init_ = true;
};

}  // namespace spanline::hal
