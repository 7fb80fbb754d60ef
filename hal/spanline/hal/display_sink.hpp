#pragma once
/// @file
/// A renderer on a display.
///
/// ```cpp
/// #include <spanline/hal/panels/st7789.hpp>
///
/// template <hal::Bus Bus, hal::Clock Clock, class Picture>
/// hal::DisplayStatus show_once(Bus& bus, Clock& clock, Picture& renderer) {
///   hal::St7789<hal::st7789::glass_240x240, Bus, Clock> panel(bus, clock);
///   hal::DisplaySink display(panel, clock, renderer);
///   return display.show([&](auto& sink) { return renderer.draw(sink); }).display;
/// }
/// ```
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "spanline/hal/clock.hpp"
#include "spanline/hal/display_status.hpp"
#include "spanline/hal/filler.hpp"
#include "spanline/hal/panel.hpp"
#include "spanline/hal/present.hpp"

namespace spanline::hal {

/// The result of a frame: the status of the display and that of the drawing.
template <class Drawing>
struct ShownFrame {
  DisplayStatus display = DisplayStatus::ok;  ///< the first failure of the frame, or ok
  Drawing drawing{};                          ///< default value if the frame did not begin
};

/// Connects a renderer to a present loop. Its buffers are the renderer's colour bands, so finished bands go to the
/// panel without a copy while the next ones are drawn. With a Filler, the renderer uses it to clear bands ahead.
///
/// It works with any renderer whose `colour_band(i)` is a span of 16-bit words for i = 0, 1, … and empty after the
/// last, and whose bands have `y0`, `y1`, `pixels` and `buffer`. The picture must have the panel's size, and its words
/// the panel's pixel order.
///
/// `show(draw)` presents a whole frame: `draw(sink)` draws it, and its result is returned with the display's status.
template <Panel PanelType, Clock ClockType, class FillerType = NoFiller>
class DisplaySink {
 public:
  /// The loop that sends the bands.
  using Present = hal::Present<PanelType, ClockType>;

  /// All arguments stay with the caller and must outlive the sink. `timeout_us` limits each wait for the bus,
  /// microseconds.
  template <class RendererType>
  DisplaySink(PanelType& panel, ClockType& clock, const RendererType& renderer,
              std::uint32_t timeout_us = Present::default_timeout_us)
      : present_(panel, clock, buffers_of(renderer), timeout_us) {}

  /// Draws a frame and waits until the panel shows it.
  template <class Draw>
  auto show(Draw&& draw) {
    return show(draw, [this] { return present_.end_frame(); });
  }
  /// The same without waiting: the next frame may begin while the last bands are still being sent.
  template <class Draw>
  auto show_and_go_on(Draw&& draw) {
    return show(draw, [this] { return present_.end_frame_early(); });
  }

  /// For statistics and restart_panel(), and for programs with a frame loop of their own.
  [[nodiscard]] Present& present() { return present_; }
  /// For statistics.
  [[nodiscard]] const Present& present() const { return present_; }

  // What the renderer asks of a sink.

  /// Waits until the colour band `buffer`, counted from 0, may be drawn into; false where the frame is given up.
  bool acquire(unsigned buffer) { return good(present_.acquire(static_cast<int>(buffer))); }
  /// Whether acquire() would return at once.
  bool available(unsigned buffer) { return present_.available(static_cast<int>(buffer)); }
  /// Starts to fill `count` words; see Filler.
  void fill([[maybe_unused]] std::uint16_t value, [[maybe_unused]] std::uint32_t count,
            [[maybe_unused]] std::uint16_t* words) requires Filler<FillerType> {
    // clang instantiates the body with the class, whatever the constraint says.
    if constexpr (Filler<FillerType>) filler_.fill(value, count, words);
  }
  /// Waits until all of it has ended; false where it does not.
  bool filled() requires Filler<FillerType> {
    if constexpr (Filler<FillerType>)
      return filler_.filled();
    else
      return true;
  }
  /// Hands a finished band to the panel; false where the frame is given up. A band that is not as wide as the panel is
  /// `window_out_of_range`.
  template <class Band>
  bool operator()(const Band& band) {
    const auto words = static_cast<std::size_t>(band.y1 - band.y0) * PanelType::width;
    if (band.pixels.size() != words) return good(DisplayStatus::window_out_of_range);
    return good(present_.submit(band.y0, band.y1, static_cast<int>(band.buffer)));
  }

 private:
  template <class RendererType>
  static auto buffers_of(const RendererType& renderer) {
    std::array<std::span<std::uint16_t>, Present::most_buffers> all{};
    for (unsigned i = 0; i < all.size(); ++i) all[i] = renderer.colour_band(i);
    return all;
  }

  template <class Draw, class End>
  auto show(Draw& draw, End end) {
    ShownFrame<decltype(draw(*this))> frame;
    first_failure_ = DisplayStatus::ok;
    frame.display = present_.begin_frame();
    if (frame.display != DisplayStatus::ok) return frame;
    frame.drawing = draw(*this);
    const DisplayStatus ended = end();
    frame.display = ended == DisplayStatus::ok ? first_failure_ : ended;
    return frame;
  }

  /// Keeps a frame's first failure, including those that do not abandon the present loop's frame.
  bool good(DisplayStatus status) {
    if (first_failure_ == DisplayStatus::ok) first_failure_ = status;
    return status == DisplayStatus::ok;
  }

  Present present_;
  [[no_unique_address]] FillerType filler_{};
  DisplayStatus first_failure_ = DisplayStatus::ok;
};

}  // namespace spanline::hal
