#pragma once
#include <cstdint>
#include <vector>

#include "image/picture.hpp"
#include "panels/panel_registry.hpp"

namespace spanline::sim {

/// A panel on the desk: frames go through its real driver, and what its model decodes comes back.
class DeskPanel {
 public:
  explicit DeskPanel(const PanelInfo& info);
  /// `pixels` is RGB565 of the panel's size. Throws Failure if the driver fails or the model finds fault with it.
  [[nodiscard]] Picture show(const std::vector<std::uint16_t>& pixels, int band_lines);

 private:
  std::unique_ptr<PanelSession> session_;
};

}  // namespace spanline::sim
