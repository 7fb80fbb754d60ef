#include "panels/ili9341_model.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace spanline::sim {
namespace {

constexpr std::uint64_t ms = 1'000'000;  // nanoseconds

// The pause after reset, sleep in and sleep out (sections 8.2.2, 8.2.11, 8.2.12; reset timing): 5 ms allow some
// commands in some states, 120 ms all of them in any state.
constexpr std::uint64_t settle_ns = 120 * ms;

constexpr std::uint8_t my = 0x80;
constexpr std::uint8_t mx = 0x40;
constexpr std::uint8_t mv = 0x20;
constexpr std::uint8_t bgr = 0x08;

constexpr std::uint8_t format_16_bits = 5;  // low three bits of 3Ah, section 8.2.33
constexpr std::uint8_t format_18_bits = 6;

struct CommandFacts {
  std::uint8_t command;
  std::uint8_t fewest;  // arguments
  std::uint8_t most;
};

// The write commands of section 8.1. B6h has an optional fourth argument. Commands that read are not here: nothing
// listens on this bus.
constexpr CommandFacts command_facts[] = {
    {0x00, 0, 0},     {0x01, 0, 0}, {0x10, 0, 0},   {0x11, 0, 0},   {0x12, 0, 0}, {0x13, 0, 0}, {0x20, 0, 0},
    {0x21, 0, 0},     {0x26, 1, 1}, {0x28, 0, 0},   {0x29, 0, 0},   {0x2A, 4, 4}, {0x2B, 4, 4}, {0x2C, 0, 0},
    {0x2D, 128, 128}, {0x30, 4, 4}, {0x33, 6, 6},   {0x34, 0, 0},   {0x35, 1, 1}, {0x36, 1, 1}, {0x37, 2, 2},
    {0x38, 0, 0},     {0x39, 0, 0}, {0x3A, 1, 1},   {0x3C, 0, 0},   {0x44, 2, 2}, {0x51, 1, 1}, {0x53, 1, 1},
    {0x55, 1, 1},     {0x5E, 1, 1}, {0xB0, 1, 1},   {0xB1, 2, 2},   {0xB2, 2, 2}, {0xB3, 2, 2}, {0xB4, 1, 1},
    {0xB5, 4, 4},     {0xB6, 3, 4}, {0xB7, 1, 1},   {0xC0, 1, 1},   {0xC1, 1, 1}, {0xC5, 2, 2}, {0xC7, 1, 1},
    {0xCB, 5, 5},     {0xCF, 3, 3}, {0xE0, 15, 15}, {0xE1, 15, 15}, {0xE8, 3, 3}, {0xEA, 2, 2}, {0xED, 4, 4},
    {0xF2, 1, 1},     {0xF6, 3, 3}, {0xF7, 1, 1},
};

const CommandFacts* find_command(std::uint8_t command) {
  const auto* found = std::find_if(std::begin(command_facts), std::end(command_facts),
                                   [command](const CommandFacts& facts) { return facts.command == command; });
  return found == std::end(command_facts) ? nullptr : found;
}

// 5 or 6 bits to 8 by repeating the high bits, so that full scale is 255.
std::uint8_t expand_5(unsigned value) { return static_cast<std::uint8_t>(value << 3 | value >> 2); }
std::uint8_t expand_6(unsigned value) { return static_cast<std::uint8_t>(value << 2 | value >> 4); }

bool is_landscape(hal::Orientation orientation) {
  return orientation == hal::Orientation::landscape || orientation == hal::Orientation::landscape_flipped;
}

}  // namespace

Ili9341Model::Ili9341Model(hal::Orientation held)
    : PanelModel({.clock = {.rated_hz = 10'000'000, .tolerated_hz = 40'000'000},
                  .reset_low_ns = 10'000,
                  .reset_settle_ns = settle_ns}),
      held_(held),
      memory_(static_cast<std::size_t>(columns) * pages) {
  // Memory is random after power-up: a pattern that no picture has shows what a driver leaves unwritten.
  for (std::size_t i = 0; i < memory_.size(); ++i) memory_[i] = {static_cast<std::uint8_t>(i * 37), 0x5A, 0xA5};
  on_reset();
}

void Ili9341Model::on_reset() {
  column_range_ = {0, columns - 1};
  page_range_ = {0, pages - 1};
  memory_access_ = 0;
  pixel_format_ = format_18_bits;
  asleep_ = true;
  display_on_ = false;
  inverted_ = false;
  state_ = State::idle;
  arguments_.clear();
}

void Ili9341Model::on_command(std::uint8_t value) {
  finish_command();
  command_ = value;
  arguments_.clear();
  const CommandFacts* facts = find_command(value);
  if (facts == nullptr) {
    complain(ComplaintKind::unknown_command, "command " + hex(value));
    state_ = State::ignored;
    return;
  }
  state_ = State::arguments;
  if (facts->most == 0) execute();
}

void Ili9341Model::on_data(std::uint8_t value) {
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
  const CommandFacts* facts = find_command(command_);
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
void Ili9341Model::finish_command() {
  if (state_ == State::pixels) finish_write();
  if (state_ == State::arguments) {
    const CommandFacts* facts = find_command(command_);
    if (arguments_.size() < facts->fewest) {
      complain(ComplaintKind::wrong_argument_count, "command " + hex(command_) + " takes " +
                                                        std::to_string(facts->fewest) + " arguments, got " +
                                                        std::to_string(arguments_.size()));
    }
  }
  state_ = State::idle;
}

void Ili9341Model::finish_write() {
  if (pixel_fill_ != 0) {
    complain(ComplaintKind::partial_pixel,
             "a memory write ended with " + std::to_string(pixel_fill_) + " bytes of a pixel");
  }
  pixel_fill_ = 0;
}

void Ili9341Model::execute() {
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
      if (pixel_format_ != format_16_bits && pixel_format_ != format_18_bits) {
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

void Ili9341Model::set_sleep(bool asleep) {
  asleep_ = asleep;
  require_pause(settle_ns, asleep ? "sleep in" : "sleep out");
}

// With MV set, the host's columns run along the glass's 320 pages (section 9.3).
int Ili9341Model::column_limit() const { return (memory_access_ & mv) != 0 ? pages : columns; }
int Ili9341Model::page_limit() const { return (memory_access_ & mv) != 0 ? columns : pages; }

void Ili9341Model::set_range(Range& range, int limit, const char* name) {
  const Range wanted{arguments_[0] << 8 | arguments_[1], arguments_[2] << 8 | arguments_[3]};
  if (wanted.first > wanted.last || wanted.last >= limit) {
    complain(ComplaintKind::window_out_of_range, std::string(name) + "s " + std::to_string(wanted.first) + " to " +
                                                     std::to_string(wanted.last) + " of " + std::to_string(limit));
    return;
  }
  range = wanted;
}

void Ili9341Model::start_write(bool from_start) {
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

void Ili9341Model::take_pixel_byte(std::uint8_t value) {
  pixel_bytes_[pixel_fill_++] = value;
  if (pixel_fill_ < (pixel_format_ == format_18_bits ? 3U : 2U)) return;
  pixel_fill_ = 0;
  store_pixel();
}

void Ili9341Model::store_pixel() {
  if (window_full_) {
    complain(ComplaintKind::more_pixels_than_window, "a memory write went on past the end of its window");
    window_full_ = false;
  }
  memory_[memory_index(column_, page_)] = decode_pixel();
  if (++column_ <= column_range_.last) return;
  column_ = column_range_.first;
  if (++page_ <= page_range_.last) return;
  page_ = page_range_.first;
  window_full_ = true;
}

Ili9341Model::Color Ili9341Model::decode_pixel() const {
  Color color;
  if (pixel_format_ == format_18_bits) {
    color = {expand_6(pixel_bytes_[0] >> 2), expand_6(pixel_bytes_[1] >> 2), expand_6(pixel_bytes_[2] >> 2)};
  } else {
    const unsigned word = static_cast<unsigned>(pixel_bytes_[0]) << 8 | pixel_bytes_[1];
    color = {expand_5(word >> 11), expand_6(word >> 5 & 63), expand_5(word & 31)};
  }
  if ((memory_access_ & bgr) == 0) std::swap(color.red, color.blue);  // this glass has its filters in the order BGR
  return color;
}

// Host address to glass (section 9.3): exchange first, then count from the other end. The glass is wired mirrored:
// memory column 0 is at the viewer's right.
std::size_t Ili9341Model::memory_index(int column, int page) const {
  if ((memory_access_ & mv) != 0) std::swap(column, page);
  if ((memory_access_ & mx) != 0) column = columns - 1 - column;
  if ((memory_access_ & my) != 0) page = pages - 1 - page;
  const int x = columns - 1 - column;
  return static_cast<std::size_t>(page) * columns + static_cast<std::size_t>(x);
}

PanelPicture Ili9341Model::picture() const {
  const bool landscape = is_landscape(held_);
  const bool flipped = held_ == hal::Orientation::portrait_flipped || held_ == hal::Orientation::landscape_flipped;
  PanelPicture picture{.width = landscape ? pages : columns, .height = landscape ? columns : pages, .rgb = {}};
  picture.rgb.reserve(memory_.size() * 3);
  const bool dark = asleep_ || !display_on_;
  for (int v = 0; v < picture.height; ++v) {
    for (int u = 0; u < picture.width; ++u) {
      // The viewer's (u, v) on the upright glass: a quarter turn for landscape, a half turn where flipped.
      int x = landscape ? columns - 1 - v : u;
      int y = landscape ? u : v;
      if (flipped) {
        x = columns - 1 - x;
        y = pages - 1 - y;
      }
      Color color = memory_[static_cast<std::size_t>(y) * columns + static_cast<std::size_t>(x)];
      if (inverted_)
        color = {static_cast<std::uint8_t>(~color.red), static_cast<std::uint8_t>(~color.green),
                 static_cast<std::uint8_t>(~color.blue)};
      if (dark) color = {};
      picture.rgb.insert(picture.rgb.end(), {color.red, color.green, color.blue});
    }
  }
  return picture;
}

}  // namespace spanline::sim
