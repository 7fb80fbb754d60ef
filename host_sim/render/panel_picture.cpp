#include "render/panel_picture.hpp"

#include <algorithm>
#include <cstring>

#include "base/failure.hpp"

namespace spanline::sim {

DeskPanel::DeskPanel(const PanelInfo& info) : session_(open_panel(info.name)) {}

Picture DeskPanel::show(const std::vector<std::uint16_t>& pixels, int band_lines) {
  const PanelInfo& info = session_->info();
  const std::string name(info.name);
  const auto width = static_cast<std::ptrdiff_t>(info.width);
  const hal::DisplayStatus status = session_->show(band_lines, [&](int y0, int y1, std::span<std::uint16_t> band) {
    std::copy(pixels.begin() + y0 * width, pixels.begin() + y1 * width, band.begin());
  });
  for (const Complaint& complaint : session_->complaints())
    if (severity(complaint.kind) == Severity::failure) throw Failure("panel " + name + ": " + describe(complaint));
  if (status != hal::DisplayStatus::ok) throw Failure("panel " + name + ": " + hal::to_string(status));
  const PanelPicture seen = session_->picture();
  Picture picture(seen.width, seen.height);
  static_assert(sizeof(Rgb888) == 3);
  std::memcpy(picture.pixels.data(), seen.rgb.data(), std::min(seen.rgb.size(), picture.pixels.size() * 3));
  return picture;
}

}  // namespace spanline::sim
