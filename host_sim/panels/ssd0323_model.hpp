#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "panels/panel_model.hpp"

namespace spanline::sim {

/// An SSD0323 with the OSRAM Pictiva 128 × 64 glass, on a 4-wire serial bus (by the datasheet of the SSD1325).
/// Arguments come with D/C low, like commands.
///
/// Modelled: windows over the 64 × 80 byte memory, both address directions, nibble order, display on/off, all on, all
/// off, inverse; grey level n shows as n × 17. Currents, voltages and timing registers are taken and have no effect.
/// The glass is wired for one setting of multiplex ratio, offset, start line, column and COM mapping: pixels under
/// another one are complained of (`wrong_setup`). Memory takes writes while the display is off. The model knows the
/// commands that QEMU's model of the chip knows; the graphic acceleration commands are unknown to both.
class Ssd0323Model : public PanelModel {
 public:
  static constexpr int width = 128;
  static constexpr int height = 64;

  Ssd0323Model();

  [[nodiscard]] PanelPicture picture() const override;

 private:
  static constexpr int memory_columns = 64;
  static constexpr int memory_rows = 80;
  enum class Mode : std::uint8_t { normal = 0xA4, all_on = 0xA5, all_off = 0xA6, inverse = 0xA7 };

  void on_reset() override;
  void on_power_up() override;
  [[nodiscard]] bool shows_picture() const override;
  void on_command(std::uint8_t value) override;
  void on_data(std::uint8_t value) override;
  void on_end_of_stream() override;

  void execute();
  void set_window(int& first, int& last, int& pointer, int limit, const char* name);
  void check_setup();
  void advance();

  std::vector<std::uint8_t> memory_;
  std::vector<bool> written_;          ///< parallel: since the last reset
  std::vector<std::uint8_t> pending_;  ///< a command that still wants arguments; empty when none
  int column_first_ = 0;
  int column_last_ = 0;
  int row_first_ = 0;
  int row_last_ = 0;
  int column_ = 0;
  int row_ = 0;
  std::uint8_t remap_ = 0;
  std::uint8_t multiplex_ = 0;
  std::uint8_t offset_ = 0;
  std::uint8_t start_line_ = 0;
  Mode mode_ = Mode::normal;
  bool display_on_ = false;
  bool window_full_ = false;
};

}  // namespace spanline::sim
