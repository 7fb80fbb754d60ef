#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "panels/panel_model.hpp"
#include "spanline/hal/panel.hpp"

namespace spanline::sim {

/// An ILI9341 with its 240 × 320 glass, on a 4-wire serial bus (datasheet sections in the source).
///
/// Modelled: reset, sleep and display on/off with their pauses, windows, memory write and continue, all eight address
/// directions, colour order, 16 and 18 bits a pixel, inversion. Gamma, voltages and frame rate are taken and have no
/// effect. Scrolling, partial and idle mode and the colour table are taken with a `not_modelled` warning.
///
/// Pauses are the ones that hold in every state: 120 ms after reset, sleep in and sleep out.
class Ili9341Model : public PanelModel {
 public:
  /// `held`: how the viewer holds the panel; picture() is turned to match.
  explicit Ili9341Model(hal::Orientation held);

  [[nodiscard]] PanelPicture picture() const override;

 private:
  static constexpr int columns = 240;
  static constexpr int pages = 320;
  struct Range {
    int first = 0;
    int last = 0;
  };
  struct Color {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;
  };
  enum class State : std::uint8_t { idle, arguments, pixels, ignored };

  void on_reset() override;
  void on_command(std::uint8_t value) override;
  void on_data(std::uint8_t value) override;
  void on_end_of_stream() override { finish_command(); }

  void finish_command();
  void finish_write();
  void execute();
  void start_write(bool from_start);
  void take_pixel_byte(std::uint8_t value);
  void store_pixel();
  void set_sleep(bool asleep);
  void set_range(Range& range, int limit, const char* name);
  [[nodiscard]] int column_limit() const;
  [[nodiscard]] int page_limit() const;
  [[nodiscard]] Color decode_pixel() const;
  [[nodiscard]] std::size_t memory_index(int column, int page) const;

  hal::Orientation held_;
  std::vector<Color> memory_;  ///< as the glass shows it: 240 a row, 320 rows, upright portrait
  Range column_range_;
  Range page_range_;
  int column_ = 0;  ///< where the next pixel goes, in the host's address order
  int page_ = 0;
  std::uint8_t memory_access_ = 0;
  std::uint8_t pixel_format_ = 0;
  bool asleep_ = true;
  bool display_on_ = false;
  bool inverted_ = false;

  State state_ = State::idle;
  std::uint8_t command_ = 0;
  std::vector<std::uint8_t> arguments_;
  std::array<std::uint8_t, 3> pixel_bytes_{};
  std::size_t pixel_fill_ = 0;
  bool window_full_ = false;
};

}  // namespace spanline::sim
