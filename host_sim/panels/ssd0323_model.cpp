#include "panels/ssd0323_model.hpp"

#include <algorithm>
#include <string>

namespace spanline::sim {
namespace {

constexpr std::uint8_t remap_nibbles = 0x02;   // A0h: high nibble is the left pixel
constexpr std::uint8_t remap_vertical = 0x04;  // A0h: addresses run down columns

// How the glass is wired: settings under which memory row 0, column 0 is the top left.
constexpr std::uint8_t glass_multiplex = 0x3F;
constexpr std::uint8_t glass_offset = 0x40;
constexpr std::uint8_t glass_start_line = 0;
constexpr std::uint8_t glass_remap = 0x50;  // COM split and COM remap, columns straight
constexpr std::uint8_t glass_remap_mask = 0x51;

/// Arguments of a command, or −1 for an unknown one.
int argument_count(std::uint8_t command) {
  switch (command) {
    case 0x15:
    case 0x75:
      return 2;
    case 0xB8:
      return 8;
    case 0x81:
    case 0xA0:
    case 0xA1:
    case 0xA2:
    case 0xA8:
    case 0xAD:
    case 0xB1:
    case 0xB2:
    case 0xB3:
    case 0xBC:
    case 0xBE:
    case 0xBF:
      return 1;
    case 0x84:
    case 0x85:
    case 0x86:
    case 0xA4:
    case 0xA5:
    case 0xA6:
    case 0xA7:
    case 0xAE:
    case 0xAF:
    case 0xE3:
      return 0;
    default:
      return -1;
  }
}

}  // namespace

Ssd0323Model::Ssd0323Model()
    : PanelModel({.clock = {.rated_hz = 4'000'000, .tolerated_hz = 4'000'000},
                  .reset_low_ns = 3'000,
                  .reset_settle_ns = 100'000}),
      memory_(static_cast<std::size_t>(memory_columns) * memory_rows) {
  Ssd0323Model::on_power_up();
  Ssd0323Model::on_reset();
}

// Memory is random after power-up; see MipiModel.
void Ssd0323Model::on_power_up() {
  for (std::size_t i = 0; i < memory_.size(); ++i) memory_[i] = static_cast<std::uint8_t>(i * 37);
}

// The glass shows the memory's first rows.
bool Ssd0323Model::shows_picture() const {
  const auto end = written_.begin() + static_cast<std::ptrdiff_t>(height) * memory_columns;
  return display_on_ && std::find(written_.begin(), end, false) == end;
}

void Ssd0323Model::on_reset() {
  pending_.clear();
  column_first_ = column_ = row_first_ = row_ = 0;
  column_last_ = memory_columns - 1;
  row_last_ = memory_rows - 1;
  remap_ = 0;
  multiplex_ = memory_rows - 1;
  offset_ = start_line_ = 0;
  mode_ = Mode::normal;
  display_on_ = false;
  window_full_ = false;
  written_.assign(memory_.size(), false);
}

void Ssd0323Model::on_command(std::uint8_t value) {
  if (pending_.empty() && argument_count(value) < 0) {
    complain(ComplaintKind::unknown_command, "command " + hex(value));
    return;
  }
  pending_.push_back(value);
  if (static_cast<int>(pending_.size()) <= argument_count(pending_[0])) return;
  execute();
  pending_.clear();
}

void Ssd0323Model::on_end_of_stream() {
  if (pending_.empty()) return;
  complain(ComplaintKind::wrong_argument_count, "command " + hex(pending_[0]) + " takes " +
                                                    std::to_string(argument_count(pending_[0])) + " arguments, got " +
                                                    std::to_string(pending_.size() - 1));
  pending_.clear();
}

void Ssd0323Model::execute() {
  switch (pending_[0]) {
    case 0x15:
      set_window(column_first_, column_last_, column_, memory_columns, "column");
      break;
    case 0x75:
      set_window(row_first_, row_last_, row_, memory_rows, "row");
      break;
    case 0xA0:
      remap_ = pending_[1];
      break;
    case 0xA1:
      start_line_ = pending_[1];
      break;
    case 0xA2:
      offset_ = pending_[1];
      break;
    case 0xA4:
    case 0xA5:
    case 0xA6:
    case 0xA7:
      mode_ = static_cast<Mode>(pending_[0]);
      break;
    case 0xA8:
      multiplex_ = pending_[1];
      break;
    case 0xAE:
      display_on_ = false;
      break;
    case 0xAF:
      display_on_ = true;
      if (!shows_picture()) {
        complain(ComplaintKind::shown_before_picture, "the display goes on before every pixel has been written");
      }
      break;
    default:
      break;
  }
}

void Ssd0323Model::set_window(int& first, int& last, int& pointer, int limit, const char* name) {
  if (pending_[1] > pending_[2] || pending_[2] >= limit) {
    complain(ComplaintKind::window_out_of_range, std::string(name) + "s " + std::to_string(pending_[1]) + " to " +
                                                     std::to_string(pending_[2]) + " of " + std::to_string(limit));
    return;
  }
  first = pointer = pending_[1];
  last = pending_[2];
  window_full_ = false;
}

void Ssd0323Model::on_data(std::uint8_t value) {
  on_end_of_stream();  // data ends a command that still wants arguments
  check_setup();
  if (window_full_) {
    complain(ComplaintKind::more_pixels_than_window, "pixels went on past the end of the window");
    window_full_ = false;
  }
  const std::size_t at = static_cast<std::size_t>(row_) * memory_columns + static_cast<std::size_t>(column_);
  memory_[at] = value;
  written_[at] = true;
  advance();
}

void Ssd0323Model::check_setup() {
  if (multiplex_ == glass_multiplex && offset_ == glass_offset && start_line_ == glass_start_line &&
      (remap_ & glass_remap_mask) == glass_remap) {
    return;
  }
  complain(ComplaintKind::wrong_setup, "pixels while multiplex " + hex(multiplex_) + ", offset " + hex(offset_) +
                                           ", start line " + hex(start_line_) + ", remap " + hex(remap_) +
                                           " do not suit the glass");
}

// Command description of 75h, set row address: the pointer runs through the window and starts again at its first
// corner.
void Ssd0323Model::advance() {
  const bool vertical = (remap_ & remap_vertical) != 0;
  int& inner = vertical ? row_ : column_;
  int& outer = vertical ? column_ : row_;
  if (++inner <= (vertical ? row_last_ : column_last_)) return;
  inner = vertical ? row_first_ : column_first_;
  if (++outer <= (vertical ? column_last_ : row_last_)) return;
  outer = vertical ? column_first_ : row_first_;
  window_full_ = true;
}

PanelPicture Ssd0323Model::picture() const {
  PanelPicture picture{.width = width, .height = height, .rgb = {}};
  picture.rgb.reserve(static_cast<std::size_t>(width) * height * 3);
  const bool dark = !display_on_ || mode_ == Mode::all_off;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::uint8_t pair = memory_[static_cast<std::size_t>(y) * memory_columns + static_cast<std::size_t>(x / 2)];
      const bool high = (x % 2 == 0) == ((remap_ & remap_nibbles) != 0);
      int level = high ? pair >> 4 : pair & 15;
      if (mode_ == Mode::inverse) level = 15 - level;
      if (mode_ == Mode::all_on) level = 15;
      if (dark) level = 0;
      picture.rgb.insert(picture.rgb.end(), 3, static_cast<std::uint8_t>(level * 17));
    }
  }
  return picture;
}

}  // namespace spanline::sim
