#include "panels/mipi_model.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace spanline::sim {
namespace {

constexpr std::uint64_t ms = 1'000'000;  // nanoseconds

// The pause after reset, sleep in and sleep out: 5 ms allow some commands in some states, 120 ms all of them in any
// state.
constexpr std::uint64_t settle_ns = 120 * ms;

constexpr std::uint8_t my = 0x80;
constexpr std::uint8_t mx = 0x40;
constexpr std::uint8_t mv = 0x20;
constexpr std::uint8_t bgr = 0x08;

// Low three bits of command 3Ah.
constexpr std::uint8_t format_12_bits = 3;
constexpr std::uint8_t format_18_bits = 6;

// 4, 5 or 6 bits to 8 by repeating the high bits, so that full scale is 255.
std::uint8_t expand_4(unsigned value) { return static_cast<std::uint8_t>(value << 4 | value); }
std::uint8_t expand_5(unsigned value) { return static_cast<std::uint8_t>(value << 3 | value >> 2); }
std::uint8_t expand_6(unsigned value) { return static_cast<std::uint8_t>(value << 2 | value >> 4); }

bool is_landscape(hal::Orientation orientation) {
  return orientation == hal::Orientation::landscape || orientation == hal::Orientation::landscape_flipped;
}

}  // namespace

MipiModel::MipiModel(const MipiFacts& facts, hal::Orientation held)
    : PanelModel({.clock = facts.clock, .reset_low_ns = 10'000, .reset_settle_ns = settle_ns}),
      facts_(facts),
      held_(held),
      memory_(static_cast<std::size_t>(facts.columns) * static_cast<std::size_t>(facts.rows)) {
  MipiModel::on_power_up();
  MipiModel::on_reset();
}

void MipiModel::on_power_up() {
  // Memory is random after power-up: a pattern that no picture has shows what a driver leaves unwritten.
  for (std::size_t i = 0; i < memory_.size(); ++i) memory_[i] = {static_cast<std::uint8_t>(i * 37), 0x5A, 0xA5};
  written_.assign(memory_.size(), false);
}

bool MipiModel::is_on_glass(std::size_t index) const {
  const int column = static_cast<int>(index) % facts_.columns - facts_.glass_column;
  const int row = static_cast<int>(index) / facts_.columns - facts_.glass_row;
  return column >= 0 && column < facts_.glass_width && row >= 0 && row < facts_.glass_height;
}

bool MipiModel::shows_picture() const { return display_on_ && !asleep_ && noise_pixels_ == 0; }

void MipiModel::check_picture() {
  if (noise_pixels_ == 0) return;
  complain(ComplaintKind::shown_before_picture, "the display goes on while " + std::to_string(noise_pixels_) +
                                                    " pixels have not been written since the reset");
}

const MipiFacts::Command* MipiModel::find_command(std::uint8_t command) const {
  const auto found = std::find_if(facts_.commands.begin(), facts_.commands.end(),
                                  [command](const MipiFacts::Command& facts) { return facts.command == command; });
  return found == facts_.commands.end() ? nullptr : &*found;
}

std::vector<std::uint8_t> MipiModel::on_read(std::uint8_t command) {
  finish_command();
  if (command == facts_.identity_command) return {facts_.identity.begin(), facts_.identity.end()};
  complain(ComplaintKind::not_modelled, "reading " + hex(command));
  return {};
}

void MipiModel::on_reset() {
  column_range_ = {0, facts_.columns - 1};
  page_range_ = {0, facts_.rows - 1};
  memory_access_ = 0;
  pixel_format_ = format_18_bits;
  asleep_ = true;
  display_on_ = false;
  inverted_ = false;
  state_ = State::idle;
  arguments_.clear();
  noise_.resize(memory_.size());
  for (std::size_t i = 0; i < memory_.size(); ++i) noise_[i] = is_on_glass(i);
  noise_pixels_ = static_cast<std::size_t>(std::count(noise_.begin(), noise_.end(), true));
}

void MipiModel::on_command(std::uint8_t value) {
  finish_command();
  command_ = value;
  arguments_.clear();
  const MipiFacts::Command* facts = find_command(value);
  if (facts == nullptr) {
    complain(ComplaintKind::unknown_command, "command " + hex(value));
    state_ = State::ignored;
    return;
  }
  state_ = State::arguments;
  if (facts->most == 0) execute();
}

void MipiModel::on_data(std::uint8_t value) {
  switch (state_) {
    case State::idle:
      complain(ComplaintKind::data_without_command, "data " + hex(value) + " without a command");
      return;
    case State::ignored:
      return;
    case State::pixels:
      take_pixel_byte(value);
      return;
    case State::arguments:
      break;
  }
  const MipiFacts::Command* facts = find_command(command_);
  if (arguments_.size() == facts->most) {
    complain(ComplaintKind::wrong_argument_count,
             "command " + hex(command_) + " takes " + std::to_string(facts->most) + " arguments, more were sent");
    state_ = State::ignored;
    return;
  }
  arguments_.push_back(value);
  if (arguments_.size() == facts->most) execute();
}

// The chip keeps complete arguments of an interrupted command; this model drops the command.
void MipiModel::finish_command() {
  if (state_ == State::pixels) finish_write();
  if (state_ == State::arguments) {
    const MipiFacts::Command* facts = find_command(command_);
    if (arguments_.size() < facts->fewest) {
      complain(ComplaintKind::wrong_argument_count, "command " + hex(command_) + " takes " +
                                                        std::to_string(facts->fewest) + " arguments, got " +
                                                        std::to_string(arguments_.size()));
    }
  }
  state_ = State::idle;
}

void MipiModel::finish_write() {
  if (pixel_fill_ != 0) {
    complain(ComplaintKind::partial_pixel,
             "a memory write ended with " + std::to_string(pixel_fill_) + " bytes of a pixel");
  }
  pixel_fill_ = 0;
}

void MipiModel::execute() {
  switch (command_) {
    case 0x01:
      mark_reset();
      on_reset();
      require_pause(settle_ns, "software reset");
      break;
    case 0x10:
      set_sleep(true);
      break;
    case 0x11:
      set_sleep(false);
      break;
    case 0x20:
      inverted_ = false;
      break;
    case 0x21:
      inverted_ = true;
      break;
    case 0x28:
      display_on_ = false;
      break;
    case 0x29:
      display_on_ = true;
      check_picture();
      break;
    case 0x2A:
      set_range(column_range_, column_limit(), "column");
      break;
    case 0x2B:
      set_range(page_range_, page_limit(), "page");
      break;
    case 0x2C:
      start_write(true);
      break;
    case 0x3C:
      start_write(false);
      break;
    case 0x36:
      memory_access_ = arguments_[0];
      break;
    case 0x3A:
      pixel_format_ = arguments_[0] & 7;
      if (std::find(facts_.pixel_formats.begin(), facts_.pixel_formats.end(), pixel_format_) ==
          facts_.pixel_formats.end()) {
        complain(ComplaintKind::wrong_setup, "pixel format " + hex(arguments_[0]));
      }
      break;
    case 0x12:
    case 0x2D:
    case 0x33:
    case 0x39:
      complain(ComplaintKind::not_modelled, "command " + hex(command_));
      break;
    case 0x37:
      if (arguments_[0] != 0 || arguments_[1] != 0) complain(ComplaintKind::not_modelled, "scrolling (0x37)");
      break;
    default:
      break;
  }
}

void MipiModel::set_sleep(bool asleep) {
  asleep_ = asleep;
  require_pause(settle_ns, asleep ? "sleep in" : "sleep out");
}

// With MV set, the host's columns run along the memory's rows.
int MipiModel::column_limit() const { return (memory_access_ & mv) != 0 ? facts_.rows : facts_.columns; }
int MipiModel::page_limit() const { return (memory_access_ & mv) != 0 ? facts_.columns : facts_.rows; }

void MipiModel::set_range(Range& range, int limit, const char* name) {
  const Range wanted{arguments_[0] << 8 | arguments_[1], arguments_[2] << 8 | arguments_[3]};
  if (wanted.first > wanted.last || wanted.last >= limit) {
    complain(ComplaintKind::window_out_of_range, std::string(name) + "s " + std::to_string(wanted.first) + " to " +
                                                     std::to_string(wanted.last) + " of " + std::to_string(limit));
    return;
  }
  range = wanted;
}

void MipiModel::start_write(bool from_start) {
  if (asleep_) complain(ComplaintKind::write_during_sleep, "memory write " + hex(command_) + " in sleep mode");
  // A change of direction after the window was set can leave it outside.
  if (column_range_.last >= column_limit() || page_range_.last >= page_limit()) {
    complain(ComplaintKind::window_out_of_range, "the window does not fit the address direction");
    state_ = State::ignored;
    return;
  }
  state_ = State::pixels;
  pixel_fill_ = 0;
  if (from_start) {
    window_full_ = false;
    column_ = column_range_.first;
    page_ = page_range_.first;
  }
}

// 12 bits a pixel come in pairs of three bytes.
std::size_t MipiModel::bytes_a_write() const {
  return pixel_format_ == format_18_bits || pixel_format_ == format_12_bits ? 3 : 2;
}

void MipiModel::take_pixel_byte(std::uint8_t value) {
  pixel_bytes_[pixel_fill_++] = value;
  if (pixel_fill_ < bytes_a_write()) return;
  pixel_fill_ = 0;
  decode_pixels();
}

void MipiModel::decode_pixels() {
  const unsigned first = pixel_bytes_[0], second = pixel_bytes_[1], third = pixel_bytes_[2];
  if (pixel_format_ == format_18_bits) {
    store_pixel({expand_6(first >> 2), expand_6(second >> 2), expand_6(third >> 2)});
  } else if (pixel_format_ == format_12_bits) {
    store_pixel({expand_4(first >> 4), expand_4(first & 15), expand_4(second >> 4)});
    store_pixel({expand_4(second & 15), expand_4(third >> 4), expand_4(third & 15)});
  } else {
    const unsigned word = first << 8 | second;
    store_pixel({expand_5(word >> 11), expand_6(word >> 5 & 63), expand_5(word & 31)});
  }
}

void MipiModel::store_pixel(Color color) {
  if (window_full_) {
    complain(ComplaintKind::more_pixels_than_window, "a memory write went on past the end of its window");
    window_full_ = false;
  }
  if (((memory_access_ & bgr) != 0) != facts_.filters_blue_first) std::swap(color.red, color.blue);
  const std::size_t at = memory_index(column_, page_);
  memory_[at] = color;
  written_[at] = true;
  if (noise_[at]) --noise_pixels_;
  noise_[at] = false;
  if (++column_ <= column_range_.last) return;
  column_ = column_range_.first;
  if (++page_ <= page_range_.last) return;
  page_ = page_range_.first;
  window_full_ = true;
}

// Host address to memory: exchange first, then count from the other end.
std::size_t MipiModel::memory_index(int column, int page) const {
  if ((memory_access_ & mv) != 0) std::swap(column, page);
  if ((memory_access_ & mx) != 0) column = facts_.columns - 1 - column;
  if ((memory_access_ & my) != 0) page = facts_.rows - 1 - page;
  return static_cast<std::size_t>(page) * static_cast<std::size_t>(facts_.columns) + static_cast<std::size_t>(column);
}

std::size_t MipiModel::written_beside_the_glass() const {
  std::size_t count = 0;
  for (std::size_t i = 0; i < written_.size(); ++i) {
    if (written_[i] && !is_on_glass(i)) ++count;
  }
  return count;
}

PanelPicture MipiModel::picture() const {
  const int glass_width = facts_.glass_width, glass_height = facts_.glass_height;
  const bool landscape = is_landscape(held_);
  const bool flipped = held_ == hal::Orientation::portrait_flipped || held_ == hal::Orientation::landscape_flipped;
  PanelPicture picture{
      .width = landscape ? glass_height : glass_width, .height = landscape ? glass_width : glass_height, .rgb = {}};
  picture.rgb.reserve(static_cast<std::size_t>(glass_width) * static_cast<std::size_t>(glass_height) * 3);
  const bool dark = asleep_ || !display_on_ || !is_lit();
  for (int v = 0; v < picture.height; ++v) {
    for (int u = 0; u < picture.width; ++u) {
      // The viewer's (u, v) on the upright glass: a quarter turn for landscape, a half turn where flipped.
      int x = landscape ? glass_width - 1 - v : u;
      int y = landscape ? u : v;
      if (flipped) {
        x = glass_width - 1 - x;
        y = glass_height - 1 - y;
      }
      if (facts_.wired_mirrored) x = glass_width - 1 - x;
      const auto column = static_cast<std::size_t>(facts_.glass_column + x);
      const auto row = static_cast<std::size_t>(facts_.glass_row + y);
      Color color = memory_[row * static_cast<std::size_t>(facts_.columns) + column];
      if (inverted_ != facts_.shows_complement)
        color = {static_cast<std::uint8_t>(~color.red), static_cast<std::uint8_t>(~color.green),
                 static_cast<std::uint8_t>(~color.blue)};
      if (dark) color = {};
      picture.rgb.insert(picture.rgb.end(), {color.red, color.green, color.blue});
    }
  }
  return picture;
}

}  // namespace spanline::sim
