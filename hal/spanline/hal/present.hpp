#pragma once
/// @file
/// The present loop, which sends a band while the next is drawn.
///
/// ```cpp
/// // The loop by itself; hal::DisplaySink has it for renderers.
/// template <class Present, class Draw>
/// hal::DisplayStatus show(Present& present, int height, int band, Draw draw) {
///   hal::DisplayStatus status = present.begin_frame();
///   for (int y = 0, index = 0; status == hal::DisplayStatus::ok && y < height; y += band, index ^= 1) {
///     status = present.acquire(index);
///     if (status != hal::DisplayStatus::ok) break;
///     draw(y, present.buffer(index));  // while the other buffer leaves
///     status = present.submit(y, y + band, index);
///   }
///   return present.end_frame();  // the frame's first failure, or ok
/// }
/// ```
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "spanline/hal/clock.hpp"
#include "spanline/hal/display_status.hpp"
#include "spanline/hal/panel.hpp"

namespace spanline::hal {

/// Counts of a present loop, which wrap at 2^32. `last_…` describe the last frame that ended.
struct PresentStatistics {
  std::uint32_t frames = 0;           ///< frames that reached the panel completely
  std::uint32_t frames_given_up = 0;  ///< frames that failed, at their start or later
  std::uint32_t bands = 0;            ///< bands handed to the panel
  std::uint32_t initialisations = 0;  ///< successful panel inits: 1, and one for each recovery or restart_panel()
  std::uint32_t last_frame_us = 0;    ///< from begin_frame (without a panel init) to end_frame, microseconds
  std::uint32_t last_wait_us = 0;     ///< part of last_frame_us spent waiting for the bus, microseconds
};

/// The present loop: one band is drawn while others are sent to the panel. Two buffers suffice. Over a bus that queues,
/// more buffers let drawing run ahead on quick rows, which makes up for slow rows and for the next frame's geometry.
///
/// After a panel init the panel is dark. The first frame must cover the whole panel; its end waits until it is sent and
/// then switches the panel on.
///
/// A wait that exceeds the timeout abandons the frame, and every call returns its failure until the next begin_frame.
/// That initialises the panel again (reset, init table) and continues if the bus works. The bus cannot notice a panel
/// that lost its power; a program that learns of it calls restart_panel().
template <Panel PanelType, Clock ClockType>
class Present {
 public:
  /// Longer than a whole 320 × 240 frame at 10 MHz (123 ms).
  static constexpr std::uint32_t default_timeout_us = 250'000;

  static constexpr int most_buffers = 16;  ///< those behind them are not used

  /// The buffers are the caller's, in RAM that the bus's DMA reaches. Each holds the rows of the tallest band; empty
  /// ones do not count. The timeout is for one wait, and must exceed the transfer time of all buffers: rows × width ×
  /// 16 bits / bus clock.
  Present(PanelType& panel, ClockType& clock, std::span<const std::span<std::uint16_t>> buffers,
          std::uint32_t timeout_us = default_timeout_us)
      : panel_(panel), clock_(clock), timeout_us_(timeout_us) {
    for (const auto& buffer : buffers) {
      if (buffer_count_ < most_buffers && !buffer.empty())
        buffers_[static_cast<std::size_t>(buffer_count_++)].words = buffer;
    }
  }
  /// The same with two buffers.
  Present(PanelType& panel, ClockType& clock, std::span<std::uint16_t> first, std::span<std::uint16_t> second,
          std::uint32_t timeout_us = default_timeout_us)
      : Present(panel, clock, std::array{first, second}, timeout_us) {}

  /// Starts a frame, and initialises the panel before the first one and after a bus timeout. Returns `out_of_order` if
  /// a frame is in progress that has not failed, otherwise what Panel::init returned. After a failure no frame is in
  /// progress.
  DisplayStatus begin_frame() {
    if (in_frame_ && failure_ == DisplayStatus::ok) return DisplayStatus::out_of_order;
    if (in_frame_) count_end();
    if (needs_init_) {
      failure_ = panel_.init();
      if (failure_ != DisplayStatus::ok) {
        ++statistics_.frames_given_up;
        return failure_;
      }
      needs_init_ = false;
      is_dark_ = true;
      for (Buffer& buffer : buffers_) buffer.number = 0;
      ++statistics_.initialisations;
    }
    in_frame_ = true;
    failure_ = DisplayStatus::ok;
    wait_us_ = 0;
    start_us_ = clock_.now_us();
    return DisplayStatus::ok;
  }

  /// Whether acquire() would return at once.
  [[nodiscard]] bool available(int index) {
    if (check(index) != DisplayStatus::ok) return true;
    const Buffer& buffer = buffers_[static_cast<std::size_t>(index)];
    return buffer.number == 0 || is_free(buffer);
  }

  /// Waits until a buffer, counted from 0, may be drawn into. Other buffers may still be in flight.
  DisplayStatus acquire(int index) {
    if (const DisplayStatus status = check(index); status != DisplayStatus::ok) return status;
    Buffer& buffer = buffers_[static_cast<std::size_t>(index)];
    if (buffer.number != 0) {
      if (const DisplayStatus status = wait_until([&] { return is_free(buffer); }); status != DisplayStatus::ok)
        return status;
    }
    buffer.number = 0;
    return DisplayStatus::ok;
  }

  /// The memory of a buffer, with words in the panel's pixel order; empty if there is no such buffer. It may be drawn
  /// into only between acquire and submit.
  [[nodiscard]] std::span<std::uint16_t> buffer(int index) const {
    if (index < 0 || index >= buffer_count_) return {};
    return buffers_[static_cast<std::size_t>(index)].words;
  }

  /// Hands over rows y0 .. y1 − 1 in full width, from the start of an acquired buffer. Waits until the panel accepts
  /// them; without a queue that is when the previous band has been sent. The buffer's content is undefined afterwards.
  /// `window_out_of_range`, `buffer_too_small` and `out_of_order` do not abandon the frame; every other failure does.
  DisplayStatus submit(int y0, int y1, int index) {
    if (const DisplayStatus status = check(index); status != DisplayStatus::ok) return status;
    if (buffers_[static_cast<std::size_t>(index)].number != 0) return DisplayStatus::out_of_order;
    if (!Window{0, y0, PanelType::width, y1}.fits(PanelType::width, PanelType::height)) {
      return DisplayStatus::window_out_of_range;
    }
    const std::size_t count = static_cast<std::size_t>(y1 - y0) * PanelType::width;
    if (buffer(index).size() < count) return DisplayStatus::buffer_too_small;
    if (const DisplayStatus status = wait_until([&] { return takes(y0); }); status != DisplayStatus::ok) return status;
    if (const DisplayStatus status = panel_.write(y0, y1, buffer(index).first(count)); status != DisplayStatus::ok) {
      return give_up(status);
    }
    if (++submitted_ == 0) ++submitted_;  // 0 means that a buffer is not in flight
    buffers_[static_cast<std::size_t>(index)].number = submitted_;
    ++statistics_.bands;
    return DisplayStatus::ok;
  }

  /// Waits for the last band and ends the frame. Returns the frame's first failure, or ok.
  DisplayStatus end_frame() {
    if (!in_frame_) return failure_ == DisplayStatus::ok ? DisplayStatus::out_of_order : failure_;
    // The result is ignored because a failure is kept in failure_.
    if (failure_ == DisplayStatus::ok) static_cast<void>(wait_until([&] { return !panel_.busy(); }));
    if (failure_ == DisplayStatus::ok && is_dark_) {
      const DisplayStatus status = panel_.switch_on();
      is_dark_ = status != DisplayStatus::ok;
      if (is_dark_) static_cast<void>(give_up(status));
    }
    count_end();
    return failure_;
  }

  /// The same without waiting: the last bands are sent while the next frame begins, which then reports their failures.
  /// It does wait for the frame after which the panel is switched on.
  DisplayStatus end_frame_early() {
    if (is_dark_) return end_frame();
    if (!in_frame_) return failure_ == DisplayStatus::ok ? DisplayStatus::out_of_order : failure_;
    count_end();
    return failure_;
  }

  /// Makes the next begin_frame initialise the panel as before the first frame, for a panel that lost its power or was
  /// plugged in again, which the bus cannot notice. Bands still being sent then are abandoned.
  void restart_panel() { needs_init_ = true; }

  /// What the loop has done since it began.
  [[nodiscard]] const PresentStatistics& statistics() const { return statistics_; }

 private:
  struct Buffer {
    std::span<std::uint16_t> words;
    std::uint32_t number = 0;  ///< of its band among all submitted, while the bus may own it; otherwise 0
  };

  [[nodiscard]] DisplayStatus check(int index) const {
    if (failure_ != DisplayStatus::ok) return failure_;
    if (!in_frame_) return DisplayStatus::out_of_order;
    return index >= 0 && index < buffer_count_ ? DisplayStatus::ok : DisplayStatus::out_of_order;
  }

  /// Whether a submitted buffer has been sent.
  [[nodiscard]] bool is_free(const Buffer& buffer) { return submitted_ - buffer.number >= bands_left(); }
  /// Whether the panel accepts a band now. A panel without a queue accepts one when it is not busy.
  [[nodiscard]] bool takes(int y0) {
    if constexpr (requires { panel_.takes(y0); }) {
      return panel_.takes(y0);
    } else {
      return !panel_.busy();
    }
  }
  [[nodiscard]] std::uint32_t bands_left() {
    if constexpr (requires { panel_.bands_left(); }) {
      return panel_.bands_left();
    } else {
      return panel_.busy() ? 1 : 0;
    }
  }

  template <typename Condition>
  DisplayStatus wait_until(Condition condition) {
    if (condition()) return DisplayStatus::ok;
    const std::uint32_t start = clock_.now_us();
    bool late = false, done = false;
    while (!done && !late) {
      late = clock_.now_us() - start >= timeout_us_;
      done = condition();
    }
    wait_us_ += clock_.now_us() - start;
    return done ? DisplayStatus::ok : give_up(DisplayStatus::bus_timeout);
  }

  DisplayStatus give_up(DisplayStatus status) {
    failure_ = status;
    needs_init_ = needs_init_ || status == DisplayStatus::bus_timeout;
    return status;
  }

  void count_end() {
    in_frame_ = false;
    ++(failure_ == DisplayStatus::ok ? statistics_.frames : statistics_.frames_given_up);
    statistics_.last_frame_us = clock_.now_us() - start_us_;
    statistics_.last_wait_us = wait_us_;
  }

  PanelType& panel_;
  ClockType& clock_;
  std::array<Buffer, most_buffers> buffers_{};
  int buffer_count_ = 0;
  std::uint32_t submitted_ = 0;  ///< number of bands submitted, modulo 2^32, skipping 0
  std::uint32_t timeout_us_;
  std::uint32_t start_us_ = 0;
  std::uint32_t wait_us_ = 0;
  PresentStatistics statistics_;
  DisplayStatus failure_ = DisplayStatus::ok;
  bool in_frame_ = false;
  bool needs_init_ = true;
  bool is_dark_ = true;  ///< no picture has reached the panel since it was initialised
};

}  // namespace spanline::hal
