#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "panels/complaint.hpp"
#include "panels/panel_model.hpp"
#include "spanline/hal/display_status.hpp"
#include "spanline/hal/panel.hpp"
#include "spanline/hal/pixel_order.hpp"
#include "spanline/hal/present.hpp"

namespace spanline::sim {

/// A panel that the host can drive, as `spanline list` shows it.
struct PanelInfo {
  std::string_view name;         ///< for --panel
  std::string_view panel_class;  ///< size and colours, "320x240 rgb565"
  std::string_view description;
  int width;                    ///< picture, pixels
  int height;                   ///< picture, pixels
  hal::PixelOrder pixel_order;  ///< how the driver wants a band's words
  hal::ClockRating clock_rating;
};

/// All panels, in the order in which they are listed.
[[nodiscard]] std::span<const PanelInfo> panels();

/// The panel of that name, or nullptr.
[[nodiscard]] const PanelInfo* find_panel(std::string_view name);

/// Draws rows y0 .. y1 − 1 of the picture as RGB565 words, full width, into `pixels`, which has exactly that size.
using DrawBand = std::function<void(int y0, int y1, std::span<std::uint16_t> pixels)>;

struct PanelOptions {
  std::uint32_t clock_hz = 0;                             ///< bus clock; 0 takes the panel's rated clock
  hal::PixelOrder drawn_order = hal::PixelOrder::native;  ///< how DrawBand leaves its words; turned round where needed
};

/// A panel at work: the real driver and present loop over a simulated bus into the panel's model.
class PanelSession {
 public:
  virtual ~PanelSession() = default;

  [[nodiscard]] virtual const PanelInfo& info() const = 0;

  /// Draws and sends one frame in bands of `band_height` rows (1 .. height, limited to that; the last band may be
  /// lower). The first frame initialises the panel.
  virtual hal::DisplayStatus show(int band_height, const DrawBand& draw) = 0;

  virtual hal::DisplayStatus sleep(bool asleep) = 0;

  /// What the viewer sees after the last frame.
  [[nodiscard]] virtual PanelPicture picture() const = 0;

  /// What the model found wrong since the session began.
  [[nodiscard]] virtual const std::vector<Complaint>& complaints() const = 0;

  /// Simulated times of the last frame: what it would take on a bus of that clock.
  [[nodiscard]] virtual const hal::PresentStatistics& statistics() const = 0;
};

/// Opens the panel of that name; nullptr if there is none. A clock that the panel does not tolerate shows as
/// bus_clock_too_high from show(), and as a complaint.
[[nodiscard]] std::unique_ptr<PanelSession> open_panel(std::string_view name, const PanelOptions& options = {});

/// The model alone, for bytes that come from elsewhere; nullptr if there is no panel of that name.
[[nodiscard]] std::unique_ptr<PanelModel> make_panel_model(std::string_view name);

}  // namespace spanline::sim
