#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "panels/panel_model.hpp"
#include "spanline/hal/panel.hpp"

namespace spanline::sim {

/// What distinguishes the chips and glasses that speak the MIPI display command set. The models state these facts by
/// themselves and take none of them from the drivers, which they are there to check.
struct MipiFacts {
  struct Command {
    std::uint8_t command;
    std::uint8_t fewest;  ///< arguments
    std::uint8_t most;
  };
  std::span<const Command> commands;  ///< the write commands that the datasheet lists
  hal::ClockRating clock;
  int columns, rows;                            ///< of the memory
  int glass_column, glass_row;                  ///< where the glass lies in it
  int glass_width, glass_height;                ///< of the upright glass, pixels
  bool wired_mirrored;                          ///< memory column 0 is at the viewer's right
  bool filters_blue_first;                      ///< the glass has its colour filters in the order BGR
  bool shows_complement;                        ///< the glass shows true colours with inversion on
  std::span<const std::uint8_t> pixel_formats;  ///< of command 3Ah's low three bits, those that its serial bus knows
  std::uint8_t identity_command;
  std::span<const std::uint8_t> identity;  ///< what it answers, the empty byte included
};

/// A TFT controller with the MIPI display command set and its glass, on a 4-wire serial bus.
///
/// Modelled: reset, sleep and display on/off with their pauses, windows, memory write and continue, all eight address
/// directions, the part of the memory that the glass shows, colour order, 12, 16 and 18 bits a pixel, inversion,
/// identity, the backlight. A display that goes on before the glass has been written since the reset is complained of.
/// Gamma, voltages and frame rate are taken and have no effect. Scrolling, partial and idle mode and the
/// colour table are taken with a `not_modelled` warning.
///
/// Pauses are the ones that hold in every state: 120 ms after reset, sleep in and sleep out.
class MipiModel : public PanelModel {
 public:
  [[nodiscard]] PanelPicture picture() const override;

  /// The part of the memory that the glass does not show, where a driver with wrong offsets leaves pixels: how many of
  /// its pixels have been written.
  [[nodiscard]] std::size_t written_beside_the_glass() const;

 protected:
  /// `held`: how the viewer holds the panel; picture() is turned to match. `facts` must stay.
  MipiModel(const MipiFacts& facts, hal::Orientation held);

 private:
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
  void on_power_up() override;
  [[nodiscard]] bool shows_picture() const override;
  void on_command(std::uint8_t value) override;
  void on_data(std::uint8_t value) override;
  void on_end_of_stream() override { finish_command(); }
  std::vector<std::uint8_t> on_read(std::uint8_t command) override;

  void finish_command();
  void finish_write();
  void execute();
  void start_write(bool from_start);
  void take_pixel_byte(std::uint8_t value);
  void store_pixel(Color color);
  void set_sleep(bool asleep);
  void check_picture();
  [[nodiscard]] bool is_on_glass(std::size_t index) const;
  void set_range(Range& range, int limit, const char* name);
  [[nodiscard]] int column_limit() const;
  [[nodiscard]] int page_limit() const;
  [[nodiscard]] const MipiFacts::Command* find_command(std::uint8_t command) const;
  [[nodiscard]] std::size_t bytes_a_write() const;
  void decode_pixels();
  [[nodiscard]] std::size_t memory_index(int column, int page) const;

  const MipiFacts& facts_;
  hal::Orientation held_;
  std::vector<Color> memory_;  ///< by column and row as they are with nothing flipped
  std::vector<bool> written_;  ///< parallel: since power-up
  std::vector<bool> noise_;    ///< parallel: on the glass and not written since the last reset
  std::size_t noise_pixels_ = 0;
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
