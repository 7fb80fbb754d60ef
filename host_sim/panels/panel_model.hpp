#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "panels/complaint.hpp"
#include "spanline/hal/clock_rating.hpp"

namespace spanline::sim {

/// What the viewer sees on a panel: RGB888, three bytes a pixel, row by row from the top left.
struct PanelPicture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;  ///< width × height × 3 bytes

  /// The first of the three bytes of pixel (x, y).
  [[nodiscard]] const std::uint8_t* at(int x, int y) const {
    return rgb.data() +
           (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) * 3;
  }
};

/// A display panel at the far end of the wires: takes what a driver sends, byte by byte with the level of D/C, and
/// decodes it into a picture. It complains of whatever a datasheet forbids, and then goes on as the chip probably
/// would.
class PanelModel {
 public:
  virtual ~PanelModel() = default;

  /// The reset line: `low` holds the panel in reset. Power-up leaves it high, without a reset.
  void reset_line(bool low, std::uint64_t now_ns);

  /// The line that switches the backlight. A module whose line nobody drives is always lit, and nothing is said of it.
  void backlight_line(bool lit, std::uint64_t now_ns);

  /// The panel's supply fails and comes back: memory is noise, registers are unknown, and the panel sleeps.
  void lose_power(std::uint64_t now_ns);

  /// One byte; `data` is the level of D/C during it.
  void byte(bool data, std::uint8_t value, std::uint64_t now_ns);

  /// A command that asks: what the panel answers, from its first empty byte on.
  std::vector<std::uint8_t> read(std::uint8_t command, std::uint64_t now_ns);

  /// The serial clock that the bytes come with, hertz.
  void set_clock(std::uint32_t clock_hz, std::uint64_t now_ns);

  /// Says that the stream pauses here for good: a command that still wants arguments is complained of.
  void end_of_stream() { on_end_of_stream(); }

  /// What the viewer sees now; black while the display is off or asleep.
  [[nodiscard]] virtual PanelPicture picture() const = 0;

  /// One entry a kind, in order of first appearance.
  [[nodiscard]] const std::vector<Complaint>& complaints() const { return complaints_; }
  void clear_complaints() { complaints_.clear(); }

  /// Raises a complaint; the bus in front of the panel does so too.
  void complain(ComplaintKind kind, std::string text, std::uint64_t now_ns);

 protected:
  /// What the common part checks by itself.
  struct Limits {
    hal::ClockRating clock;
    std::uint64_t reset_low_ns;     ///< shortest reset pulse
    std::uint64_t reset_settle_ns;  ///< pause between the end of reset and the first command
  };

  explicit PanelModel(const Limits& limits) : limits_(limits) {}

  virtual void on_reset() = 0;
  /// Fills the memory with noise.
  virtual void on_power_up() = 0;
  /// Whether the viewer sees the memory, light or not, and every pixel of it has been written since the last reset.
  [[nodiscard]] virtual bool shows_picture() const = 0;
  virtual void on_command(std::uint8_t value) = 0;
  virtual void on_data(std::uint8_t value) = 0;
  virtual void on_end_of_stream() = 0;
  /// Panels that nobody reads from leave this.
  virtual std::vector<std::uint8_t> on_read(std::uint8_t) { return {}; }

  /// Raises a complaint at the time of the byte that is being decoded.
  void complain(ComplaintKind kind, std::string text) { complain(kind, std::move(text), now_ns_); }

  /// Whether the backlight is on, or is not switched at all.
  [[nodiscard]] bool is_lit() const { return lit_; }

  /// Time of the byte that is being decoded, nanoseconds.
  [[nodiscard]] std::uint64_t now_ns() const { return now_ns_; }

  /// No command may come within `ns` from now; `after` names what asks for the pause. A longer pause under way stays.
  void require_pause(std::uint64_t ns, std::string after);

  /// For panels with a reset command: it does what the line does.
  void mark_reset();

 private:
  void complain_of_light(const char* what);

  Limits limits_;
  std::vector<Complaint> complaints_;
  std::uint64_t now_ns_ = 0;
  std::uint64_t reset_start_ns_ = 0;
  std::uint64_t pause_until_ns_ = 0;
  std::string pause_after_;
  bool reset_low_ = false;
  bool was_reset_ = false;
  bool backlight_is_switched_ = false;
  bool lit_ = true;
};

/// "0x2A" for complaints.
[[nodiscard]] std::string hex(std::uint8_t value);

}  // namespace spanline::sim
